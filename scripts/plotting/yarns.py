"""The yarns that a run left: their fibers, their sections, what is measured."""

import os

import numpy as np

from plotting import PlotError
from plotting.tables import numbers, read_rows, read_table

# Places along a yarn at which its fibers are looked at together.
N_STATIONS = 41

# Straight pieces between two nodes.
N_PIECES = 8

# Of a section, by the names of yarns.csv, with units.
OF_SECTIONS = {"width": "mm", "height": "mm", "aspect_ratio": "-",
               "hull_area": "mm^2", "fiber_area": "mm^2",
               "volume_fraction": "-"}


class Yarn:
    """A yarn that runs towards larger x or y, whatever its file says.

    sections   {name: values} of yarns.csv, by station
    fibers     {number: points along it}, in the same direction
    radius     mean radius of the fibers [mm]
    """

    def __init__(self, kind, sections, fibers, radii):
        self.kind = kind
        self.sections = sections
        self.fibers = fibers
        self.radius = np.mean(radii)
        line = self.line()
        span = line[-1] - line[0]
        if span[np.abs(span).argmax()] < 0.:
            span = -span
            self.sections = {name: values[::-1]
                             for name, values in sections.items()}
            self.sections["station"] = 1. - self.sections["station"]
        for number, points in self.fibers.items():
            if (points[-1] - points[0]) @ span < 0.:
                self.fibers[number] = points[::-1]

    def path(self):
        """Return where the mean line passes through the sections [mm]."""
        return np.stack([self.sections[d] for d in "xyz"], axis=1)

    def line(self):
        """Return the same without sections that no fiber passes."""
        path = self.path()
        return path[np.isfinite(path).all(axis=1)]

    def whole_fibers(self):
        """Return the lines of fibers that run from end to end, as far as to a
        tenth of the yarn: others were lost on their way, or are spun."""
        line = self.line()
        span = line[-1] - line[0]
        allowed = 0.1 * (span @ span)
        return [points for points in self.fibers.values()
                if (points[0] - line[0]) @ span <= allowed
                and (line[-1] - points[-1]) @ span <= allowed]

    def whole(self, name):
        """Return a measure of the sections through all fibers."""
        return self.sections[name][self.sections["fibers_missing"] == 0]

    def places(self):
        """Return where whole fibers are across the yarn's axis: [fiber,
        station, coordinate] from it [mm]."""
        lines = np.array([resampled(points, N_STATIONS)
                          for points in self.whole_fibers()])
        axis = lines.mean(axis=0)
        tangent = np.gradient(axis, axis=0)
        tangent /= np.linalg.norm(tangent, axis=1)[:, None]
        arm = lines - axis
        along = np.einsum("fsd,sd->fs", arm, tangent)
        return arm - along[:, :, None] * tangent

    def migration(self):
        """Return how much its distance from the yarn's axis varies along a
        fiber: standard deviation over the root mean square of all, mean of
        the fibers."""
        distance = np.linalg.norm(self.places(), axis=2)
        return (distance / np.sqrt((distance ** 2).mean(axis=0))
                ).std(axis=1).mean()

    def neighbour_distances(self):
        """Return how far the nearest other one is, over the diameter, of each
        whole fiber at each station."""
        places = self.places()
        arms = places[:, None] - places[None]
        distance = np.linalg.norm(arms, axis=3)
        distance[np.diag_indices(len(places))] = np.inf
        return distance.min(axis=0).ravel() / (2. * self.radius)


def smooth(nodes):
    """Return points of the cubics through nodes whose tangents are those of the
    parabola through three neighbours."""
    if len(nodes) < 3:
        return nodes
    lengths = np.linalg.norm(np.diff(nodes, axis=0), axis=1)
    parameter = np.concatenate([[0.], np.cumsum(lengths)])
    tangents = np.gradient(nodes, parameter, axis=0, edge_order=2)
    t = np.arange(N_PIECES)[:, None] / N_PIECES
    r = 1. - t
    pieces = [r * r * (1. + 2. * t) * nodes[i] +
              t * t * (1. + 2. * r) * nodes[i + 1] +
              h * t * r * (r * tangents[i] - t * tangents[i + 1])
              for i, h in enumerate(lengths)]
    return np.concatenate(pieces + [nodes[-1:]])


def resampled(points, n):
    """Return n points at equal distances along a line."""
    pieces = np.linalg.norm(np.diff(points, axis=0), axis=1)
    lengths = np.concatenate([[0.], np.cumsum(pieces)])
    wanted = np.linspace(0., lengths[-1], n)
    return np.stack([np.interp(wanted, lengths, points[:, d])
                     for d in range(3)], axis=1)


def read_fibers(directory):
    """Return {yarn: (set, {fiber: smooth line}, [radius])} of
    centerlines.csv."""
    path = os.path.join(directory, "centerlines.csv")
    table = read_rows(path)
    if table is None:
        raise PlotError(f"there is no '{path}'; compute it with "
                        "Output/Centerlines and Output/Interval not 0.")
    head, rows = table
    if "yarn" not in head:
        raise PlotError(f"'{path}' does not say to which yarn fibers belong; "
                        "compute it with a column 'yarn' in its file of "
                        "centerlines, and with this version.")
    columns = {name: [row[head.index(name)] for row in rows]
               for name in ("fiber", "set", "yarn")}
    x, y, z, radius = (numbers(path, head, rows, head.index(name))
                       for name in ("x", "y", "z", "radius"))
    points = np.stack([x, y, z], axis=1)
    starts = [i for i in range(len(rows))
              if i == 0 or columns["fiber"][i] != columns["fiber"][i - 1]]
    yarns = {}
    for a, b in zip(starts, starts[1:] + [len(rows)]):
        if columns["yarn"][a]:
            yarn = yarns.setdefault(int(columns["yarn"][a]),
                                    (columns["set"][a], {}, []))
            yarn[1][int(columns["fiber"][a])] = smooth(points[a:b])
            yarn[2].append(radius[a])
    return yarns


def normal(yarns):
    """Return the horizontal direction across yarns, towards larger x or y."""
    x, y, _ = np.sum([yarn.line()[-1] - yarn.line()[0] for yarn in yarns],
                     axis=0)
    across = np.array([-y, x, 0.])
    return across * np.sign(across[np.abs(across).argmax()])


def read_yarns(directory):
    """Return the yarns of a run: those of each set side by side, in the order
    in which they lie there."""
    path = os.path.join(directory, "yarns.csv")
    table = read_table(path)
    if table is None:
        raise PlotError(f"there is no '{path}'; its run had no yarns, or "
                        "Output/Yarn stations was 0.")
    yarns = []
    for number, (kind, fibers, radii) in read_fibers(directory).items():
        rows = table["yarn"][1] == number
        yarns.append(Yarn(kind, {name: values[rows]
                                 for name, (_, values) in table.items()},
                          fibers, radii))
    across = {kind: normal([yarn for yarn in yarns if yarn.kind == kind])
              for kind in {yarn.kind for yarn in yarns}}
    return sorted(yarns, key=lambda yarn: (
        yarn.kind, yarn.line().mean(axis=0) @ across[yarn.kind]))
