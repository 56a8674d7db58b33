"""What the benchmarks share: runs of heddle, and what they came to."""

import glob
import json
import os
import subprocess
import time

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RESULTS = os.path.join(ROOT, "output", "benchmarks")
HEDDLE = os.path.join(ROOT, "build", "heddle")

# The ranks are the parallelism: one thread each.
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1",
               "OMP_NUM_THREADS": "1"}


def build():
    """Build heddle, if necessary."""
    subprocess.run([os.path.join(ROOT, "scripts", "build"), "Release"],
                   check=True)


def packing(number):
    """Return the settings of packing 0, as shipped, or of another one, with
    fibers shifted as far as their gaps allow."""
    return [] if number == 0 else ["Weave/Warp yarns/Packing perturbation=1",
                                   f"Weave/Warp yarns/Packing seed={number}"]


def timed(command, folder, place):
    """Run a command in a place, what it prints goes to the file screen.txt in a
    folder; return its exit code, wall time and resource usage."""
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "screen.txt"), "w") as screen:
        began = time.monotonic()
        process = subprocess.Popen(command, cwd=place, stdout=screen,
                                   stderr=subprocess.STDOUT, env=ENVIRONMENT)
        status, usage = os.wait4(process.pid, 0)[1:]
        seconds = time.monotonic() - began
    return os.waitstatus_to_exitcode(status), seconds, usage


class Run:
    """A run that has ended: its folder, exit code, summary, time and memory."""

    def __init__(self, folder, code, seconds, usage):
        self.folder = folder
        self.code = code
        self.seconds = seconds
        self.cpu = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024
        self.summary = None
        path = os.path.join(folder, "summary.json")
        if code not in (1, 2) and os.path.exists(path):
            with open(path) as file:
                self.summary = json.load(file)

    def lines(self):
        """Return the lines that heddle printed."""
        with open(os.path.join(self.folder, "screen.txt")) as screen:
            return screen.read().splitlines()

    @property
    def stages(self):
        return self.summary["stages"]

    def sum(self, entry):
        """Return the sum of a number over all stages."""
        return sum(stage[entry] for stage in self.stages)

    def seconds_of(self, section):
        """Return the wall time of a section, over all stages."""
        return sum(stage["wall_time_s"][section] for stage in self.stages)

    def history(self):
        """Return the columns of history.csv by name; empty entries are nan."""
        table = np.genfromtxt(os.path.join(self.folder, "history.csv"),
                              delimiter=",", dtype=str)
        numbers = np.where(table[1:] == "", "nan", table[1:]).astype(float)
        return dict(zip(table[0], numbers.T))

    def last_output(self, kind):
        """Return the last VTU file of a kind such as "fibers"."""
        number = self.stages[-1]["last_output"]
        return os.path.join(self.folder, kind, f"{kind}-{number:05}.vtu")

    def last(self):
        """Return the last row of the history by name."""
        return {name: column[-1] for name, column in self.history().items()}


def run(name, scene, settings=(), ranks=1, petsc=(), program=(HEDDLE,)):
    """Compute a scene with "Section/Name=value" settings; return a Run. The
    program is heddle with whatever is to go before it, of each rank."""
    folder = os.path.join(RESULTS, name)
    command = [*program, scene, "--output-directory", folder]
    if ranks > 1:
        command = ["mpirun", "-n", str(ranks), "--bind-to", "none",
                   "--oversubscribe", "--allow-run-as-root", "--quiet"] + command
    for setting in settings:
        command += ["--set", setting]
    if petsc:
        command += ["--petsc", *petsc]
    # A run that dies early must not pass for an older one.
    for file in glob.glob(os.path.join(folder, "summary.json")):
        os.remove(file)
    return Run(folder, *timed(command, folder, ROOT))
