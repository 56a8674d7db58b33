"""The curves of a compression between plates, there and back."""

import json
import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D

from plotting.figures import save
from plotting.history import PLATES, read_history

# Plates that move by less than this part of their distance stand still.
STILL = 1e-9


def ways(distance):
    """Return the stretches (first row, last row, whether plates come nearer)
    of plates at these distances; two stretches share the row where they turn."""
    found = []
    for i, step in enumerate(np.diff(distance)):
        nearer = found[-1][2] if found else True
        if abs(step) > STILL * distance[i]:
            nearer = bool(step < 0.)
        if found and found[-1][2] == nearer:
            found[-1][1] = i + 1
        else:
            found.append([i, i + 1, nearer])
    return [tuple(way) for way in found]


def name_of(directory, stage):
    """Return what summary.json calls this stage."""
    path = os.path.join(directory, "summary.json")
    if not os.path.isfile(path):
        return f"stage {stage:g}"
    with open(path, encoding="utf-8") as file:
        return json.load(file)["stages"][int(stage)]["name"]


def draw(axes, x, y, distance, colour):
    """Nearer: full line and dots. Apart: dashed, and rings."""
    for first, last, nearer in ways(distance):
        rows = slice(first, last + 1)
        axes.plot(x[rows], y[rows], color=colour, marker="o", markersize=4,
                  linestyle="-" if nearer else "--",
                  markerfacecolor=colour if nearer else "white",
                  zorder=3 if nearer else 2)


def plot_compression(directory, folder):
    columns = read_history(directory)
    if columns is None or not all(name in columns for name in
                                  ("plate_distance", "plate_force", "stage")):
        return
    # Before plates are somewhere their distance is 0.
    distance = columns["plate_distance"][1]
    stage = columns["stage"][1]
    cases = [stage == number for number in np.unique(stage[distance > 0.])]
    cases = [rows for rows in cases if rows.sum() > 1]
    if not cases:
        return
    force = "plate_pressure" if "plate_pressure" in columns else "plate_force"
    along = [name for name in ("plate_distance", "plate_volume_fraction")
             if name in columns]

    figure, panels = plt.subplots(1, len(along), squeeze=False, sharey=True,
                                  figsize=(5.6 * len(along), 4.4),
                                  layout="constrained")
    for axes, name in zip(panels.flat, along):
        unit, x = columns[name]
        for i, rows in enumerate(cases):
            draw(axes, x[rows], columns[force][1][rows], distance[rows],
                 f"C{i}")
        axes.set_xlabel(f"{PLATES[name]} [{unit}]")
        axes.axhline(0., color="0.8", linewidth=0.8, zorder=0)
    panels.flat[0].set_ylabel(f"{PLATES[force]} [{columns[force][0]}]")

    lines = [Line2D([], [], color="0.3", marker="o", markersize=4,
                    label="plates come nearer"),
             Line2D([], [], color="0.3", marker="o", markersize=4,
                    linestyle="--", markerfacecolor="white",
                    label="plates part")]
    if len(cases) > 1:
        lines += [Line2D([], [], color=f"C{i}",
                         label=name_of(directory, stage[rows][0]))
                  for i, rows in enumerate(cases)]
    panels.flat[0].legend(handles=lines, frameon=False, fontsize=9)
    save(figure, folder, "compression.png")
