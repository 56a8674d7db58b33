"""Instructions of a run, counted by callgrind, and in which files they are."""

import os
import re
import shutil
import subprocess
import sys

import runs

# Valgrind does not know all instructions of new processors, so heddle is built
# for any of them; with line numbers, by which inlined functions are told apart.
BUILD = os.path.join(runs.ROOT, "build-callgrind")
HEDDLE = os.path.join(BUILD, "heddle")

STATIC = re.compile(r"_GLOBAL__sub_I_|__static_initialization_and_destruction")

# A name stands behind its number where it is mentioned first: "fn=(7) name".
NAME = re.compile(r"(c?f[lien])=\((\d+)\)(?: (.*))?$")


def build():
    """Build a heddle that callgrind can run."""
    if shutil.which("valgrind") is None:
        sys.exit("benchmarks/skipped: there is no valgrind; install the package "
                 "'valgrind'.")
    log = os.path.join(BUILD, "build.log")
    os.makedirs(BUILD, exist_ok=True)
    with open(log, "w") as file:
        for command in (
                ["cmake", "-G", "Ninja", "-S", runs.ROOT, "-B", BUILD,
                 "-DCMAKE_BUILD_TYPE=Release", "-DHEDDLE_NATIVE=OFF",
                 "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_CXX_FLAGS=-g1"],
                ["cmake", "--build", BUILD, "--target", "heddle"]):
            if subprocess.call(command, stdout=file, stderr=file):
                sys.exit("benchmarks/skipped: the build failed; all of it is in "
                         f"{log}.")


def instructions(path):
    """Return the instructions in a file of callgrind, by the source file of the
    function and that of the line, which differ where a function was inlined.
    Static initialisation is left out: every run begins with it."""
    files, functions, result = {}, {}, {}
    file = line_file = function = ""
    is_call = False
    with open(path, errors="replace") as lines:
        for line in lines:
            match = NAME.match(line)
            if match:
                kind, number, name = match.groups()
                names = functions if kind.endswith("fn") else files
                if name is not None:
                    names[number] = os.path.normpath(name)
                if kind == "fn":
                    function, line_file = names[number], file
                elif kind == "fl":
                    file = line_file = names[number]
                elif kind in ("fi", "fe"):
                    line_file = names[number]
            elif line.startswith("calls="):
                is_call = True
            elif line[0].isdigit() or line[0] in "+-*":
                # The line after "calls=" is what the called function took.
                if not is_call and not STATIC.search(function):
                    key = file, line_file
                    result[key] = result.get(key, 0) + int(line.split()[-1])
                is_call = False
    return result


def count(name, scene, settings=(), more=()):
    """Compute a scene, with more options to heddle; return the Run and its
    instructions."""
    os.makedirs(runs.RESULTS, exist_ok=True)
    file = os.path.join(runs.RESULTS, name + ".callgrind")
    run = runs.run(name, scene, settings, program=[
        "valgrind", "--quiet", "--tool=callgrind",
        f"--callgrind-out-file={file}", HEDDLE, *more])
    if run.code != 0:
        sys.exit(f"benchmarks/skipped: heddle ended with exit code {run.code}; "
                 f"see {run.folder}/screen.txt.")
    return run, instructions(file)
