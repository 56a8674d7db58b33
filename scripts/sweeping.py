"""The cases of a sweep over parameters, and what they came to."""

import csv
import glob
import hashlib
import itertools
import json
import os
import socket

from ply import parse_parameters

# Columns that are printed where they are not zero everywhere.
SHOWN = ("thickness", "warp_crimp", "weft_crimp", "fiber_volume_fraction",
         "warp_force_per_width", "weft_force_per_width",
         "shear_couple_per_area", "bending_moment_per_width",
         "plate_pressure")

OUTPUT_DIRECTORY = "Run/Output directory"

# Stages on the way to where tests begin: in the table, but not printed.
ON_THE_WAY = ("order", "approach")


class SweepError(Exception):
    """Something that the user can set right."""


def rounded(text):
    """Return a number with five digits, or a word."""
    try:
        return f"{float(text):.5g}"
    except (TypeError, ValueError):
        return text or "-"


def in_seconds(time):
    return "" if time is None else f"{time:.2f}"


def shortest(name, names):
    """Return the end of a path that tells it from others."""
    parts = name.split("/")
    for first in reversed(range(len(parts))):
        short = "/".join(parts[first:])
        if sum(f"/{other}".endswith(f"/{short}") for other in names) == 1:
            return short
    return name


class Variation:
    """A parameter and the values that it takes."""

    def __init__(self, text):
        name, equals, values = text.partition("=")
        self.name = name.strip()
        self.values = [value.strip() for value in values.split("|")]
        if not equals or "/" not in self.name:
            raise SweepError(f"'{text}' names no parameter; write --vary "
                             "'Section/Name = value | value'.")
        if len(set(self.values)) < len(self.values):
            raise SweepError(f"'{text}' has a value twice.")


def parse_settings(settings):
    """Return {"Section/Name": value} of "Section/Name=value"."""
    return {name.strip(): value.strip() for name, _, value in
            (setting.partition("=") for setting in settings)}


def digest(path):
    """Return the sha256 of what a file holds."""
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def named_files(values, folder=""):
    """Return {value: digest} of those values that name a file, or a folder with
    an initial configuration, as seen from a folder."""
    found = {}
    for value in values:
        path = os.path.join(folder, value)
        if value and os.path.isdir(path):
            path = os.path.join(path, "initial_configuration.h5")
        if os.path.isfile(path):
            found[value] = digest(path)
    return found


class Case:
    """One combination of values."""

    def __init__(self, number, folder, variations, values, common):
        self.number = number
        self.folder = os.path.join(folder, f"case-{number}")
        self.values = values
        self.settings = common + [f"{variation.name}={value}" for
                                  variation, value in zip(variations, values)]
        self.short = [f"{variation.short} = {value}"
                      for variation, value in zip(variations, values)]

    def in_words(self):
        return ", ".join(self.short)

    def summary(self):
        """Return summary.json, or None where there is none."""
        try:
            with open(os.path.join(self.folder, "summary.json"),
                      encoding="utf-8") as file:
                return json.load(file)
        except FileNotFoundError:
            return None

    def is_finished(self):
        summary = self.summary()
        return summary is not None and summary["status"] == "converged"

    def has_checkpoint(self):
        return bool(glob.glob(os.path.join(self.folder, "checkpoint",
                                           "step-*.h5")))

    def outcome(self, code):
        summary = self.summary()
        if summary is None or code in (1, 2):
            return (f"exit code {code}, see "
                    f"{os.path.join(self.folder, 'screen.txt')}")
        seconds = [stage["wall_time_s"]["total"]
                   for stage in summary["stages"]]
        words = summary["status"]
        # Run/Timing may be false.
        if None not in seconds:
            words += f", {sum(seconds):.0f} s"
        if summary["reason"]:
            words += f": {summary['reason']}"
        return words

    def rows(self):
        """Return {column: text} at the end of each stage."""
        summary = self.summary()
        if summary is None:
            return []
        try:
            with open(os.path.join(self.folder, "history.csv"), newline="",
                      encoding="utf-8") as file:
                head, *history = csv.reader(file)
        except (FileNotFoundError, ValueError):
            head, history = [], []
        rows = []
        for number, stage in enumerate(summary["stages"]):
            row = {"stage": stage["name"], "status": stage["status"],
                   "newton_iterations[-]": str(stage["newton_iterations"]),
                   "time[s]": in_seconds(stage["wall_time_s"]["total"])}
            last = [line for line in history
                    if line[head.index("stage[-]")] == str(number)][-1:]
            for line in last:
                for name, text in zip(head, line):
                    row.setdefault(name, text)
            rows.append(row)
        return rows


class Sweep:
    """All combinations of the values of some parameters of a scene."""

    def __init__(self, scene, vary, common, folder):
        self.scene = scene
        self.folder = folder
        self.variations = [Variation(text) for text in vary]
        names = [variation.name for variation in self.variations]
        if len(set(names)) < len(names):
            raise SweepError("a parameter is varied twice.")
        set_for_all = parse_settings(common)
        for name in names:
            if name in set_for_all:
                raise SweepError(f"'{name}' is varied, and set by --set; leave "
                                 "out one of them.")
        if OUTPUT_DIRECTORY in names:
            raise SweepError("each case has a folder of its own: "
                             f"'{OUTPUT_DIRECTORY}' cannot be varied.")
        for variation in self.variations:
            variation.short = shortest(variation.name, names)
        self.cases = [
            Case(number, folder, self.variations, values, common)
            for number, values in enumerate(itertools.product(
                *(variation.values for variation in self.variations)), 1)]
        try:
            with open(scene, encoding="utf-8", errors="replace") as file:
                entries = parse_parameters(file.read())
            # What the scene by itself has left is no input.
            entries.pop(OUTPUT_DIRECTORY, None)
            self.record = {
                "scene": os.path.basename(scene), "sha256": digest(scene),
                "files": {
                    **named_files(entries.values(), os.path.dirname(scene)),
                    **named_files(set_for_all.values()),
                    **named_files(value for variation in self.variations
                                  for value in variation.values)},
                "set": common,
                # In this order cases have their numbers.
                "vary": [[variation.name, variation.values]
                         for variation in self.variations]}
        except OSError as error:
            raise SweepError(f"'{error.filename}' cannot be read: "
                             f"{error.strerror}.") from None

    def chosen(self, number):
        """Return all cases, or the one of this number."""
        if number is None:
            return self.cases
        if not 1 <= number <= len(self.cases):
            raise SweepError(f"there is no case {number}; they are 1 to "
                             f"{len(self.cases)}.")
        return [self.cases[number - 1]]

    def begin(self):
        """Take the folder, unless another sweep has it."""
        path = os.path.join(self.folder, "sweep.json")
        if not os.path.exists(path):
            os.makedirs(self.folder, exist_ok=True)
            # Jobs of an array may begin at the same time: the first one counts.
            beside = self.beside(path)
            with open(beside, "w", encoding="utf-8") as file:
                json.dump(self.record, file, indent=2)
            try:
                os.link(beside, path)
            except FileExistsError:
                pass
            os.remove(beside)
        self.check_folder()

    def check_folder(self):
        """Throw SweepError unless the folder holds this sweep."""
        try:
            with open(os.path.join(self.folder, "sweep.json"),
                      encoding="utf-8") as file:
                same = json.load(file) == self.record
        except FileNotFoundError:
            raise SweepError(f"'{self.folder}' holds no sweep.") from None
        if not same:
            raise SweepError(
                f"'{self.folder}' holds a sweep of another scene, of other "
                "values or in another order, or a file that the scene names has "
                "changed: give another folder by -o, or remove that one.")

    @staticmethod
    def beside(path):
        """Return a name that no other job has."""
        return f"{path}.{socket.gethostname()}.{os.getpid()}.part"

    def rows(self):
        """Return the case and {column: text} of each stage of all cases."""
        return [(case, row) for case in self.cases for row in case.rows()]

    def write_table(self):
        """Write sweep.csv beside and rename."""
        rows = self.rows()
        columns = list(dict.fromkeys(
            name for _, row in rows for name in row))
        path = os.path.join(self.folder, "sweep.csv")
        beside = self.beside(path)
        with open(beside, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["case[-]"] + [variation.name for variation
                                           in self.variations] + columns)
            for case, row in rows:
                writer.writerow([case.number, *case.values] +
                                [row.get(name, "") for name in columns])
        os.replace(beside, path)
        print(path)

    def print_table(self, wanted):
        """Print the columns that are wanted, or those that say something."""
        rows = [(case, row) for case, row in self.rows()
                if row["stage"] not in ON_THE_WAY]
        names = list(dict.fromkeys(name for _, row in rows for name in row))
        by_short = {name.partition("[")[0]: name for name in names}
        wanted = [name.partition("[")[0] for name in wanted or ()]
        for name in wanted:
            if name not in by_short:
                raise SweepError(f"no case has a column '{name}'; they have "
                                 f"{', '.join(by_short)}.")
        columns = [by_short[name] for name in wanted or SHOWN
                   if name in by_short and
                   (wanted or any(float(row.get(by_short[name]) or 0.) != 0.
                                  for _, row in rows))]
        lines = [["case"] + [variation.short
                             for variation in self.variations] +
                 ["stage", "status", "time[s]"] + columns]
        for case, row in rows:
            lines.append([str(case.number), *case.values, row["stage"],
                          row["status"], row["time[s]"] or "-"] +
                         [rounded(row.get(name)) for name in columns])
        widths = [max(map(len, column)) for column in zip(*lines)]
        for line in lines:
            print("  ".join(text.ljust(width) for text, width
                            in zip(line, widths)).rstrip())

    def plot(self):
        """Draw the curves of the load cases, if there are any, into one
        picture."""
        # What draws is there once scripts/setup has run.
        from plotting.history import read_history
        from plotting.loading import draw_loading, load_cases
        curves = []
        for case in self.cases:
            columns = read_history(case.folder)
            found = load_cases(case.folder, columns) if columns else []
            for curve in found:
                curve.name = case.in_words() + (
                    f", {curve.name}" if len(found) > 1 else "")
            curves += found
        pictures = os.path.join(self.folder, "pictures")
        os.makedirs(pictures, exist_ok=True)
        draw_loading(curves, pictures)
