"""Figures on white: their style, scale bars, files."""

import os

import matplotlib.pyplot as plt
import numpy as np

DPI = 150

plt.rcParams.update({"font.size": 11,
                     "axes.titlesize": 12,
                     "axes.titleweight": "bold",
                     "axes.spines.top": False,
                     "axes.spines.right": False,
                     "axes.linewidth": 0.8,
                     "lines.linewidth": 1.6,
                     "savefig.facecolor": "white"})


def round_length(length):
    """Return 1, 2 or 5 times a power of ten, at most the length."""
    power = 10. ** np.floor(np.log10(length))
    return max(m * power for m in (1, 2, 5) if m * power <= length * 1.0001)


def show(axes, picture, title=None):
    """Put a picture into axes with its scale at the lower left."""
    height, width, _ = picture.pixels.shape
    axes.imshow(picture.pixels, interpolation="antialiased")
    axes.set_axis_off()
    if title:
        axes.set_title(title)

    bar = round_length(0.25 * width / picture.per_mm)
    y = height + 0.02 * width
    axes.plot([0, bar * picture.per_mm], [y, y],
              color="black", linewidth=2, clip_on=False,
              solid_capstyle="butt")
    axes.text((bar * picture.per_mm) + 0.01 * width, y, f"{bar:g} mm",
              va="center")
    axes.set_xlim(0, width)
    axes.set_ylim(height + 0.04 * width, 0)


def save(figure, folder, name):
    """Write beside and rename; say what was written."""
    path = os.path.join(folder, name)
    figure.savefig(path + ".part", format="png", dpi=DPI,
                   bbox_inches="tight", pad_inches=0.1)
    os.replace(path + ".part", path)
    plt.close(figure)
    print(path)


def one_picture(picture, title, folder, name):
    """Save a picture pixel by pixel, with title and scale around it."""
    picture = picture.cropped(picture.ink())
    height, width, _ = picture.pixels.shape
    full_height = height + 0.04 * width
    figure = plt.figure(figsize=(width / DPI, (full_height + 60) / DPI))
    axes = figure.add_axes((0, 0, 1, full_height / (full_height + 60)))
    show(axes, picture, title)
    save(figure, folder, name)
