#!/usr/bin/python3
"""Random small cases through `hawser check --statics` and `hawser run`: each must end by itself, with a
code that README.md names and a message, never with a bug (1), a signal or a NaN.

usage: fuzz_cases.py HAWSER [FIRST [COUNT]] [-v]      seeds FIRST ... FIRST + COUNT - 1 (1, 50); -v: all that is said

Prints `seed | what it is | check | run | ok` and, of those that are wrong, what was said; keeps their case
files in the current folder. Returns 1 if there are any.
"""

import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy

LIMIT = 120  # s
ENDS_WELL = {0, 3, 4, 5}


def length(r, low, high):
    return f"{low * (high / low) ** r.random():.4g} m"


def environment(r, depth):
    sea = {"seabed": {"depth": f"{depth:.5g} m", "normal_stiffness": f"{10 ** r.uniform(3, 7):.3g} N/m2",
                      "damping": f"{r.choice([0, 1, 10, 100])} kN.s/m2"}}
    if r.random() < 0.3:
        sea["seabed"]["slope"] = {"angle": f"{r.uniform(0, 10):.3g} deg", "direction": f"{r.uniform(0, 360):.4g} deg"}
    sea["seabed"]["friction"] = {"axial": r.choice([0, 0.3, 2]), "lateral": r.choice([0, 0.5, 2])}
    if r.random() < 0.6:
        heading = f"{r.uniform(0, 360):.4g} deg"
        if r.random() < 0.5:
            sea["waves"] = [{"type": "airy", "H": f"{r.uniform(0.1, 0.1 * depth if depth < 100 else 20):.3g} m",
                             "T": f"{r.uniform(4, 20):.3g} s", "heading": heading}]
        else:
            sea["waves"] = [{"type": "jonswap", "Hs": f"{r.uniform(0.1, min(16, 0.1 * depth)):.3g} m",
                             "Tp": f"{r.uniform(4, 18):.3g} s", "heading": heading, "seed": r.randrange(1000)}]
    if r.random() < 0.6:
        sea["current"] = {"heading": f"{r.uniform(0, 360):.4g} deg",
                          "profile": [["0 m", f"{r.uniform(0, 2.5):.3g} m/s"], [f"{depth:.5g} m", "0 m/s"]]}
    if r.random() < 0.2:
        sea["wind"] = {"spectrum": "npd", "speed": f"{r.uniform(1, 50):.3g} m/s", "heading": "30 deg", "seed": 3}
    return sea


def line_types(r):
    d = r.uniform(0.04, 0.18)
    across = r.uniform(0.05, 0.3)
    rope = {"category": "rope", "nominal_diameter": f"{1e3 * across:.4g} mm",
            "mass": f"{across ** 2 * r.uniform(850, 1400):.4g} kg/m",
            "drag": {"normal": 1.6, "axial": r.choice([0, 0.1])}, "added_mass": {"normal": 1.0}}
    kind = r.choice(["elastic", "standard_linear_solid", "dual_stiffness"])
    EA = 10 ** r.uniform(6.5, 9)
    if kind == "elastic":
        rope["EA"] = f"{EA:.4g} N"
    else:
        rope["viscoelastic"] = {"model": kind, "EA_dynamic": f"{EA:.4g} N", "EA_static": f"{EA * r.uniform(0.3, 0.9):.4g} N"}
        if kind == "standard_linear_solid":
            rope["viscoelastic"]["relaxation_time"] = f"{10 ** r.uniform(-1, 3):.3g} s"
    return {
        "chain": {"category": "chain", "nominal_diameter": f"{1e3 * d:.4g} mm", "link": r.choice(["studless", "studlink"]),
                  "mass": f"{19.9e3 * d * d:.5g} kg/m", "EA": f"{0.854e11 * d * d:.5g} N",
                  "drag": {"normal": 2.4, "axial": r.choice([0, 1.15])}, "added_mass": {"normal": 1.0, "axial": 0.5}},
        "rope": rope,
        "pipe": {"category": "pipe", "material": "steel", "outer_diameter": f"{r.uniform(150, 500):.4g} mm",
                 "wall_thickness": f"{r.uniform(15, 40):.4g} mm", "contents_density": f"{r.choice([200, 800, 1025])} kg/m3",
                 "damping_ratio": r.choice([0, 0.01, 0.1]), "drag": {"normal": 1.2}},
        "odd": {"category": "general", "mass": f"{10 ** r.uniform(-1, 3):.3g} kg/m",
                "volume_diameter": f"{10 ** r.uniform(-2, 0):.3g} m", "EA": f"{10 ** r.uniform(3, 12):.3g} N",
                "EI": f"{r.choice([0, 10 ** r.uniform(0, 10)]):.3g} N.m2", "drag": {"normal": r.uniform(0, 3)}},
    }


def line(r, depth, floats, dynamic):
    """One line between a top near the surface and the bed, a free end or another fixed point."""
    top = [r.uniform(-20, 20), r.uniform(-20, 20), -r.uniform(0, 0.3) * depth]
    place = [f"{x:.4g} m" for x in top]
    hangs = depth + top[2]
    end_a = {"platform": "barge", "position": place} if floats else {"fixed": place}
    if not floats and r.random() < 0.7:
        end_a["motion"] = {way: {"amplitude": f"{10 ** r.uniform(-1, 1.2):.3g} m", "period": f"{r.uniform(3, 30):.3g} s"}
                           for way in r.sample(["surge", "sway", "heave"], r.randint(1, 3))}
    kind = r.choice(["anchor", "anchor", "anchor", "free", "fixed"])
    wild = r.random() < 0.25
    reach = hangs * r.uniform(*((0.1, 2.5) if wild else (0.7, 2)))
    azimuth = r.uniform(0, 6.28)
    far = [top[0] + reach * numpy.cos(azimuth), top[1] + reach * numpy.sin(azimuth)]
    chord = (reach ** 2 + hangs ** 2) ** 0.5
    total = chord * r.choice([1.001, 1.002, 1.005, 1.01, 1.02, 1.05, 1.1, 1.3, 1.6] if wild else [1.01, 1.02, 1.05, 1.1])
    if kind == "anchor":
        end_b = {"anchor": {"position": [f"{x:.5g} m" for x in far]}}
    elif kind == "fixed":
        z = -r.uniform(0.1, 0.7) * depth
        end_b = {"fixed": [f"{far[0]:.5g} m", f"{far[1]:.5g} m", f"{z:.5g} m"]}
    else:
        end_b = {"free": True}
        total = hangs * r.choice([0.2, 0.7, 1.2 if wild else 0.9])
    if r.random() < 0.2:
        end_a["joint"] = "clamped"
    n = r.randint(1, 3)
    parts = [r.uniform(0.2, 1) for _ in range(n)]
    kinds = r.choice([["chain"], ["chain", "rope"], ["pipe"]] + [["odd"], ["chain", "rope", "pipe", "odd"]] * wild)
    sections = [{"type": r.choice(kinds), "length": f"{total * p / sum(parts):.5g} m",
                 "elements": r.randint(2, 20) if wild else max(4, min(40, int(total * p / sum(parts) / r.uniform(3, 15))))} for p in parts]
    out = {"end_a": end_a, "end_b": end_b, "sections": sections}
    if n > 1 and r.random() < 0.4:
        out["attachments"] = [{"at": "joint 1", "mass": f"{10 ** r.uniform(0, 4.5):.3g} kg",
                               "volume": f"{r.choice([0, 10 ** r.uniform(-2, 1)]):.3g} m3"}]
    if dynamic and r.random() < 0.2:
        out["fail"] = {"time": f"{r.uniform(0.1, 4):.3g} s", "at": r.choice(["end_a", "end_b"])}
    if floats and r.random() < 0.3:
        out["constraints"] = [{"type": r.choice(["guide", "slider", "pull_tube", "ball_joint"]), "name": "held",
                               "platform": "barge", "position": [place[0], place[1], f"{top[2] - 0.1 * hangs:.4g} m"],
                               "stiffness": f"{10 ** r.uniform(4, 8):.3g} N/m"}]
        if out["constraints"][0]["type"] == "pull_tube":
            out["constraints"][0]["path"] = [out["constraints"][0].pop("position"),
                                             [place[0], place[1], f"{top[2] - 0.2 * hangs:.4g} m"]]
    return out


def barge(r, depth):
    size = r.uniform(0.1, 0.6) * min(depth, 80)
    mass = 1025 * size ** 3
    GM = size * r.uniform(0.02, 0.3)
    diagonal = lambda v: [[v[i] if i == k else 0 for k in range(6)] for i in range(6)]
    I = mass * size ** 2 / 6
    return {"name": "barge", "mass": "auto", "draft": f"{1.28 * size:.4g} m", "centre_of_gravity": [0, 0, f"{-0.9 * size:.4g} m"],
            "radii_of_gyration": {way: f"{size * 0.4:.4g} m" for way in ("roll", "pitch", "yaw")},
            "hydrodynamics": {"matrix": {"added_mass": diagonal([mass / 2] * 3 + [I / 2] * 3),
                                         "stiffness": diagonal([0, 0, 0] + [f"{mass * 9.80665 * GM:.5g} N.m/rad"] * 2 + [0])}},
            "members": [{"name": "hull", "from": [0, 0, f"{0.5 * size:.4g} m"], "to": [0, 0, f"{-1.28 * size:.4g} m"],
                         "diameter": f"{size:.4g} m", "Cd": 1.0, "inertia": True, "displaced_area": f"{0.785 * size ** 2:.5g} m2"}]}


def random_case(seed):
    r = random.Random(seed)
    depth = 30 * 60 ** r.random()
    floats = r.random() < 0.4
    model = r.choice(["dynamic"] * 4 + ["quasi_static"])
    case = {"format": 1, "title": f"Random case {seed}", "environment": environment(r, depth), "line_types": line_types(r),
            "materials": {"steel": {"E": "207 GPa", "density": "7850 kg/m3", "yield": "448 MPa"}},
            "lines": {f"l{i}": line(r, depth, floats, model == "dynamic") for i in range(r.randint(1, 3))},
            "analysis": {"dynamics": {
                "duration": "5 s", "ramp": f"{r.choice([0, 2, 5])} s", "statistics_from": "0 s",
                "steps": {"platform": f"{r.choice([0.1, 0.25, 0.5, 1])} s", "lines": f"{r.choice([0.02, 0.05, 0.1])} s"},
                "line_model": model,
                "coupling": {"force": r.choice(["instantaneous", "linear_fit"])}}},
            "output": {"lines": [{"at": ["end_a", "end_b"], "results": ["effective_tension", "curvature", "touchdown"],
                                  "range": ["effective_tension", "curvature"]}]}}
    if floats:
        case["platform"] = barge(r, depth)
    if r.random() < 0.2:
        case["analysis"]["dynamics"]["rod_scheme"] = {"type": "adams_moulton"}
    return case


def not_finite(file):
    """Names of series with a NaN. Statistics, utilisations, limits and touchdowns have NaN where there is
    nothing to tell."""
    found = []

    def look(name, item):
        told = not any(word in name for word in ("statistics", "utilisation", "touchdown", "extremes", "range",
                                               "lines/nodes/breaking_load", "lines/nodes/yield"))
        if told and isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and not numpy.isfinite(item[()]).all():
            found.append(name)

    with h5py.File(file) as result:
        result.visititems(look)
    return found


def call(*command):
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return "hangs", ""
    return done.returncode, done.stdout + done.stderr


def main():
    numbers = [int(x) for x in sys.argv[2:] if x != "-v"]
    hawser, first, count = sys.argv[1], *(numbers + [1, 50][len(numbers):])
    wrong = 0
    for seed in range(first, first + count):
        case = random_case(seed)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, f"random_{seed}.yml")
            file.write_text(json.dumps(case, indent=1))
            checked, said = call(hawser, "check", "--statics", str(file))
            ran, told = call(hawser, "run", str(file), "--out", folder + "/run", "-q")
            faults = [f"{name}: {code}" for name, code in (("check", checked), ("run", ran)) if code not in ENDS_WELL]
            faults += [f"{name}: {code} without a message" for name, code, text in
                       (("check", checked, said), ("run", ran, told)) if code in (3, 4, 5) and "error:" not in text]
            if checked != ran and not (checked == 0 and ran == 5):
                faults.append(f"check says {checked}, run {ran}")
            if "nan" in (said + told).lower().split():
                faults.append("a NaN is printed")
            result = pathlib.Path(folder, "run", "result.h5")
            if result.exists():
                faults += [f"NaN in {name}" for name in not_finite(result)]
            parts = [s["type"] for one in case["lines"].values() for s in one["sections"]]
            print(f"{seed} | {len(case['lines'])} lines, {'floating' if 'platform' in case else 'fixed'}, {','.join(parts)} | "
                  f"{checked} | {ran} | {'; '.join(faults) or 'yes'}", flush=True)
            if faults:
                wrong += 1
                shutil.copy(file, ".")
            if faults or "-v" in sys.argv:
                print(said + told, flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
