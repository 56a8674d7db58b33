"""Figures of the benchmarks."""

import os

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt

import runs

DPI = 80

# The first seven are told apart by those who do not see colours, too (Okabe and
# Ito).
COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
          "#000000", "#8c564b", "#999999", "#7a3fc0")
MARKERS = "osD^vP*X<>"

plt.rcParams.update({"font.size": 9,
                     "axes.titlesize": 10,
                     "axes.spines.top": False,
                     "axes.spines.right": False,
                     "lines.linewidth": 1.2,
                     "lines.markersize": 4,
                     "legend.fontsize": 7.5,
                     "legend.frameon": False,
                     "savefig.facecolor": "white"})


def figure(columns, rows=1):
    """Return a figure and its axes, in one list."""
    drawn, axes = plt.subplots(rows, columns, squeeze=False,
                               figsize=(3.6 * columns, 3. * rows))
    return drawn, list(axes.flat)


def save(drawn, name):
    """Write a figure into the folder of results; say where."""
    os.makedirs(runs.RESULTS, exist_ok=True)
    path = os.path.join(runs.RESULTS, name)
    drawn.tight_layout()
    drawn.savefig(path, dpi=DPI)
    plt.close(drawn)
    print(f"\n{os.path.relpath(path, runs.ROOT)}")
