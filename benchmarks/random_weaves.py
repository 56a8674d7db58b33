"""Weaves whose parameters are drawn at random, all at once."""

import random

# Patterns, and how many yarns of each direction show all of them.
PATTERNS = {"plain": (2, 3, 4), "twill 1/2": (3, 4), "twill 2/2": (4,),
            "basket": (4,), "satin 5/2": (5,), "1 1 0; 0 1 1; 1 0 1": (3, 4)}

# Axial and shear modulus [MPa]: glass, carbon, a polymer.
MATERIALS = ((72400, 29672), (230000, 15000), (3000, 1100))


def yarns(draw, prefix, number, radius):
    """Return the settings of the yarns of one direction."""
    values = {"Number of yarns": number,
              "Bundles": draw.choice((1, 1, 2)),
              "Fibers per bundle": draw.randint(1, 8),
              "Fiber radius": radius,
              "Packing": draw.choice(("rows", "hexagonal")),
              "Packing spacing": draw.choice((2.02, 2.04, 2.2, 3)),
              "Packing perturbation": draw.choice((0.02, 0.02, 1)),
              "Packing seed": draw.randint(1, 50),
              "Twist": draw.choice((0, 0, 0.0006 / radius, 0.003 / radius))}
    return [f"{prefix}/{name}={value}" for name, value in values.items()]


def loading(draw, extent):
    """Return the settings of a test, of a fabric about as long [mm]."""
    kind = draw.choice(("biaxial tension", "uniaxial tension", "picture frame",
                        "simple shear", "bending", "held"))
    step = draw.choice((0.1, 0.25, 0.5))
    settings = [f"Fabric loading/Kind={kind}",
                f"Load stepping/Initial step={step}",
                f"Load stepping/Largest step={max(step, 0.25)}"]
    if "tension" in kind:
        settings += [f"Fabric loading/Strain={draw.choice((0.005, 0.02))}"]
    if kind in ("uniaxial tension", "bending"):
        settings += ["Fabric loading/Sides=held"]
    if kind in ("picture frame", "simple shear"):
        settings += [f"Fabric loading/Shear angles={draw.choice((5, 10))}"]
    if kind == "bending":
        curvature = draw.choice((0.1, 0.5)) / extent
        settings += [f"Fabric loading/Curvature={curvature}"]
    if kind == "held":
        settings += [f"Plates/Compression={draw.choice((0.05, 0.15))}*t"]
    return settings


def weave(seed):
    """Return the settings of the weave of this number."""
    draw = random.Random(seed)
    pattern = draw.choice(list(PATTERNS))
    number = draw.choice(PATTERNS[pattern])
    radius = draw.choice((0.0035, 0.01, 0.1))
    axial, shear = draw.choice(MATERIALS)
    element = draw.choice(("hermite", "director"))
    values = {"Weave/Pattern": pattern,
              "Weave/End length": draw.choice((0.7, 1, 1.5)),
              "Weave/Start": "crimped" if draw.random() < 0.9
                             else "interpenetrating",
              "Fiber/Element": element,
              "Fiber/Elements per fiber": number * draw.choice((6, 8, 10)),
              "Fiber/Axial modulus": axial,
              "Contact/Penetration threshold": draw.choice((0.05, 0.02, 0.005)),
              "Contact/Search distance": draw.choice((1, 2)),
              "Contact/Friction coefficient": draw.choice((0, 0.1, 0.3, 0.6)),
              "Initial configuration/Axial tension":
                  draw.choice((0.002, 0.006, 0.02)),
              "Initial configuration/Friction": draw.choice(("true", "false"))}
    if element == "director":
        values["Fiber/Shear modulus"] = shear
    settings = [f"{name}={value}" for name, value in values.items()]
    settings += yarns(draw, "Weave/Warp yarns", number, radius)
    if draw.random() < 0.5:
        settings += ["Weave/Weft yarns/Same as warp yarns=false"]
        settings += yarns(draw, "Weave/Weft yarns", number,
                          radius * draw.choice((0.7, 1, 1.5)))
    return settings + loading(draw, 20 * radius * number)
