"""The program that scripts start, and how."""

import os
import shutil
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LAUNCH = os.path.join(ROOT, "scripts", "launch")


def built():
    """Return the path of heddle, built if necessary."""
    for script, *arguments in (["setup"], ["build", "Release"]):
        subprocess.run([os.path.join(ROOT, "scripts", script), *arguments],
                       check=True)
    return os.path.join(ROOT, "build", "heddle")


def given(path):
    """Return the path of a program that is taken as it is, or found by its
    name."""
    found = shutil.which(path)
    if found is None:
        raise OSError(f"'{path}' is no program: name one by --program, or leave "
                      "it out.")
    return found


def default_folder(kind, scene):
    """Return where results of a kind of a scene go unless it is said."""
    name = os.path.splitext(os.path.basename(scene))[0]
    return os.path.join(ROOT, "output", f"{kind}-{name}")
