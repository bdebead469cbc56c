"""What the Python programs of scripts/validate share: rows, runs of the program, harmonics of a series."""

import json
import math
import os
import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

REFERENCE = os.environ.get("HAWSER_REFERENCE")
MOTIONS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
good = True


def row(label, what, expected, got, tolerance, relative=True, scale=None, explained=None):
    """Prints id | what | expected | got | error | tolerance | ok. `scale`: the error is relative to it instead
    of the expected value. A row that is `explained` may miss by that much: tests/README.md says why."""
    global good
    error = got - expected
    if scale:
        error /= scale
    elif relative:
        error /= abs(expected)
    ok = bool(abs(error) <= tolerance)
    known = bool(explained is not None and abs(error) <= explained)
    good &= ok or known
    verdict = "yes" if ok else "NO, explained" if known else "NO"
    print(f"{label} | {what} | {expected:.7g} | {got:.7g} | {error:.2g} | {tolerance:.2g} | {verdict}", flush=True)


def skip(label, what):
    print(f"{label} | {what} | - | - | - | - | SKIPPED", flush=True)


def table(*path):
    """Columns of a reference file by name."""
    with open(Path(REFERENCE, *path)) as file:
        names = file.readline().strip().split(",")
        numbers = np.loadtxt(file, delimiter=",")
    return {name: numbers[:, i] for i, name in enumerate(names)}


class Program:
    """The program on case files; keys of the case as `changes`, a dot written as two underscores or the whole
    key as it is."""

    def __init__(self, hawser):
        self.hawser = hawser

    def command(self, name, case, changes, *more):
        command = [self.hawser, name, str(case), *more]
        for key, value in changes.items():
            command += ["--set", key.replace("__", ".") + "=" + str(value)]
        return command

    def run(self, case, **changes):
        return Result(self, case, changes)

    def asked(self, name, case, *more, **changes):
        """What `statics` or `modes` says, from its JSON."""
        done = subprocess.run(self.command(name, case, changes, "--json", *more), check=True, capture_output=True,
                              text=True)
        return json.loads(done.stdout)

    def hydro_cylinder(self, stem, *options):
        subprocess.run([self.hawser, "hydro", "cylinder", *options, "--out", str(stem), "-q"], check=True)


class Result:
    """Series of a run: motions in m and degrees, loads about the reference point."""

    def __init__(self, program, case, changes):
        with tempfile.TemporaryDirectory() as folder:
            command = program.command("run", case, changes, "--out", folder + "/run", "--progress", "none", "-q")
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode:
                raise RuntimeError(" ".join(command) + "\n" + done.stderr)
            with h5py.File(Path(folder, "run", "result.h5")) as f:
                self.t = f["time"][:]
                platform = f["platform"][next(iter(f["platform"]))]
                self.motion = dict(zip(MOTIONS, platform["position"][:].T))
                self.velocity = dict(zip(MOTIONS, platform["velocity"][:].T))
                self.loads = {name: item[:] for name, item in platform.get("loads", {}).items()}
                self.tension = f["lines/end_a/effective_tension"][:] if "lines/end_a/effective_tension" in f else None

    def harmonic(self, values, w, periods):
        """Complex amplitude X of Re(X e^{iwt}) over the last whole periods, beside a parabola in time."""
        late = self.t > self.t[-1] - periods * 2 * math.pi / w + 1e-9
        t = self.t[late]
        s = (t - t[0]) / (t[-1] - t[0])
        basis = np.column_stack([np.cos(w * t), -np.sin(w * t), np.ones_like(s), s, s * s])
        found = np.linalg.lstsq(basis, values[late], rcond=None)[0]
        return complex(found[0], found[1])

    def mean(self, values, w, periods):
        """Mean over the last whole periods, by trapezes."""
        begin = self.t[-1] - periods * 2 * math.pi / w
        t = np.concatenate([[begin], self.t[self.t > begin + 1e-9]])
        return np.trapz(np.interp(t, self.t, values), t) / (t[-1] - t[0])
