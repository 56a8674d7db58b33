"""What scripts/plot and scripts/compare draw with: modules that read, render
and arrange."""

import os
import sys

PACKAGES = "python3-vtk9 python3-numpy python3-matplotlib xvfb"

try:
    import matplotlib

    matplotlib.use("Agg")
    import numpy  # noqa: F401
    import vtk  # noqa: F401
except ImportError as error:
    sys.exit(f"scripts/{os.path.basename(sys.argv[0])}: {error.name} is missing; "
             f"install the Debian packages {PACKAGES}.")


class PlotError(Exception):
    """What the user can mend, in one sentence."""
