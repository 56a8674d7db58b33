"""Rows of tables of errors: of each run the setting, what came out, the time.

They are kept in a file, so that tables and pictures need not wait for runs.
"""

import collections
import csv
import os

import numpy as np

import runs

FIELDS = ("series", "setting", "value", "result", "unknowns", "iterations",
          "cpu", "wall")


class Row(collections.namedtuple("Row", FIELDS)):
    """A run: the result is its error or, of the fabric, its force [N]; nan if
    it did not converge. Times are those of the whole process [s]."""

    @classmethod
    def of(cls, series, setting, value, run, measure):
        well = run.summary is not None and run.summary["status"] == "converged"
        unknowns = (run.summary["n_dofs"] +
                    3 * run.summary.get("n_matrix_nodes", 0)) if well else 0
        return cls(series, setting, str(value),
                   float(measure(run)) if well else np.nan,
                   unknowns,
                   run.sum("newton_iterations") if well else 0,
                   run.cpu, run.seconds)


def path(case):
    return os.path.join(runs.RESULTS,
                        f"error_against_time-{case.replace(' ', '_')}.csv")


def write(case, rows):
    """Write rows as they come; yield them."""
    os.makedirs(runs.RESULTS, exist_ok=True)
    with open(path(case), "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(FIELDS)
        for row in rows:
            table.writerow(row)
            file.flush()
            yield row


def read(case):
    """Return the rows of a case by their series, in order."""
    series = {}
    with open(path(case), newline="") as file:
        for fields in list(csv.reader(file))[1:]:
            row = Row(*fields[:3], *(float(field) for field in fields[3:]))
            series.setdefault(row.series, []).append(row)
    return series


def orders(rows, errors):
    """Return the observed order of each error after the one before, as text:
    with settings that are no numbers, or where there is no error, there is
    none."""
    result = ["-"]
    for i in range(1, len(rows)):
        try:
            ratio = float(rows[i].value) / float(rows[i - 1].value)
        except ValueError:
            ratio = 1.
        well = (ratio != 1. and errors[i] > 0. and errors[i - 1] > 0.)
        result.append(f"{np.log(errors[i - 1] / errors[i]) / abs(np.log(ratio)):.1f}"
                      if well else "-")
    return result
