"""The curves of a fabric test: forces over strains, couples over angles, moments
over curvatures."""

import json
import os

import matplotlib.pyplot as plt
import numpy as np

from plotting.figures import save
from plotting.history import read_history

# Below this a direction was not pulled, or an angle not turned.
NOTHING = 1e-9


class LoadCase:
    """The rows of one stage of a fabric test."""

    def __init__(self, name, columns, rows):
        self.name = name
        self.columns = columns
        self.rows = rows

    def __getitem__(self, column):
        if column not in self.columns:
            return np.full(self.rows.sum(), np.nan)
        return self.columns[column][1][self.rows]

    def has(self, column):
        """Return whether a strain or angle became anything in this case."""
        values = self[column]
        return np.nanmax(np.abs(values), initial=0.) > NOTHING


def load_cases(directory, columns):
    """Return the stages that are load cases, by what they were measured."""
    path = os.path.join(directory, "summary.json")
    if "stage" not in columns or not os.path.isfile(path):
        return []
    with open(path, encoding="utf-8") as file:
        stages = json.load(file)["stages"]
    number = columns["stage"][1]
    cases = [LoadCase(stage["name"], columns, number == i)
             for i, stage in enumerate(stages)]
    return [case for case in cases
            if case.rows.any() and (case.has("warp_strain") or
                                    case.has("weft_strain") or
                                    case.has("shear_angle") or
                                    is_bent(case))]


def draw_tension(axes, cases, yarns):
    """Force per width over strain; dashed, what the matrix takes of it."""
    for i, case in enumerate(cases):
        strain = 100. * case[yarns + "_strain"]
        force = case[yarns + "_force_per_width"]
        axes.plot(strain, force, color=f"C{i}", marker="o", markersize=3,
                  label=case.name)
        draw_part_of_matrix(axes, strain, case, force,
                            yarns + "_force", yarns + "_matrix_force", i)
    axes.set_xlabel(f"strain of the {yarns} [%]")
    axes.set_ylabel("force per width [N/mm]")
    axes.set_title(yarns)


def draw_shear(axes, cases):
    """Couple over angle; dashed, what the matrix takes of it."""
    for i, case in enumerate(cases):
        angle = case["shear_angle"]
        couple = case["shear_couple_per_area"]
        axes.plot(angle, couple, color=f"C{i}", marker="o", markersize=3,
                  label=case.name)
        draw_part_of_matrix(axes, angle, case, couple,
                            "shear_couple", "shear_matrix_couple", i)
    axes.set_xlabel("shear angle [degrees]")
    axes.set_ylabel("couple per area [N/mm]")
    axes.set_title("shear")


def draw_bending(axes, cases):
    """Moment over curvature; dashed, what the matrix takes of it."""
    for i, case in enumerate(cases):
        curvature = case["bending_curvature"]
        moment = case["bending_moment_per_width"]
        axes.plot(curvature, moment, color=f"C{i}", marker="o", markersize=3,
                  label=case.name)
        draw_part_of_matrix(axes, curvature, case, moment, "bending_moment",
                            "bending_matrix_moment", i)
    axes.set_xlabel("curvature [1/mm]")
    axes.set_ylabel("moment per width [N]")
    axes.set_title("bending")


def draw_part_of_matrix(axes, x, case, whole, total, part, i):
    """The same share of the curve as the matrix has in the sum."""
    if not case.has(part):
        return
    with np.errstate(divide="ignore", invalid="ignore"):
        share = case[part] / case[total]
    axes.plot(x, share * whole, color=f"C{i}", linestyle="--",
              linewidth=1.2)


def plot_loading(directory, folder):
    columns = read_history(directory)
    draw_loading(load_cases(directory, columns) if columns else [], folder)


def draw_loading(cases, folder):
    """Draw the curves of load cases, of one run or of several, side by side by
    what they are."""
    bent = [case for case in cases if is_bent(case)]
    sheared = [case for case in cases if is_sheared(case)]
    pulled = [case for case in cases
              if not is_bent(case) and not is_sheared(case)]
    curves = []
    for yarns in ("warp", "weft"):
        shown = [case for case in pulled if case.has(yarns + "_strain")]
        if shown:
            curves.append((shown, lambda axes, shown, yarns=yarns:
                           draw_tension(axes, shown, yarns)))
    if sheared:
        curves.append((sheared, draw_shear))
    if bent:
        curves.append((bent, draw_bending))
    if not curves:
        return

    figure, panels = plt.subplots(1, len(curves), squeeze=False,
                                  figsize=(5.6 * len(curves), 4.4),
                                  layout="constrained")
    for axes, (shown, draw) in zip(panels.flat, curves):
        draw(axes, shown)
        axes.axhline(0., color="0.8", linewidth=0.8, zorder=0)
        axes.axvline(0., color="0.8", linewidth=0.8, zorder=0)
        axes.legend(frameon=False, fontsize=9)
    if any(case.has("warp_matrix_force") or case.has("shear_matrix_couple") or
           case.has("bending_matrix_moment") for case in cases):
        figure.supxlabel("dashed: in proportion to the forces on sides of the matrix",
                         fontsize=9)
    save(figure, folder, "loading.png")


def is_sheared(case):
    return np.nanmax(np.abs(case["shear_angle"]), initial=0.) > 0.1


def is_bent(case):
    return case.has("bending_curvature")
