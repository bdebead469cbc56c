#!/usr/bin/python3
"""Rows of scripts/validate that need whole runs of the truss spar, 600 s each.

F4-*   the claim of the paper's Figure 4: platform steps of 0.5 and 1.0 s give the same motions
F4-i   the same with the paper's force at the end of each pass (information: what knocks in guides cost)
F4-p   order of the difference from 0.25, 0.5 and 1.0 s (information: the rods' own resampling of waves,
       of lower order, takes part in it)
AM-*   the paper's undamped Adams-Moulton rule beside the recommended generalised-alpha scheme, same force

Usage: validate_truss_spar.py HAWSER CASES-FOLDER
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

RAMP = 100.0  # s, of the case


def run(hawser, case, folder, *changes):
    command = [hawser, "run", str(case), "--out", str(folder), "--duration", "600", "--progress", "none", "-q"]
    for change in changes:
        command += ["--set", change]
    subprocess.run(command, check=True)
    with h5py.File(folder / "result.h5") as f:
        return {
            "t": f["/time"][:],
            "motion": f["/platform/spar/position"][:],
            "tension": f["/lines/end_a/effective_tension"][:],
            "cpu": float(np.asarray(f["/performance/cpu_per_second"])),
        }


def row(label, what, expected, got, tolerance):
    error = abs(got - expected)
    ok = error <= tolerance
    print(f"{label} | {what} | {expected:g} | {got:.4g} | {error:.4g} | {tolerance:g} | {'yes' if ok else 'NO'}")
    return ok


def rms_of_std(a, b, column):
    """rms difference of a against b on b's times after the ramp, % of b's standard deviation."""
    at = np.searchsorted(a["t"], b["t"] - 1e-9)
    late = b["t"] >= RAMP
    x, y = a["motion"][at][late, column], b["motion"][late, column]
    return 100 * math.sqrt(np.mean((x - y) ** 2)) / y.std()


def main():
    hawser, cases = sys.argv[1], Path(sys.argv[2])
    case = cases / "truss_spar" / "truss_spar.yml"
    good = True
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        step = {
            D: run(hawser, case, scratch / f"step{D}", f"analysis.dynamics.steps.platform={D} s")
            for D in (0.25, 0.5, 1.0)
        }
        for name, column in (("surge", 0), ("heave", 2), ("pitch", 4)):
            coarse = rms_of_std(step[0.5], step[1.0], column)
            fine = rms_of_std(step[0.25], step[0.5], column)
            good &= row(f"F4-{name}", f"{name}, platform step 0.5 against 1.0 s, rms difference, % of std", 0, coarse, 0.3)
            print(f"F4-p-{name}: order between 0.25, 0.5 and 1.0 s: {math.log2(coarse / fine):.1f} ({fine:.4f} %, {coarse:.4f} %)")
        force = "analysis.dynamics.coupling.force="
        ends = [
            run(hawser, case, scratch / f"ends{D}", f"analysis.dynamics.steps.platform={D} s", force + "instantaneous")
            for D in (0.5, 1.0)
        ]
        for name, column in (("surge", 0), ("heave", 2), ("pitch", 4)):
            print(f"F4-i-{name}: with the force at the end of each pass {rms_of_std(*ends, column):.4f} %")
        paper = run(hawser, cases / "truss_spar" / "truss_spar_paper.yml", scratch / "paper", force + "impulse_matched")
        recommended = step[0.5]
        late = recommended["t"] >= RAMP
        held = recommended["tension"][late].std(0) > 0  # a free top above its tensioner has no tension
        a, b = paper["tension"][late][:, held], recommended["tension"][late][:, held]
        good &= row("AM-std", "std of end tensions, Adams-Moulton against generalised-alpha, largest change, %", 0,
                    100 * np.abs(a.std(0) / b.std(0) - 1).max(), 0.1)
        print(f"AM: largest difference of an end tension at any sample: {np.abs(a - b).max():.1f} N")
        print(f"user time of the time loop per simulated second, platform step 0.5 s: {recommended['cpu']:.4f} s")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
