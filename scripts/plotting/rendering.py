"""Surfaces into pixels, off screen, with the light that shows gaps."""

import atexit
import os
import shutil
import subprocess

import numpy as np
import vtk
from vtk.util import numpy_support

from plotting import PlotError

# Pictures are drawn larger by this factor and averaged: smooth outlines.
OVERSAMPLING = 2


def start_display():
    """Rendering needs a display: an invisible one of our own is the surest."""
    if shutil.which("Xvfb") is None:
        if os.environ.get("DISPLAY"):
            return
        raise PlotError("rendering needs a display or the Debian package "
                        "xvfb; install it by 'apt-get install xvfb'.")
    read_end, write_end = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end),
                               "-screen", "0", "320x240x24",
                               "-nolisten", "tcp", "-noreset"],
                              pass_fds=[write_end],
                              stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    os.close(write_end)
    with os.fdopen(read_end) as pipe:
        display = pipe.readline().strip()
    if not display:
        raise PlotError("the virtual display Xvfb does not start; try "
                        "'Xvfb :99' to see why.")
    os.environ["DISPLAY"] = ":" + display

    def stop():
        server.terminate()
        server.wait()

    atexit.register(stop)


class Picture:
    """Pixels of a scene, and how many of them make a millimetre."""

    def __init__(self, pixels, per_mm):
        self.pixels = pixels
        self.per_mm = per_mm

    def ink(self):
        """Return first and last row and column that are not white."""
        inked = (self.pixels < 0.995).any(axis=2)
        rows, columns = (np.flatnonzero(inked.any(axis=d)) for d in (1, 0))
        if len(rows) == 0:
            raise PlotError("nothing is left to be seen; choose another view.")
        return np.array([rows[0], rows[-1], columns[0], columns[-1]])

    def cropped(self, ink):
        """Return the picture without its margins, all but a few pixels."""
        margin = 12
        top, bottom, left, right = ink
        return Picture(self.pixels[max(0, top - margin):bottom + margin,
                                   max(0, left - margin):right + margin],
                       self.per_mm)


def render(surfaces, radius, box, view, size):
    """Draw coloured tubes of about that radius on white, in parallel
    projection."""
    append = vtk.vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(append.GetOutputPort())
    mapper.SetScalarModeToUseCellData()
    mapper.SetColorModeToDirectScalars()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToPhong()
    look.SetAmbient(0.22)
    look.SetDiffuse(0.80)
    look.SetSpecular(0.12)
    look.SetSpecularPower(25.)

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1., 1., 1.)
    renderer.AddActor(actor)
    pixel = aim(renderer, box, view, size)
    light_up(renderer)

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*[OVERSAMPLING * n for n in size])
    window.AddRenderer(renderer)
    window.Render()
    colors = averaged(pixels_of(window, vtk.VTK_RGB)) / 255.
    depth = pixels_of(window, vtk.VTK_ZBUFFER)[:, :, 0]
    near, far = renderer.GetActiveCamera().GetClippingRange()
    window.Finalize()

    # At an outline a pixel is partly fiber, partly white paper.
    is_fiber = (depth < 1.).astype(np.float32)
    inside = averaged(is_fiber)
    depth = averaged((near + (far - near) * depth) * is_fiber)
    depth /= np.maximum(inside, 1e-6)
    if view[1] > 10.:
        # A level plane recedes upwards: only heights above it count.
        slope = pixel / np.tan(np.radians(view[1]))
        depth += slope * np.arange(depth.shape[0])[:, None]
    light = np.ones_like(depth)
    for scale, strength in ((0.7, 0.45), (4., 0.30)):
        light -= strength * hollows(depth, inside, scale * radius, pixel)
    paper = (1. - inside)[:, :, None]
    colors = paper + (colors - paper) * light[:, :, None]
    return Picture(np.clip(colors, 0., 1.), 1. / pixel)


def aim(renderer, box, view, size):
    """Point the camera and fit the box; return the size of a pixel [mm]."""
    azimuth, elevation = np.radians(view)
    back = np.array([np.cos(elevation) * np.cos(azimuth),
                     np.cos(elevation) * np.sin(azimuth),
                     np.sin(elevation)])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.])
    up = np.cross(back, right)

    low, high = box
    corners = np.array([[x, y, z]
                        for x in (low[0], high[0])
                        for y in (low[1], high[1])
                        for z in (low[2], high[2])])
    middle = 0.5 * (low + high)
    half_width = np.abs((corners - middle) @ right).max()
    half_height = np.abs((corners - middle) @ up).max()
    scale = 1.03 * max(half_height, half_width * size[1] / size[0])

    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + 4. * np.linalg.norm(high - low) * back))
    camera.SetViewUp(*up)
    camera.SetParallelScale(scale)
    renderer.ResetCameraClippingRange()
    return 2. * scale / size[1]


def light_up(renderer):
    """A key light from above left, and weak ones where it leaves shadows."""
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    for position, intensity in (((-0.6, 0.9, 0.9), 0.55),
                                ((0.0, 0.0, 1.0), 0.38),
                                ((0.9, 0.1, 0.7), 0.20),
                                ((0.2, -0.8, 0.3), 0.10)):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0., 0., 0.)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def pixels_of(window, kind):
    """Return what the window shows: kind is colour or depth."""
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetInputBufferType(kind)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    values = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1, :, :3].astype(np.float32)


def averaged(values):
    """Bring what was drawn larger down to size."""
    parts = range(OVERSAMPLING)
    return sum(values[i::OVERSAMPLING, j::OVERSAMPLING]
               for i in parts for j in parts) / OVERSAMPLING ** 2


def blurred(image, radius):
    """Return an image under a Gaussian of that radius in pixels."""
    pad = int(3 * radius)
    padded = np.pad(image, pad)
    waves = np.hypot(np.fft.fftfreq(padded.shape[0])[:, None],
                     np.fft.rfftfreq(padded.shape[1])[None, :])
    smooth = np.fft.irfft2(np.fft.rfft2(padded) *
                           np.exp(-2. * (np.pi * radius * waves) ** 2),
                           s=padded.shape)
    return smooth[pad:-pad or None, pad:-pad or None]


def hollows(depth, inside, radius, pixel):
    """Return how far a pixel lies behind those around it, from 0 to 1.

    The depth map against its own blur (Luft, Colditz, Deussen 2006) darkens
    the gaps between fibers: without that a yarn looks flat.
    """
    radius_in_pixels = max(1., radius / pixel)
    weight = blurred(inside, radius_in_pixels)
    around = (blurred(depth * inside, radius_in_pixels) /
              np.maximum(weight, 1e-6))
    behind = np.maximum(depth - around, 0.) / (1.5 * radius)
    return 1. - np.exp(-behind ** 1.5)
