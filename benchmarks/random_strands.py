"""Verification scenes of a few fibers in contact whose discretisations, friction and
steps are drawn at random."""

import random

FOLDER = "prm/verification"

# Length of an element as shipped [mm], and whether friction has to hold the fibers
# together, which it does only where it acts on surfaces.
SCENES = {"capstan": (0.1, True), "capstan_turn": (0.1, True),
          "bundle_bending": (2, True), "bundle": (1.5, False),
          "crossing_bundles": (2, False), "crossing_grid": (2, False),
          "clamped_crossing": (2, False), "strand": (3, False)}


def scene(seed):
    """Return the parameter file and the settings of a scene."""
    draw = random.Random(seed)
    name = draw.choice(list(SCENES))
    length, held_by_friction = SCENES[name]
    element = "director"
    if not held_by_friction and name != "strand":
        element = draw.choice(("hermite", "director"))
    # The capstan is to slip everywhere, the bundle is not to burst.
    frictions = {"bundle_bending": (0.3, 0.4)}.get(
        name, (0.05, 0.1, 0.2, 0.3, 0.4) if held_by_friction
        else (0, 0.05, 0.1, 0.2, 0.3, 0.4))
    values = {"Centerlines/Element length": length * draw.uniform(0.5, 1.8),
              "Fiber/Element": element,
              "Contact/Friction coefficient": draw.choice(frictions),
              "Linear solver/Kind": draw.choice(("automatic", "fiber blocks"))}
    if element == "director":
        values["Fiber/Degree"] = draw.choice((1, 2, 3))
    if "crossing" in name:
        values["Contact/Penetration threshold"] = draw.choice((0.001, 0.005, 0.02))
    if not name.startswith("bundle"):
        step = draw.choice((0.05, 0.1, 0.2, 0.5))
        values["Load stepping/Initial step"] = step
        values["Load stepping/Largest step"] = step
    return f"{FOLDER}/{name}.prm", [f"{key}={value}"
                                    for key, value in values.items()]
