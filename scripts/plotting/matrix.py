"""Pictures of the matrix: its mesh, its deformation, and the fibers in it."""

import os

import matplotlib.cm
import matplotlib.colors
import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util import numpy_support

from plotting import PlotError
from plotting.fabric import drawn
from plotting.fibers import (bounds_of, last_of_stages, listed, radius_of,
                             read_pvd)
from plotting.figures import one_picture, save, show
from plotting.rendering import render
from plotting.surfaces import paint

# Of the mesh in a picture: plain cells, dark edges.
CELL_COLOR = (0.80, 0.86, 0.90)
EDGE_COLOR = (0.25, 0.30, 0.36)

# Edges are as thick as this part of a fiber's radius.
EDGE = 0.12


class MatrixFrame:
    """One entry of matrix.pvd."""

    def __init__(self, file, time, stage):
        self.file = file
        self.time = time
        self.stage = stage


def read_cells(path):
    """Return the hexahedra of one VTU file."""
    if not os.path.isfile(path):
        raise PlotError(f"'{path}' is listed in matrix.pvd but missing.")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    # Data are the same in all corners of a cell, which has its own in the file.
    to_cells = vtk.vtkPointDataToCellData()
    to_cells.PassPointDataOn()
    to_cells.SetInputConnection(reader.GetOutputPort())
    to_cells.Update()
    return to_cells.GetOutput()


def undeformed(grid):
    """Return the cells where the fibers were embedded."""
    points = numpy_support.vtk_to_numpy(grid.GetPoints().GetData())
    motion = numpy_support.vtk_to_numpy(
        grid.GetPointData().GetArray("displacement"))
    result = vtk.vtkUnstructuredGrid()
    result.DeepCopy(grid)
    result.GetPoints().SetData(
        numpy_support.numpy_to_vtk(points - motion, deep=True))
    return result


def skin(grid):
    """Return the surface of the cells; points at one place become one."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(joined(grid))
    surface.Update()
    result = vtk.vtkPolyData()
    result.DeepCopy(surface.GetOutput())
    return result


def joined(grid):
    """Return the cells with common corners: in the file each has its own."""
    append = vtk.vtkAppendFilter()
    append.MergePointsOn()
    append.ToleranceIsAbsoluteOff()
    append.SetTolerance(1e-9)
    append.AddInputData(grid)
    append.Update()
    return append.GetOutput()


def edges_of(surface, radius):
    """Return the edges of the cells of a surface, as thin tubes."""
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(surface)
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputConnection(edges.GetOutputPort())
    tubes.SetRadius(EDGE * radius)
    tubes.SetNumberOfSides(5)
    tubes.Update()
    result = vtk.vtkPolyData()
    result.DeepCopy(tubes.GetOutput())
    result.GetPointData().Initialize()
    result.GetCellData().Initialize()
    paint(result, EDGE_COLOR)
    return result


def box_of(surface):
    bounds = surface.GetBounds()
    return np.array(bounds[0::2]), np.array(bounds[1::2])


def common_box(boxes):
    return (np.min([box[0] for box in boxes], axis=0),
            np.max([box[1] for box in boxes], axis=0))


def plot_mesh(grid, radius, folder, options):
    surface = skin(undeformed(grid))
    box = box_of(surface)
    edges = edges_of(surface, radius)
    surface.GetPointData().Initialize()
    surface.GetCellData().Initialize()
    paint(surface, CELL_COLOR)
    one_picture(render([surface, edges], radius, box, options.view,
                       options.size),
                f"{grid.GetNumberOfCells()} cells", folder, "matrix-mesh.png")


def painted_by_stress(surface, colors):
    """Give each face the colour of the equivalent stress of its cell."""
    stress = stress_of(surface)
    rgb = (colors.to_rgba(stress)[:, :3] * 255).round().astype(np.uint8)
    surface.GetPointData().Initialize()
    surface.GetCellData().Initialize()
    data = numpy_support.numpy_to_vtk(rgb, deep=True)
    data.SetName("color")
    surface.GetCellData().SetScalars(data)


def stress_of(surface):
    """Return the equivalent stress of each face [MPa]."""
    return numpy_support.vtk_to_numpy(
        surface.GetCellData().GetArray("von_mises_stress")).copy()


def plot_deformed(frames, radius, folder, options):
    """The matrix at the end of each stage, coloured by equivalent stress."""
    surfaces = [skin(read_cells(frame.file)) for frame in frames]
    stresses = np.concatenate([stress_of(surface) for surface in surfaces])
    colors = matplotlib.cm.ScalarMappable(
        matplotlib.colors.Normalize(0., np.percentile(stresses, 99.) or 1.),
        "viridis")
    box = common_box([box_of(surface) for surface in surfaces])
    n_columns = min(len(surfaces), 2)
    n_rows = -(-len(surfaces) // n_columns)
    size = [int(n / n_columns) for n in options.size]
    pictures = []
    for surface in surfaces:
        painted_by_stress(surface, colors)
        pictures.append(render([surface], radius, box, options.view, size))
    inks = np.array([picture.ink() for picture in pictures])
    ink = [inks[:, 0].min(), inks[:, 1].max(),
           inks[:, 2].min(), inks[:, 3].max()]

    width = 11. / n_columns
    height = width * (ink[1] - ink[0]) / (ink[3] - ink[2]) + 0.6
    figure, panels = plt.subplots(n_rows, n_columns, squeeze=False,
                                  figsize=(11., height * n_rows),
                                  layout="constrained")
    for axes in panels.flat:
        axes.set_axis_off()
    for axes, frame, picture in zip(panels.flat, frames, pictures):
        show(axes, picture.cropped(ink), frame.stage)
    figure.colorbar(colors, ax=panels, shrink=0.6, extend="max",
                    label="von Mises stress of the matrix [MPa]")
    save(figure, folder, "matrix.png")


def plot_embedded(grid, fibers, folder, options):
    one_picture(embedded(grid, fibers, options.view, options.size),
                "fibers and half of the matrix", folder, "composite.png")


def embedded(grid, fibers, view, size, colors=None):
    """The fibers, and half of the matrix around them."""
    box = common_box([bounds_of(fibers), box_of(grid)])
    azimuth = np.radians(view[0])
    away = -np.array([np.cos(azimuth), np.sin(azimuth), 0.])
    plane = vtk.vtkPlane()
    plane.SetOrigin(*(0.5 * (box[0] + box[1])))
    plane.SetNormal(*away)

    # Whole cells, so that the mesh is seen.
    half = vtk.vtkExtractGeometry()
    half.SetInputData(joined(grid))
    half.SetImplicitFunction(plane)
    half.ExtractInsideOff()
    half.Update()
    surface = skin(half.GetOutput())
    radius = radius_of(fibers)
    edges = edges_of(surface, radius)
    surface.GetPointData().Initialize()
    surface.GetCellData().Initialize()
    paint(surface, CELL_COLOR)
    return render(drawn(fibers, colors) + [surface, edges], radius, box, view,
                  size)


def plot_matrix(directory, last_fibers, folder, options):
    """All pictures of the matrix, if the run has one."""
    path = os.path.join(directory, "matrix.pvd")
    # Before fibers are embedded the list is empty.
    if not os.path.isfile(path) or not listed(path):
        return
    frames = [MatrixFrame(*entry) for entry in read_pvd(path)]
    radius = radius_of(last_fibers)
    last = read_cells(frames[-1].file)
    plot_mesh(last, radius, folder, options)
    plot_embedded(last, last_fibers, folder, options)
    plot_deformed(last_of_stages(frames), radius, folder, options)
