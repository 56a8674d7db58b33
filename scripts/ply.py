"""The tests of a ply, and the constants that follow from them."""

import csv
import glob
import json
import os

# Work of the stress that was there before is the same for and back.
TESTS = ("warp", "weft", "shear", "shear_back")

# Fibers and ends that lie on each side, and the side of the matrix.
SIDES = (("warp", "first end", "x-"), ("warp", "last end", "x+"),
         ("weft", "first end", "y-"), ("weft", "last end", "y+"))


class PlyError(Exception):
    """Something that the user can set right."""


def parse_parameters(text):
    """Return {"Section/Name": value} of a parameter file."""
    values, sections = {}, []
    for line in text.splitlines():
        words = line.split("#")[0].split(None, 1)
        if not words:
            continue
        if words[0] == "subsection":
            sections.append(words[1].strip())
        elif words[0] == "end":
            sections.pop()
        elif words[0] == "set":
            name, _, value = words[1].partition("=")
            values["/".join(sections + [name.strip()])] = value.strip()
    return values


def check(parameters, free):
    """Throw PlyError unless these are of a scene of which tests can be made."""
    if parameters["Run/Scene"] != "weave":
        raise PlyError("the scene is none of section Weave.")
    for section in ("Supports", "Loads"):
        if any(name.startswith(section + "/") for name in parameters):
            raise PlyError(f"the scene has a section {section} of its own, and "
                           "tests of a ply have theirs: leave it out.")
    if free and parameters["Fiber/Element"] == "hermite":
        raise PlyError("with Fiber/Element = hermite a fabric cannot begin free "
                       "of stress: give --keep-stress, or choose 'director'.")


def read_json(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return json.load(file)


class Ply:
    """A settled weave and the block of matrix around it."""

    def __init__(self, parameters, settled, thickness):
        self.parameters = parameters
        self.settled = settled
        try:
            with open(os.path.join(settled, "parameters.prm"),
                      encoding="utf-8") as file:
                self.end_length = parse_parameters(
                    file.read())["Weave/End length"]
            self.summary = read_json(settled, "summary.json")
            self.measure(thickness)
        except FileNotFoundError as error:
            raise PlyError(f"there is no file '{error.filename}', which a run "
                           "that has settled leaves.") from None

    def measure(self, thickness):
        """Find the corners of the block, by the yarns and their distances."""
        if self.summary["status"] != "converged":
            raise PlyError(f"the run in '{self.settled}' has not come to its "
                           "end.")
        fibers = {}
        with open(os.path.join(self.settled, "centerlines.csv"), newline="",
                  encoding="utf-8") as file:
            for row in csv.DictReader(file):
                fibers.setdefault(row["fiber"], []).append(
                    (row["set"], float(row["radius"]),
                     [float(row[name]) for name in "xyz"]))
        results = self.summary["results"]
        self.lower, self.upper = [0.] * 3, [0.] * 3
        # Mean places of the first and last ends of warp along x, of weft along y.
        self.ends = []
        for i, across in enumerate(("weft", "warp")):
            half = 0.5 * self.n_yarns(across) * results[f"{across}_spacing[mm]"]
            places = [point[i] for points in fibers.values()
                      for kind, _, point in points if kind == across]
            middle = sum(places) / len(places)
            self.lower[i], self.upper[i] = middle - half, middle + half
            self.find_ends(i, fibers, half / self.n_yarns(across))
        # Ends beyond the block stand higher.
        within = [(radius, point) for points in fibers.values()
                  for _, radius, point in points
                  if all(self.lower[i] <= point[i] <= self.upper[i]
                         for i in range(2))]
        low = min(point[2] - radius for radius, point in within)
        high = max(point[2] + radius for radius, point in within)
        if thickness is None:
            thickness = high - low + 2. * float(
                self.parameters["Matrix/Coating thickness"])
        elif thickness < high - low:
            raise PlyError(f"--thickness {thickness:g} is less than that of "
                           f"the fibers, {high - low:.4g} mm; take more.")
        self.lower[2] = 0.5 * (low + high - thickness)
        self.upper[2] = self.lower[2] + thickness

    def find_ends(self, i, fibers, half_spacing):
        """Find where fibers of a set end, and say if it is far within the
        block."""
        kind = ("warp", "weft")[i]
        lines = [points for points in fibers.values() if points[0][0] == kind]
        first, last = (sum(points[end][2][i] for points in lines) / len(lines)
                       for end in (0, -1))
        self.ends.append((first, last))
        within = 0.5 * (self.extent(i) - abs(last - first))
        if within > 0.1 * half_spacing:
            print(f"Note: yarns have spread as they settled, and the {kind} ends "
                  f"{within:.3g} mm within the block: what is beyond is matrix "
                  "alone; more yarns make less of it.")

    def beginning(self):
        """Return the folder of the initial configuration, or the file of the last
        step if the fabric was loaded."""
        if self.summary["stages"][-1]["name"] in ("order", "approach",
                                                  "settle"):
            return self.settled
        steps = sorted(glob.glob(os.path.join(self.settled, "checkpoint",
                                              "step-*.h5")))
        if not steps:
            raise PlyError(f"the run in '{self.settled}' has left no checkpoint "
                           "of its last step (Output/Checkpoint interval).")
        return steps[-1]

    def n_yarns(self, kind):
        """Return how many yarns of a set there are; two have a distance."""
        same = self.parameters["Weave/Weft yarns/Same as warp yarns"] == "true"
        which = "Warp" if same else kind.capitalize()
        number = int(self.parameters[f"Weave/{which} yarns/Number of yarns"])
        if number < 2:
            raise PlyError(f"the scene has {number} yarn in its {kind}; a ply "
                           "needs at least 2 in each direction.")
        return number

    def extent(self, i):
        return self.upper[i] - self.lower[i]

    def places(self, i):
        """Return {support: place} along x or y, of the sides across it."""
        return {2 * i + 1: self.ends[i][0], 2 * i + 2: self.ends[i][1],
                2 * i + 5: self.lower[i], 2 * i + 6: self.upper[i]}

    def settings(self, test, strain, free):
        """Return the settings of a test, begun free of stress or not."""
        motion = {
            "warp": (f"{strain!r}*t*x", "0"),
            "weft": ("0", f"{strain!r}*t*y"),
            "shear": (f"{0.5 * strain!r}*t*y", f"{0.5 * strain!r}*t*x"),
            "shear_back": (f"{-0.5 * strain!r}*t*y",
                           f"{-0.5 * strain!r}*t*x")}[test]
        settings = [
            f"Restart/Initial configuration={self.beginning()}",
            f"Restart/Stress free={str(free).lower()}",
            f"Weave/End length={self.end_length}",
            "Fabric loading/Kind=none", "Plates/Compression=0",
            "Matrix/Enabled=true", "Matrix/Shape=block",
            "Matrix/Leave out cells inside yarns=false",
            "Load stepping/Initial step=1", "Load stepping/Largest step=1"]
        for name, corner in (("Lower", self.lower), ("Upper", self.upper)):
            settings.append(f"Matrix/{name} corner=" + ", ".join(
                repr(value) for value in corner))
        for i, (fibers, nodes, side) in enumerate(SIDES, 1):
            # What is pulled along one direction may slide along the other,
            # sheared it may not.
            moved = {name: formula for name, formula in zip("xy", motion)
                     if test.startswith("shear") or name == side[0]}
            for number, chosen in (
                    (i, {"Fibers": fibers, "Nodes": nodes,
                         "Displacement z": "0"}),
                    (i + 4, {"Fibers": "none", "Matrix sides": side})):
                for name, formula in moved.items():
                    chosen[f"Displacement {name}"] = formula
                settings += [f"Supports/Support {number}/{name}={value}"
                             for name, value in chosen.items()]
        return settings


def change(folder, column):
    """Return by how much a column of history.csv changed under the load."""
    with open(os.path.join(folder, "history.csv"), newline="",
              encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    before, after = (float(row[column]) for row in (rows[0], rows[-1]))
    return after - before


def work_of_strain(ply, folder, i):
    """Return what the forces along x or y do in an even strain along it, over
    that strain [N mm]: by where they act, for fibers do not end where the block
    does."""
    return sum(place * change(folder, f"support_{number}_force_{'xy'[i]}[N]")
               for number, place in ply.places(i).items())


def constants(ply, strain, folders):
    """Return the constants of a ply by the folders of its tests."""
    length, width, thickness = (ply.extent(i) for i in range(3))
    stiffness = [[work_of_strain(ply, folders[test], i) /
                  (strain * length * width)
                  for test in ("warp", "weft")] for i in range(2)]
    (a_11, a_12), (a_21, a_22) = stiffness
    of_shear = (sum(change(folders[test], "external_work[N*mm]")
                    for test in ("shear", "shear_back")) /
                (strain ** 2 * length * width))
    determinant = a_11 * a_22 - a_12 * a_21
    return {"E_1 [MPa]": determinant / (a_22 * thickness),
            "E_2 [MPa]": determinant / (a_11 * thickness),
            "nu_12 [-]": a_21 / a_22,
            "nu_21 [-]": a_12 / a_11,
            "G_12 [MPa]": of_shear / thickness,
            "thickness [mm]": thickness,
            "length [mm]": length,
            "width [mm]": width,
            "fiber_volume_fraction [-]":
                read_json(folders["warp"],
                          "summary.json")["ply_fiber_volume_fraction"],
            "A_11 [N/mm]": a_11,
            "A_12 [N/mm]": a_12,
            "A_21 [N/mm]": a_21,
            "A_22 [N/mm]": a_22,
            "A_66 [N/mm]": of_shear}
