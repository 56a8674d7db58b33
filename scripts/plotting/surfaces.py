"""Surfaces of fibers, and cuts through them."""

import numpy as np
import vtk
from vtk.util import numpy_support

from plotting.fibers import shade

N_SIDES = 24


def tube(fiber, n_sides=N_SIDES):
    """Return the closed surface of a fiber."""
    n = len(fiber.points)
    points = vtk.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(fiber.points, deep=True))
    lines = vtk.vtkCellArray()
    lines.InsertNextCell(n)
    for i in range(n):
        lines.InsertCellPoint(i)
    line = vtk.vtkPolyData()
    line.SetPoints(points)
    line.SetLines(lines)

    make = vtk.vtkTubeFilter()
    make.SetInputData(line)
    make.SetRadius(fiber.radius)
    make.SetNumberOfSides(n_sides)
    make.CappingOn()
    make.Update()
    return make.GetOutput()


def paint(surface, color):
    """Give all cells of a surface one colour."""
    rgb = np.tile((np.array(color) * 255).round().astype(np.uint8),
                  (surface.GetNumberOfCells(), 1))
    data = numpy_support.numpy_to_vtk(rgb, deep=True)
    data.SetName("color")
    surface.GetCellData().SetScalars(data)


def clipped(surface, planes, color):
    """Return the part of a tube in front of the planes, its cuts closed."""
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(surface)
    # Cap and side of a tube have points of their own at the same places.
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(triangles.GetOutputPort())
    clip = vtk.vtkClipClosedSurface()
    clip.SetInputConnection(clean.GetOutputPort())
    clip.SetClippingPlanes(planes)
    clip.SetScalarModeToColors()
    clip.SetBaseColor(*color)
    clip.SetClipColor(*shade(color, 1., 0.3))
    clip.Update()
    result = vtk.vtkPolyData()
    result.DeepCopy(clip.GetOutput())
    if result.GetCellData().GetScalars():
        result.GetCellData().GetScalars().SetName("color")
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(result)
    normals.SetFeatureAngle(50.)
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def outlines(surface, axis, station):
    """Return the polygons in which the plane cuts a tube, in that plane."""
    plane = vtk.vtkPlane()
    plane.SetOrigin(*[station if d == axis else 0. for d in range(3)])
    plane.SetNormal(*[1. if d == axis else 0. for d in range(3)])
    cut = vtk.vtkCutter()
    cut.SetCutFunction(plane)
    cut.SetInputData(surface)
    # Cap and side of a tube have points of their own at the same places.
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(cut.GetOutputPort())
    clean.ConvertLinesToPointsOff()
    join = vtk.vtkStripper()
    join.SetInputConnection(clean.GetOutputPort())
    join.SetMaximumLength(100000)
    join.JoinContiguousSegmentsOn()
    join.Update()

    lines = join.GetOutput()
    keep = [d for d in range(3) if d != axis]
    polygons = []
    for i in range(lines.GetNumberOfCells()):
        cell = lines.GetCell(i)
        if cell.GetNumberOfPoints() > 2:
            corners = numpy_support.vtk_to_numpy(cell.GetPoints().GetData())
            polygons.append(corners[:, keep].copy())
    return polygons
