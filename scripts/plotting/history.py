"""The columns of history.csv over the steps."""

import os
import sys

import matplotlib.pyplot as plt
import numpy as np

from plotting.figures import save
from plotting.tables import read_table


def read_history(directory):
    """Return {name: (unit, values)} of history.csv, empty columns left out."""
    return read_table(os.path.join(directory, "history.csv"))


# Beside those that are called so.
ENERGIES = ("external_work", "contact_hardening", "plate_hardening",
            "friction_stored", "friction_dissipated")

# What compression.png shows, not over the steps.
PLATES = {"plate_distance": "distance of the plates",
          "plate_force": "force on a plate",
          "plate_pressure": "pressure of the plates",
          "plate_volume_fraction": "fiber volume fraction between the plates"}


def comparable(name):
    """Return the name without a coordinate or the direction of yarns."""
    if name.startswith(("warp_", "weft_")):
        return "warp and weft" + name[4:]
    return name[:-2] if name.endswith(("_x", "_y", "_z")) else name


def panels_of(columns):
    """Group the columns: what is compared goes into one panel, and what is zero
    all the time into none."""
    groups = {"Residual": [], "Penetration over radius": [], "Contacts": [],
              "Penalty": [], "Energy": [], "Newton iterations": []}
    for name in columns:
        if name in ("step", "stage", "load_factor", *PLATES) or \
                not np.nan_to_num(columns[name][1]).any():
            continue
        if "residual" in name:
            group = "Residual"
        elif "penetration" in name:
            group = "Penetration over radius"
        elif "contact_elements" in name:
            group = "Contacts"
        elif "penalty" in name:
            group = "Penalty"
        elif "energy" in name or name in ENERGIES:
            group = "Energy"
        elif name == "newton_iterations":
            group = "Newton iterations"
        else:
            group = comparable(name).replace("_", " ").capitalize()
        groups.setdefault(group, []).append(name)
    return {group: names for group, names in groups.items() if names}


def plot_history(directory, folder):
    columns = read_history(directory)
    if columns is None or "step" not in columns:
        print("scripts/plot: no history.csv with rows, so no history.png",
              file=sys.stderr)
        return
    if len(columns["step"][1]) < 2:
        print("scripts/plot: history.csv has a single row, so no history.png",
              file=sys.stderr)
        return
    groups = panels_of(columns)
    step = columns["step"][1]
    stage = columns.get("stage", ("", np.zeros(len(step))))[1]

    n_columns = min(3, len(groups))
    n_rows = -(-len(groups) // n_columns)
    figure, panels = plt.subplots(n_rows, n_columns, squeeze=False,
                                  figsize=(4.4 * n_columns, 3.1 * n_rows),
                                  layout="constrained")
    for axes in panels.flat[len(groups):]:
        axes.set_axis_off()
    marker = "o" if len(step) <= 40 else None
    for axes, (title, names) in zip(panels.flat, groups.items()):
        for name in names:
            axes.plot(step, columns[name][1], marker=marker, markersize=3,
                      label=name.replace("_", " "))
        values = np.concatenate([columns[name][1] for name in names])
        values = values[~np.isnan(values)]
        # Decades are for what spans some.
        if (values > 0).all() and values.max() > 30. * values.min():
            axes.set_yscale("log")
        elif (values >= 0).all():
            axes.set_ylim(bottom=0)
        for change in np.flatnonzero(np.diff(stage)):
            axes.axvline(0.5 * (step[change] + step[change + 1]),
                         color="0.75", linewidth=0.8, zorder=0)
        unit = columns[names[0]][0]
        axes.set_title(title + (f" [{unit}]" if unit != "-" else ""))
        axes.set_xlabel("step")
        axes.xaxis.get_major_locator().set_params(integer=True)
        if len(names) > 1:
            axes.legend(frameon=False, fontsize=9)
    save(figure, folder, "history.png")
