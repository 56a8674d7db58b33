"""Fibers from the VTU files of a run: where they lie, whose they are."""

import colorsys
import os
import xml.etree.ElementTree

import numpy as np
import vtk
from vtk.util import numpy_support

from plotting import PlotError


class Fiber:
    """Points of one fiber on its centerline, and whose it is."""

    def __init__(self, number, points, radius, yarn, is_warp):
        self.number = number
        self.points = points
        self.radius = radius
        self.yarn = yarn
        self.is_warp = is_warp


class Frame:
    """One entry of fibers.pvd."""

    def __init__(self, file, time, stage):
        self.file = file
        self.time = time
        self.stage = stage
        self._fibers = None

    @property
    def fibers(self):
        if self._fibers is None:
            self._fibers = read_fibers(self.file)
        return self._fibers


def listed(path):
    """Return (file, time, stage) of the entries of a PVD file, if any."""
    try:
        entries = xml.etree.ElementTree.parse(path).getroot().iter("DataSet")
    except xml.etree.ElementTree.ParseError as error:
        raise PlotError(f"'{path}' cannot be read: {error}.") from None
    return [(os.path.join(os.path.dirname(path), entry.get("file")),
             float(entry.get("timestep")),
             entry.get("group") or "")
            for entry in entries]


def read_pvd(path):
    """Return the same of a file that must have entries."""
    entries = listed(path)
    if not entries:
        raise PlotError(f"'{path}' lists no files yet.")
    return entries


def read_series(directory):
    """Return the frames of a run in the order in which they were written."""
    path = os.path.join(directory, "fibers.pvd")
    if not os.path.isdir(directory):
        raise PlotError(f"there is no folder '{directory}'.")
    if not os.path.isfile(path):
        raise PlotError(f"'{directory}' holds no fibers.pvd: give the output "
                        "directory of a run that writes its fibers.")
    return [Frame(*entry) for entry in read_pvd(path)]


def read_fibers(path):
    """Return the fibers of one VTU file, in the order of their numbers."""
    if not os.path.isfile(path):
        raise PlotError(f"'{path}' is listed in fibers.pvd but missing.")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetNumberOfPoints() == 0:
        raise PlotError(f"'{path}' holds no fibers.")

    def array(name):
        data = grid.GetPointData().GetArray(name)
        if data is None:
            raise PlotError(f"'{path}' has no point data '{name}'.")
        return numpy_support.vtk_to_numpy(data)

    points = numpy_support.vtk_to_numpy(grid.GetPoints().GetData())
    points = points.astype(float)
    number = array("fiber_id").round().astype(int)
    radius = array("cross_section_radius")
    yarn = array("yarn_id").round().astype(int)
    is_warp = array("is_warp") > 0.5

    # The points of a fiber follow each other.
    begins = np.flatnonzero(np.diff(number, prepend=number[0] - 1))
    ends = np.append(begins[1:], len(number))
    fibers = [Fiber(number[a], points[a:b], radius[a], yarn[a], is_warp[a])
              for a, b in zip(begins, ends)]
    return sorted(fibers, key=lambda fiber: fiber.number)


def last_of_stages(frames):
    """Return the last frame of each stage, in the order of the stages."""
    last = {}
    for frame in frames:
        last[frame.stage] = frame
    return list(last.values())


def colors_of(fibers):
    """Warm hues for warp, cool ones for weft; neighbouring yarns differ.

    Fibers that belong to no yarn get a hue each.
    """
    def key(fiber):
        return (fiber.yarn, fiber.is_warp) if fiber.yarn >= 0 else fiber.number

    families = {}
    for fiber in fibers:
        families.setdefault(
            "fibers" if fiber.yarn < 0 else bool(fiber.is_warp),
            {})[key(fiber)] = None
    hues = {True: (0.02, 0.13), False: (0.50, 0.64), "fibers": (0., 0.9)}

    colors = {}
    for family, members in families.items():
        low, high = hues[family]
        for i, member in enumerate(members):
            # Light and dark alternate, the hue wanders.
            place = i / max(1, len(members) - 1)
            value = (0.92, 0.74)[i % 2]
            saturation = (0.55, 0.72)[i % 2]
            colors[member] = colorsys.hsv_to_rgb(low + (high - low) * place,
                                                 saturation,
                                                 value)
    return [colors[key(fiber)] for fiber in fibers]


def shade(color, towards, amount):
    """Mix a colour with white (1) or black (0)."""
    return tuple((1 - amount) * c + amount * towards for c in color)


def bounds_of(fibers):
    """Return the lower and the upper corner of the fibers."""
    low = np.min([f.points.min(axis=0) - f.radius for f in fibers], axis=0)
    high = np.max([f.points.max(axis=0) + f.radius for f in fibers], axis=0)
    return low, high


def radius_of(fibers):
    """Return the radius that most fibers have."""
    return float(np.median([fiber.radius for fiber in fibers]))


def yarn_middles(fibers, axis):
    """Return where the yarns that run across an axis have their middles."""
    places = {}
    for fiber in fibers:
        extent = np.ptp(fiber.points, axis=0)
        if fiber.yarn >= 0 and np.argmax(extent) != axis:
            places.setdefault(fiber.yarn, []).append(
                fiber.points[:, axis].mean())
    return sorted(np.mean(values) for values in places.values())


def middle_station(fibers, axis, keep_below=True):
    """Return the middle of the middle yarn, or of everything.

    Of two yarns in the middle, the one that leaves more on the kept side.
    """
    middles = yarn_middles(fibers, axis)
    if middles:
        n = len(middles)
        return middles[n // 2 if keep_below else (n - 1) // 2]
    low, high = bounds_of(fibers)
    return 0.5 * (low[axis] + high[axis])


def is_upright(fibers):
    """Return whether this is no fabric, but a strand or the like along z."""
    low, high = bounds_of(fibers)
    return (all(fiber.yarn < 0 for fiber in fibers)
            and np.argmax(high - low) == 2)
