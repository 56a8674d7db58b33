"""What the benchmarks share: runs of heddle, and what they came to."""

import json
import os
import subprocess
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RESULTS = os.path.join(ROOT, "output", "benchmarks")

# The ranks are the parallelism: one thread each.
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1",
               "OMP_NUM_THREADS": "1"}


def build():
    """Build heddle, if necessary."""
    subprocess.run([os.path.join(ROOT, "scripts", "build"), "Release"],
                   check=True)


class Run:
    """A run that has ended: its folder, exit code, summary, time and memory."""

    def __init__(self, folder, code, seconds, usage):
        self.folder = folder
        self.code = code
        self.seconds = seconds
        self.cpu = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024
        self.summary = None
        if code not in (1, 2):
            with open(os.path.join(folder, "summary.json")) as file:
                self.summary = json.load(file)

    @property
    def stages(self):
        return self.summary["stages"]

    def sum(self, entry):
        """Return the sum of a number over all stages."""
        return sum(stage[entry] for stage in self.stages)

    def seconds_of(self, section):
        """Return the wall time of a section, over all stages."""
        return sum(stage["wall_time_s"][section] for stage in self.stages)


def run(name, scene, settings=(), ranks=1, petsc=()):
    """Compute a scene with "Section/Name=value" settings; return a Run."""
    folder = os.path.join(RESULTS, name)
    command = [os.path.join(ROOT, "build", "heddle"), scene,
               "--output-directory", folder]
    if ranks > 1:
        command = ["mpirun", "-n", str(ranks), "--bind-to", "none",
                   "--oversubscribe", "--allow-run-as-root", "--quiet"] + command
    for setting in settings:
        command += ["--set", setting]
    if petsc:
        command += ["--petsc", *petsc]
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "screen.txt"), "w") as screen:
        began = time.monotonic()
        process = subprocess.Popen(command, cwd=ROOT, stdout=screen,
                                   stderr=subprocess.STDOUT, env=ENVIRONMENT)
        status, usage = os.wait4(process.pid, 0)[1:]
        seconds = time.monotonic() - began
    return Run(folder, os.waitstatus_to_exitcode(status), seconds, usage)
