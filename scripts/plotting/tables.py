"""Tables of a run: comma-separated values under a head with units."""

import csv
import os

import numpy as np

from plotting import PlotError


def read_rows(path):
    """Return the head and the rows of a table, or None if there is none."""
    if not os.path.isfile(path):
        return None
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return (rows[0], rows[1:]) if len(rows) > 1 else None


def numbers(path, head, rows, i):
    """Return column i as numbers, NaN where it is empty."""
    try:
        return np.array([float(row[i]) if row[i] else np.nan for row in rows])
    except (ValueError, IndexError):
        raise PlotError(f"'{path}' is no table of numbers in the column "
                        f"'{head[i]}'.") from None


def read_table(path):
    """Return {name: (unit, values)} of a table, empty columns left out."""
    table = read_rows(path)
    if table is None:
        return None
    head, rows = table
    columns = {}
    for i, title in enumerate(head):
        name, _, unit = title.partition("[")
        values = numbers(path, head, rows, i)
        if not np.isnan(values).all():
            columns[name] = (unit.rstrip("]"), values)
    return columns
