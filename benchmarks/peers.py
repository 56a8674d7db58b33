"""The peers of benchmarks/side_by_side: whether they are there, and their runs."""

import json
import os
import shutil
import subprocess
import sys

import runs

DECKS = os.path.join(runs.ROOT, "benchmarks", "side_by_side_decks")

# Programs and the Debian packages that have them.
PACKAGES = {"yade": "yade", "ccx": "calculix-ccx"}


def fail(message):
    print(f"benchmarks/side_by_side: {message}", file=sys.stderr)
    sys.exit(2)


def install():
    """Install the packages of programs that are missing."""
    missing = [package for program, package in PACKAGES.items()
               if not shutil.which(program)]
    if not missing:
        return
    if os.geteuid() != 0 or not shutil.which("apt-get"):
        fail("--install needs Debian and root; have them installed by apt-get "
             "install " + " ".join(missing))
    get = ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q"]
    for step in (["update"],
                 ["install", "-y", "--no-install-recommends", *missing]):
        done = subprocess.run(get + step, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            fail(f"apt-get could not install {' '.join(missing)}: "
                 + done.stdout.strip().splitlines()[-1])


def present(program):
    """Return whether a program is there; say so if it is not."""
    if shutil.which(program):
        return True
    print(f"{program} is not there, its rows are left out: --install, or "
          f"apt-get install {PACKAGES[program]}.\n", flush=True)
    return False


class Finished:
    """A peer's run: what it found, its time on the processor and its memory."""

    def __init__(self, command, name, result):
        folder = os.path.join(runs.RESULTS, name)
        result = os.path.join(folder, result)
        if os.path.exists(result):
            os.remove(result)
        code, _, usage = runs.timed(command, folder, folder)
        if code != 0 or not os.path.exists(result):
            fail(f"{command[0]} failed, see {folder}/screen.txt")
        with open(result) as file:
            self.text = file.read()
        self.cpu = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024
        self.solving = None


def yade(name, script, case):
    """Run a script with a case; the run has what the script says of it."""
    folder = os.path.join(runs.RESULTS, name)
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "case.json"), "w") as file:
        json.dump(case, file)
    finished = Finished(["yade", "-n", "-x", "-j1", os.path.join(DECKS, script),
                         "case.json", "result.json"], name, "result.json")
    finished.result = json.loads(finished.text)
    finished.solving = finished.result["seconds"]
    return finished


def calculix(name, write):
    """Run the deck that write(path) makes; the run has its last line of results."""
    folder = os.path.join(runs.RESULTS, name)
    os.makedirs(folder, exist_ok=True)
    write(os.path.join(folder, "deck.inp"))
    finished = Finished(["ccx", "deck"], name, "deck.dat")
    finished.result = [float(number)
                       for number in finished.text.strip().splitlines()[-1].split()]
    return finished
