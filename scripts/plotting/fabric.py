"""Pictures of the fibers: whole, cut open, in sections, by stages."""

import matplotlib.collections
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np
import vtk

from plotting import PlotError
from plotting.fibers import (bounds_of, colors_of, is_upright, middle_station,
                             radius_of, shade, yarn_middles)
from plotting.figures import one_picture, save, show
from plotting.rendering import render
from plotting.surfaces import clipped, outlines, paint, tube

# Of the picture of one section or stage [inches].
TALLEST = 12.


def drawn(fibers, colors=None):
    """Return the painted tubes of the fibers."""
    surfaces = []
    for fiber, color in zip(fibers, colors or colors_of(fibers)):
        surface = tube(fiber)
        paint(surface, color)
        surfaces.append(surface)
    return surfaces


def plot_fabric(frame, folder, options):
    picture = render(drawn(frame.fibers), radius_of(frame.fibers),
                     bounds_of(frame.fibers), options.view, options.size)
    one_picture(picture, frame.stage, folder, "fabric.png")


def plot_cutout(frame, folder, options):
    one_picture(cut_open(frame.fibers, options.view, options.size),
                frame.stage, folder, "cutout.png")


def cut_open(fibers, view, size, colors=None):
    """Cut through the middles of two yarns, and look at the cuts."""
    low, high = bounds_of(fibers)
    azimuth = np.radians(view[0])
    planes = vtk.vtkPlaneCollection()
    box = [low.copy(), high.copy()]
    for axis, towards in ((0, np.cos(azimuth)), (1, np.sin(azimuth))):
        # What lies between the eye and the plane is taken away.
        side = -1. if towards > 0 else 1.
        station = middle_station(fibers, axis, keep_below=side < 0)
        plane = vtk.vtkPlane()
        plane.SetOrigin(*[station if d == axis else 0. for d in range(3)])
        plane.SetNormal(*[side if d == axis else 0. for d in range(3)])
        planes.AddItem(plane)
        box[1 if side < 0 else 0][axis] = station

    surfaces = []
    for fiber, color in zip(fibers, colors or colors_of(fibers)):
        inside = np.ones(len(fiber.points), dtype=bool)
        for axis in (0, 1):
            inside &= fiber.points[:, axis] > box[0][axis] - fiber.radius
            inside &= fiber.points[:, axis] < box[1][axis] + fiber.radius
        if inside.any():
            surfaces.append(clipped(tube(fiber), planes, color))
    return render(surfaces, radius_of(fibers), box,
                  (view[0], 0.75 * view[1]), size)


def default_stations(fibers, axis):
    """Through the middle of a yarn, between two yarns, and what is between.

    Of a strand along z at four places between its ends, and only along z.
    """
    if is_upright(fibers) != (axis == 2):
        return []
    if axis == 2:
        low, high = bounds_of(fibers)
        return list(np.linspace(low[2], high[2], 6)[1:5])
    middles = yarn_middles(fibers, axis)
    if len(middles) < 2:
        return [middle_station(fibers, axis)]
    i = (len(middles) - 1) // 2
    return list(np.linspace(middles[i], middles[i + 1], 5)[:4])


def check_stations(fibers, stations):
    low, high = bounds_of(fibers)
    for axis, name in enumerate("xyz"):
        for station in stations[name] or []:
            if not low[axis] <= station <= high[axis]:
                raise PlotError(f"the station {name} = {station:g} mm lies "
                                f"outside of the fibers, {low[axis]:.4g} to "
                                f"{high[axis]:.4g} mm.")


def draw_section(axes, fibers, tubes, axis, station):
    """Draw where a plane cuts the fibers: ellipses, and bands along it."""
    polygons, faces, edges = [], [], []
    for fiber, surface, color in zip(fibers, tubes, colors_of(fibers)):
        along = fiber.points[:, axis]
        if abs(along - station).min() > np.ptp(along) / 2 + fiber.radius:
            continue
        for polygon in outlines(surface, axis, station):
            polygons.append(polygon)
            faces.append(color)
            edges.append(shade(color, 0., 0.45))
    axes.add_collection(matplotlib.collections.PolyCollection(
        polygons, facecolors=faces, edgecolors=edges, linewidths=0.35))
    axes.set_aspect("equal")
    low, high = bounds_of(fibers)
    across, up = [d for d in range(3) if d != axis]
    pad = 0.02 * (high[across] - low[across])
    axes.set_xlim(low[across] - pad, high[across] + pad)
    axes.set_ylim(low[up] - pad / 2, high[up] + pad / 2)
    axes.set_xlabel(f"{'xyz'[across]} [mm]")
    axes.set_ylabel(f"{'xyz'[up]} [mm]")
    if high[across] - low[across] > 5. * (high[up] - low[up]):
        # Labels of a flat fabric's height lie above each other otherwise.
        axes.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(3))
    axes.xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(5))


def in_words(place, fibers):
    """Return a place [mm] in four digits, round-off left out."""
    extent = max(np.ptp(bounds_of(fibers), axis=0))
    return f"{round(place / extent, 9) * extent + 0.:.4g} mm"


def plot_sections(frame, folder, options):
    tubes = [tube(fiber, n_sides=36) for fiber in frame.fibers]
    low, high = bounds_of(frame.fibers)
    for axis, name in enumerate("xyz"):
        stations = options.stations[name]
        if stations is None:
            stations = default_stations(frame.fibers, axis)
        if not stations:
            continue
        across, up = [d for d in range(3) if d != axis]
        aspect = (high[across] - low[across]) / (high[up] - low[up])
        n_columns = 2 if aspect < 5. and len(stations) > 1 else 1
        n_rows = -(-len(stations) // n_columns)
        width = 11. / n_columns
        height = min(width / aspect, TALLEST)
        figure, panels = plt.subplots(n_rows, n_columns, squeeze=False,
                                      sharex=True, sharey=True,
                                      figsize=(11., (height + 0.5) * n_rows
                                               + 0.5),
                                      layout="constrained")
        for axes in panels.flat[len(stations):]:
            axes.set_axis_off()
        for axes, station in zip(panels.flat, stations):
            draw_section(axes, frame.fibers, tubes, axis, station)
            axes.set_title(f"{name} = {in_words(station, frame.fibers)}",
                           loc="left",
                           fontsize=11, fontweight="normal")
        for axes in panels.flat:
            axes.label_outer()
        figure.suptitle(frame.stage, fontweight="bold")
        save(figure, folder, f"sections-{name}.png")


def plot_stages(frames, folder, options):
    """For each stage what it looks like, and one section, at equal scales."""
    columns = min(len(frames), 4)
    rows = -(-len(frames) // columns)
    small = [int(0.6 * n) for n in options.size]
    boxes = [bounds_of(frame.fibers) for frame in frames]
    box = (np.min([b[0] for b in boxes], axis=0),
           np.max([b[1] for b in boxes], axis=0))
    pictures = [render(drawn(frame.fibers), radius_of(frame.fibers), box,
                       options.view, small)
                for frame in frames]
    inks = np.array([picture.ink() for picture in pictures])
    ink = [inks[:, 0].min(), inks[:, 1].max(),
           inks[:, 2].min(), inks[:, 3].max()]

    # Rows as high as their contents are at the width of a column.
    width, inner_width = 4.6, 3.9
    extent = box[1] - box[0]
    axis = 2 if is_upright(frames[-1].fibers) else 0
    across, up = [d for d in range(3) if d != axis]
    shapes = [(ink[1] - ink[0]) / (ink[3] - ink[2]),
              extent[up] / extent[across]]
    heights = [min(inner_width * shape, TALLEST) + 0.6
               for shape in shapes]
    figure, panels = plt.subplots(2 * rows, columns, squeeze=False,
                                  figsize=(width * columns,
                                           sum(heights) * rows),
                                  height_ratios=heights * rows,
                                  layout="constrained")
    for axes in panels.flat:
        axes.set_axis_off()
    for i, (frame, picture) in enumerate(zip(frames, pictures)):
        row, column = 2 * (i // columns), i % columns
        show(panels[row, column], picture.cropped(ink),
             f"{i + 1}  {frame.stage}")
        axes = panels[row + 1, column]
        axes.set_axis_on()
        tubes = [tube(fiber) for fiber in frame.fibers]
        station = middle_station(frames[-1].fibers, axis)
        draw_section(axes, frame.fibers, tubes, axis, station)
        axes.set_xlim(box[0][across], box[1][across])
        axes.set_ylim(box[0][up], box[1][up])
        axes.set_xlabel(f"{'xyz'[across]} [mm] at {'xyz'[axis]} = "
                        f"{in_words(station, frame.fibers)}")
        if column > 0:
            axes.set_ylabel("")
    save(figure, folder, "stages.png")
