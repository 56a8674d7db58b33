"""The force of the small woven fabric at 1 % strain in both directions, as each
part of its discretisation gets finer."""

import numpy as np

import runs
from closed_forms import ELEMENTS, NOTHING
from errors import Row

SCENE = "prm/tutorial/biaxial_tension.prm"
COMPOSITE = "prm/tutorial/composite.prm"

# The small fabric is as long as three distances of its yarns.
SPACINGS = 3


def elements(n):
    return [f"Fiber/Elements per fiber={n}"]


def threshold(value):
    return [f"Contact/Penetration threshold={value}"]


def steps(number):
    return [f"Load stepping/Initial step={1 / number!r}",
            f"Load stepping/Largest step={1 / number!r}"]


def hexahedra(columns, layers, degree=1):
    return [f"Matrix/Columns x={columns}", f"Matrix/Columns y={columns}",
            f"Matrix/Layers={layers}", f"Matrix/Degree={degree}"]


def packing(seed):
    return [f"Weave/Warp yarns/Packing seed={seed}"]


# 20 elements are those of the scene, 10 steps of 0.1 % those of the load.
BASE = ["Fabric loading/Strain=0.01"] + NOTHING + elements(20) + steps(10)
DIRECTOR = ELEMENTS["director 1"]

# Shifted by a fiftieth of what gaps allow, as shipped, or as far as they allow.
PACKINGS = (1, 2, 3)
SHIFTED = ["Weave/Warp yarns/Packing perturbation=1"]


def force(run):
    """Return the mean of the forces of warp and weft [N]."""
    last = run.last()
    return 0.5 * (last["warp_force[N]"] + last["weft_force[N]"])


# Series of full runs: initial configuration and load, each of its own.
WHOLE = (
    ("scatter, director 1", "packing",
     [(seed, DIRECTOR + packing(seed)) for seed in PACKINGS]),
    ("scatter, hermite", "packing",
     [(seed, ELEMENTS["hermite"] + packing(seed)) for seed in PACKINGS]),
    ("scatter, 28 elements", "packing",
     [(seed, DIRECTOR + elements(28) + packing(seed)) for seed in PACKINGS]),
    ("scatter, as gaps allow", "packing",
     [(seed, DIRECTOR + packing(seed) + SHIFTED) for seed in PACKINGS]),
    ("director 1", "elements",
     [(n, DIRECTOR + elements(n)) for n in (10, 14, 20, 28, 40, 56)]),
    ("director 2", "elements",
     [(n, ELEMENTS["director 2"] + elements(n)) for n in (7, 10, 14, 20, 28)]),
    ("hermite", "elements",
     [(n, ELEMENTS["hermite"] + elements(n)) for n in (10, 14, 20, 28, 40)]),
    ("contact density", "cells per interval",
     [(n, DIRECTOR + [f"Contact/Refinement={n}"]) for n in (1, 2, 3, 4)]),
    ("threshold", "penetration threshold",
     [(value, DIRECTOR + threshold(value))
      for value in (0.08, 0.04, 0.02, 0.01, 0.005)]),
)

# Series that start from one initial configuration, so that nothing else differs.
FROM_ONE = (
    ("load step", "steps to 1 %", SCENE,
     [(n, steps(n)) for n in (1, 2, 5, 10, 20, 40)]),
    ("equilibrium", "residual tolerance", SCENE,
     [(value, [f"Newton/Residual tolerance={value}"])
      for value in (5e-2, 1.5e-2, 5e-3, 5e-4, 5e-5)]),
    ("hexahedra, degree 1", "columns x layers", COMPOSITE,
     [(f"{c} x {l}", hexahedra(c, l))
      for c, l in ((8, 4), (12, 6), (16, 8), (24, 12), (32, 16))]),
    ("hexahedra, degree 2", "columns x layers", COMPOSITE,
     [(f"{c} x {l}", hexahedra(c, l, 2)) for c, l in ((8, 4), (12, 6))]),
)


def compute(_):
    """Run all series; yield the rows of their table."""
    def name(series, i):
        return f"fabric-{series}-{i}".replace(" ", "_").replace(",", "")

    first = None
    for series, setting, variants in WHOLE:
        for i, (value, settings) in enumerate(variants):
            run = runs.run(name(series, i), SCENE, BASE + settings)
            first = first or run
            yield Row.of(series, setting, value, run, force)

    start = [f"Restart/Initial configuration={first.folder}"]
    for series, setting, scene, variants in FROM_ONE:
        for i, (value, settings) in enumerate(variants):
            run = runs.run(name(series, i), scene,
                           BASE + DIRECTOR + start + settings)
            yield Row.of(series, setting, value, run, force)


# Series of one model have one reference: the finest mesh of the best element.
REFERENCES = {"director 1": "director 2"}


def with_errors(table):
    """Return the errors of all rows of a series over the force of the finest,
    nan for the reference itself."""
    result = {}
    for series, rows in table.items():
        if series.startswith("scatter"):
            continue
        finest = [row.result
                  for row in table[REFERENCES.get(series, series)]
                  if np.isfinite(row.result)]
        reference = finest[-1] if finest else np.nan
        result[series] = np.array([row.result / reference - 1. for row in rows])
    return result


def scatter(rows):
    """Return the range of the forces of packings, over their mean."""
    values = [row.result for row in rows if np.isfinite(row.result)]
    return np.ptp(values) / np.mean(values) if len(values) > 1 else np.nan
