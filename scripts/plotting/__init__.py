"""What scripts/plot draws with: modules that read, render and arrange."""

import sys

PACKAGES = "python3-vtk9 python3-numpy python3-matplotlib xvfb"

try:
    import matplotlib

    matplotlib.use("Agg")
    import numpy  # noqa: F401
    import vtk  # noqa: F401
except ImportError as error:
    sys.exit(f"scripts/plot: {error.name} is missing; install the Debian "
             f"packages {PACKAGES}.")


class PlotError(Exception):
    """What the user can mend, in one sentence."""
