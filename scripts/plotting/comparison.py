"""Two fabrics beside each other: numbers, paths of yarns, sections."""

import matplotlib.pyplot as plt
import numpy as np

from plotting import PlotError
from plotting.figures import save
from plotting.yarns import OF_SECTIONS

RUN, REFERENCE = "C0", "0.25"


class Motion:
    """The rigid motion that takes points as near as it can to others (least
    squares; W. Kabsch, 1976)."""

    def __init__(self, points=None, others=None):
        self.middle = self.to = np.zeros(3)
        self.turn = np.eye(3)
        if points is None:
            return
        self.middle, self.to = points.mean(axis=0), others.mean(axis=0)
        u, _, v = np.linalg.svd((points - self.middle).T @ (others - self.to))
        mirror = np.diag([1., 1., np.sign(np.linalg.det(u @ v))])
        self.turn = (u @ mirror @ v).T

    def __call__(self, points):
        return (points - self.middle) @ self.turn.T + self.to

    def angle(self):
        """Return by how much it turns [degrees]."""
        skew = self.turn - self.turn.T
        sine = 0.5 * np.linalg.norm([skew[2, 1], skew[0, 2], skew[1, 0]])
        return np.degrees(np.arctan2(sine, 0.5 * (np.trace(self.turn) - 1.)))

    def shift(self):
        """Return by how much it moves the middle of the points [mm]."""
        return self.to - self.middle


def match(yarns, others):
    """Refuse fabrics whose yarns do not correspond."""
    def kinds(list_of_yarns):
        found = [yarn.kind for yarn in list_of_yarns]
        return ", ".join(f"{found.count(kind)} of set '{kind}'"
                         for kind in sorted(set(found)))

    if kinds(yarns) != kinds(others):
        raise PlotError(f"the run has yarns {kinds(yarns)}, the reference "
                        f"{kinds(others)}; compare as many of each.")
    stations = {len(yarn.path()) for yarn in yarns + others}
    if len(stations) > 1:
        raise PlotError("yarns are measured at different numbers of stations, "
                        f"{sorted(stations)}; compute both with the same "
                        "Output/Yarn stations.")


def registration(yarns, others):
    """Return the motion that takes sections that both have to each other."""
    points, goals = (np.concatenate([yarn.path() for yarn in fabric])
                     for fabric in (yarns, others))
    both = np.isfinite(points + goals).all(axis=1)
    return Motion(points[both], goals[both])


def statistics(yarns):
    """Return {quantity: (unit, values)} of yarns of the same set."""
    values = {name: (unit, np.concatenate([yarn.whole(name)
                                           for yarn in yarns]))
              for name, unit in OF_SECTIONS.items()}
    values["crimp"] = ("-", np.array([yarn.sections["crimp"][0]
                                      for yarn in yarns]))
    thick = [yarn for yarn in yarns if len(yarn.whole_fibers()) > 1]
    if thick:
        values["neighbour_distance"] = (
            "-", np.concatenate([yarn.neighbour_distances()
                                 for yarn in thick]))
        values["migration"] = ("-", np.array([yarn.migration()
                                              for yarn in thick]))
    return values


def table(yarns, others):
    """Return rows: set, quantity, unit, mean and standard deviation of the
    run, those of the reference, difference of the means over the latter."""
    rows = []
    for kind in sorted({yarn.kind for yarn in yarns}):
        of_run, of_reference = (statistics([yarn for yarn in fabric
                                            if yarn.kind == kind])
                                for fabric in (yarns, others))
        for name in of_run:
            if name not in of_reference:
                continue
            unit, a = of_run[name]
            b = of_reference[name][1]
            if len(a) == 0 or len(b) == 0:
                continue
            mean = b.mean()
            rows.append((kind, name, unit, a.mean(), a.std(), mean, b.std(),
                         (a.mean() - mean) / mean if mean != 0. else np.nan))
    return rows


def distances_to_line(points, line):
    """Return how far points are from a chain of straight pieces."""
    starts, chords = line[:-1], np.diff(line, axis=0)
    arms = points[:, None] - starts[None]
    t = np.clip(np.einsum("psd,sd->ps", arms, chords) /
                (chords ** 2).sum(axis=1), 0., 1.)
    return np.linalg.norm(arms - t[:, :, None] * chords, axis=2).min(axis=1)


def path_distances(yarns, others, motion):
    """Return how far the axes of yarns lie from those of the reference [mm]."""
    return np.concatenate([
        distances_to_line(motion(yarn.line()), other.line())
        for yarn, other in zip(yarns, others)])


def fiber_distances(yarns, others, motion):
    """Return how far nodes lie from the fiber of the same number there [mm]."""
    distances = []
    for yarn, other in zip(yarns, others):
        if yarn.fibers.keys() != other.fibers.keys():
            raise PlotError("the fibers of run and reference have not the same "
                            "numbers in each yarn; leave out --fibers.")
        distances += [distances_to_line(motion(points), other.fibers[number])
                      for number, points in yarn.fibers.items()]
    return np.concatenate(distances)


def draw_section(axes, yarn, motion, color, origin, normal):
    """Draw circles where fibers pass the middle of their yarn."""
    across = np.cross([0., 0., 1.], normal)
    if np.linalg.norm(across) < 0.4:
        across = np.cross([0., 1., 0.], normal)
    across /= np.linalg.norm(across)
    up = np.cross(normal, across)
    for points in yarn.fibers.values():
        arms = motion(points) - origin
        heights = arms @ normal
        crossed = heights[:-1] * heights[1:] <= 0.
        if not crossed.any():
            continue
        i = int(np.argmax(crossed))
        t = heights[i] / (heights[i] - heights[i + 1])
        place = (1. - t) * arms[i] + t * arms[i + 1]
        axes.add_patch(plt.Circle((place @ across, place @ up), yarn.radius,
                                  fill=False, color=color))


def draw_sections(axes, yarn, other, motion):
    """Of both, in the plane across the middle of the reference."""
    path = other.line()
    middle = len(path) // 2
    normal = path[middle + 1] - path[middle - 1]
    normal /= np.linalg.norm(normal)
    draw_section(axes, other, Motion(), REFERENCE, path[middle], normal)
    draw_section(axes, yarn, motion, RUN, path[middle], normal)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_xlabel("across [mm]")
    axes.set_title(f"{other.kind or 'yarns'}: a section in the middle")


def draw_over_station(axes, name, unit, yarns, others):
    for list_of_yarns, color in ((others, REFERENCE), (yarns, RUN)):
        for yarn in list_of_yarns:
            axes.plot(yarn.sections["station"], yarn.sections[name],
                      color=color, linewidth=1.)
    axes.set_xlabel("place along the yarn, over its length")
    axes.set_title(name.replace("_", " ") +
                   ("" if unit == "-" else f" [{unit}]"))


def draw_heights(axes, yarns, others, motion):
    for yarn, other in zip(yarns, others):
        axes.plot(other.sections["station"], other.path()[:, 2],
                  color=REFERENCE, linewidth=1.)
        axes.plot(yarn.sections["station"], motion(yarn.path())[:, 2],
                  color=RUN, linewidth=1.)
    axes.set_xlabel("place along the yarn, over its length")
    axes.set_title("height of the axes [mm]")


def plot_comparison(yarns, others, motion, names, folder):
    """Draw a row for each set: a section, and what changes along yarns."""
    kinds = sorted({yarn.kind for yarn in yarns})
    figure, panels = plt.subplots(len(kinds), 4, squeeze=False,
                                  figsize=(17., 3.9 * len(kinds)),
                                  layout="constrained")
    for row, kind in zip(panels, kinds):
        pair = [[yarn for yarn in fabric if yarn.kind == kind]
                for fabric in (yarns, others)]
        middle = len(pair[0]) // 2
        draw_sections(row[0], pair[0][middle], pair[1][middle], motion)
        draw_heights(row[1], *pair, motion)
        draw_over_station(row[2], "aspect_ratio", "-", *pair)
        draw_over_station(row[3], "hull_area", "mm^2", *pair)
    lines = [plt.Line2D([], [], color=color) for color in (RUN, REFERENCE)]
    panels[0][1].legend(lines, names, frameon=False, fontsize=9)
    save(figure, folder, "comparison.png")
