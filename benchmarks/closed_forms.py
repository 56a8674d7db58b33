"""Scenes with known answers: meshes of each that get finer, and their errors."""

import numpy as np

import runs
from errors import Row

ELEMENTS = {"hermite": ["Fiber/Element=hermite"],
            **{f"director {degree}": ["Fiber/Element=director",
                                      f"Fiber/Degree={degree}"]
               for degree in (1, 2, 3)}}
DIRECTOR = [name for name in ELEMENTS if name.startswith("director")]
# Only the end is written, if anything.
LAST = ["Output/Interval=100000", "Output/Checkpoint interval=0"]
NOTHING = ["Output/Interval=0", "Output/Checkpoint interval=0"]


class Series:
    """Runs of one scene in which one setting gets finer."""

    def __init__(self, name, scene, measure, meshes, setting="elements"):
        self.name = name
        self.scene = scene
        self.measure = measure
        self.meshes = meshes
        self.setting = setting


def legendre(function, low, high):
    """Return the integral of a smooth function."""
    x, weight = np.polynomial.legendre.leggauss(80)
    half = 0.5 * (high - low)
    return half * np.sum(weight * function(low + half * (x + 1.)))


def elastica(load):
    """Return the tip (x, z) / L of a cantilever under P L^2 / EI = load."""
    root = np.sqrt(load)

    def parts(angle):
        """Modulus and lower limit of the elliptic integrals for the slope of
        the tip, and the length that goes with it."""
        p = np.sqrt(0.5 * (1. + np.sin(angle)))
        low = np.arcsin(np.sqrt(0.5) / p)
        return p, low, legendre(
            lambda q: 1. / np.sqrt(1. - (p * np.sin(q))**2), low, 0.5 * np.pi)

    below, above = 1e-6, 0.5 * np.pi - 1e-6
    for _ in range(60):
        angle = 0.5 * (below + above)
        p, low, length = parts(angle)
        below, above = ((angle, above) if length < root else (below, angle))
    second = legendre(lambda q: np.sqrt(1. - (p * np.sin(q))**2), low,
                      0.5 * np.pi)
    return np.sqrt(2. * np.sin(angle)) / root, 1. - 2. * second / root


def cantilever():
    """Tip of the elastica. A radius of L / 1000, so that stretch and shear,
    which it does not have, do not count; E I = 1e-6 as in the scene."""
    radius = 1e-3
    slender = [f"Centerlines/Radius={radius}", "Newton/Residual tolerance=1e-6",
               f"Fiber/Axial modulus={1e-6 / (0.25 * np.pi * radius**4)!r}"]
    x, z = elastica(10.)

    def error(run):
        last = run.last()
        return np.hypot(1. + last["load_1_displacement_x[mm]"] - x,
                        last["load_1_displacement_z[mm]"] - z)

    for name, use in ELEMENTS.items():
        yield Series(name, "cantilever", error, [
            (n, use + slender + NOTHING + [f"Centerlines/Element length={1 / n}"])
            for n in (4, 8, 16, 32, 64, 128, 256)])


def points(path, *names):
    """Return the coordinates and some data of the points of a VTU file."""
    # Imported here: the other scenes do without VTK.
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    return (vtk_to_numpy(grid.GetPoints().GetData()).astype(float),
            *(vtk_to_numpy(grid.GetPointData().GetArray(name)).astype(float)
              for name in names))


def twisted_pair():
    """Force per length in the middle half of two rods of one turn (Meier, Popp
    and Wall 2016, see prm/verification/double_helix.prm): of the mesh, that of
    the helix found; of the threshold, that of rods that do not penetrate."""
    radius, length = 0.0095, 5.
    height = length + 0.0496472226
    axial, bending = 309501.27, 7.8539816

    def closed_form(r, angle, rise, reference):
        arc = np.hypot(rise, r * angle)
        stretch, turning = arc / reference, angle / arc
        curvature, torsion = r * turning**2, turning * rise / arc
        force = 0.5 * axial * stretch * (stretch**2 - 1.)
        return stretch * (force * curvature
                          + bending * curvature * stretch * torsion**2)

    def pressure(run):
        place, force, weight = points(run.last_output("contacts"),
                                      "normal_force", "weight")
        middle = np.abs(place[:, 2] - 0.5 * height) < 0.25 * height
        return force[middle].sum() / weight[middle].sum()

    def error_of_mesh(run):
        place, fiber, arc = points(run.last_output("fibers"),
                                   "fiber_id", "arc_length")
        own = fiber == fiber.min()
        low, high = (place[own][np.argmin(np.abs(arc[own] - s * length))]
                     for s in (0.25, 0.75))
        angle = np.arctan2(high[1], high[0]) - np.arctan2(low[1], low[0])
        found = closed_form(np.hypot(low[0], low[1]), angle % (2. * np.pi),
                            high[2] - low[2], 0.5 * length)
        return abs(pressure(run) / found - 1.)

    def error_of_threshold(run):
        whole = closed_form(radius, 2. * np.pi, height, length)
        return abs(pressure(run) / whole - 1.)

    # The director element has its ends free to turn: what they do there has
    # faded where the force is measured.
    for name, use in ELEMENTS.items():
        free = [] if name == "hermite" else [
            f"Supports/Support {i}/Held tangent components=" for i in (1, 2)]
        yield Series(name, "double_helix", error_of_mesh, [
            (n, use + free + LAST + [f"Centerlines/Element length={length / n}"])
            for n in (4, 8, 16, 32, 64)])
    yield Series("hermite, threshold", "double_helix", error_of_threshold, [
        (threshold, LAST + [f"Contact/Penetration threshold={threshold}"])
        for threshold in (0.04, 0.02, 0.01, 0.005, 0.0025)],
        "penetration threshold")


def capstan():
    """Exponent of the ratio of the tensions of half a turn, friction 0.3 on the
    surface (doc/theory.md, 2.5). The torsion-free element has no friction there."""
    coefficient, x = 0.3, 0.01 / 1.01
    exponent = ((np.sqrt(1. + 4. * x * (1. - x) * coefficient**2) - 1.)
                / (2. * x * coefficient)) * np.pi

    def error(run):
        ratio = abs(run.last()["support_3_force_z[N]"]) / 0.1
        return abs(np.log(ratio) / exponent - 1.)

    for name in DIRECTOR:
        yield Series(name, "capstan", error, [
            (size, ELEMENTS[name] + NOTHING +
             [f"Centerlines/Element length={size}"])
            for size in (0.4, 0.2, 0.1, 0.05, 0.025)], "element length / drum")


def spring_bed():
    """Mean strain of a fiber in a matrix of prescribed strain."""
    # Tolerances of the scene are below round-off in the finest meshes.
    tight = ["Newton/Residual tolerance=1e-5", "Newton/Increment tolerance=1e-6"]
    half = 50. * np.sqrt(12. / (1e5 * np.pi * 0.1**2))
    exact = 1e-5 * (1. - np.tanh(half) / half)

    def error(run):
        last = run.last()
        strain = (last["load_2_displacement_x[mm]"]
                  - last["load_1_displacement_x[mm]"]) / 100.
        return abs(strain / exact - 1.)

    for links, where in ((0, "links in nodes"), (2, "2 links per element")):
        for name, use in ELEMENTS.items():
            yield Series(f"{name}, {where}", "spring_bed", error, [
                (n, use + tight + NOTHING +
                 [f"Centerlines/Element length={100 / n}",
                  f"Matrix/Coupling points per element={links}"])
                for n in (5, 10, 20, 40, 80, 160)])


CASES = {"cantilever": cantilever, "twisted pair": twisted_pair,
         "capstan": capstan, "spring bed": spring_bed}


def compute(case):
    """Run all meshes of a case; yield the rows of its table."""
    for series in CASES[case]():
        for i, (value, settings) in enumerate(series.meshes):
            run = runs.run(
                f"{case}-{series.name}-{i}".replace(" ", "_").replace(",", ""),
                f"prm/verification/{series.scene}.prm", settings)
            yield Row.of(series.name, series.setting, value, run, series.measure)
