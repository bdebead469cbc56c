"""A platform that is led (prescribed_motion) and one that is held (fixed_modes), as whole runs.

usage: test_led_platform.py HAWSER SOURCE_DIR MPIEXEC [unittest arguments]
"""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py

HAWSER, SOURCE, MPIEXEC = sys.argv[1:4]

CHAIN = """
format: 1
environment: {seabed: {depth: 100 m}}
line_types:
  chain: {category: chain, nominal_diameter: 100 mm, drag: {normal: 2.4}}
lines:
  chain:
    end_a: {platform: buoy, position: [0, 0, -5]}
    end_b: {anchor: {position: [150 m, 0 m]}}
    sections: [{type: chain, length: 190 m, elements: 12}]
analysis: {dynamics: {duration: 20 s, ramp: 8 s, statistics_from: 10 s, steps: {platform: 0.25 s, lines: 0.05 s}}}
output: {channels: [platform.motions, platform.loads]}
"""

LED = CHAIN + """
platform:
  name: buoy
  prescribed_motion:
    surge: {amplitude: 2 m, period: 9 s}
    heave: {mean: -1 m, amplitude: 1 m, period: 7 s, phase: 40 deg}
    yaw: {amplitude: 5 deg, period: 11 s}
"""

HELD = CHAIN + """
platform:
  name: buoy
  mass: auto
  centre_of_gravity: [0, 0, -6]
  radii_of_gyration: {roll: 5 m, pitch: 5 m, yaw: 4 m}
  fixed_modes: [sway, roll, yaw]
  initial: {yaw: 20 deg}
  stiffness: {linear: {surge: 50 kN/m}}
  forces: [{name: push, force: [-30 kN, 0, 0], position: [0, 0, -5], factor: [[0 s, 1], [5 s, 1], [10 s, 2]]}]
  members: [{name: hull, from: [0, 0, 5], to: [0, 0, -12], diameter: [9 m, 8 m], Cd: 1, end_Ca: [0, 0.64]}]
"""


def run(text, ranks=0, files=()):
    """The summary and the result of a case."""
    folder = pathlib.Path(tempfile.mkdtemp())
    (folder / "case.yml").write_text(text)
    for name, content in files:
        (folder / name).write_text(content)
    mpirun = [MPIEXEC, "-n", str(ranks), "--oversubscribe"] if ranks else []
    done = subprocess.run([*mpirun, HAWSER, "run", str(folder / "case.yml"), "--out", str(folder / "out"), "-q"],
                          capture_output=True, text=True, timeout=120, env=os.environ)
    assert done.returncode == 0, done.stderr
    return (folder / "out" / "summary.txt").read_text(), h5py.File(folder / "out" / "result.h5")


def residuals(result):
    """Of the load ledger over its largest component, of the motions that are loaded at all."""
    ledger = result["/ledger/buoy"]
    mean, residual = ledger["mean"][()], ledger["residual"][()]
    largest = abs(mean).max(axis=0)
    scale = [max(largest[:3])] * 3 + [max(largest[3:])] * 3
    return [abs(r) / top for r, top, one in zip(residual, largest, scale) if top > 1e-6 * one]


class LedPlatform(unittest.TestCase):
    def test_goes_as_told_and_tells_what_it_takes(self):
        summary, result = run(LED)
        time, x = result["/time"][()], result["/platform/buoy/position"][()]

        def ramp(t):
            q = min(t / 8, 1)
            return q ** 3 * (10 - q * (15 - 6 * q))

        for t, row in zip(time, x):
            told = [2 * ramp(t) * math.sin(2 * math.pi * t / 9), 0,
                    -1 + ramp(t) * math.sin(2 * math.pi * t / 7 + math.radians(40)), 0, 0,
                    5 * ramp(t) * math.sin(2 * math.pi * t / 11)]
            for got, want in zip(row, told):
                self.assertAlmostEqual(got, want, delta=1e-12)
        holding, lines = result["/platform/buoy/loads/holding"][()], result["/platform/buoy/loads/lines"][()]
        self.assertLess(abs(holding + lines).max(), 1e-3)   # no mass: nothing else to carry
        self.assertGreater(abs(lines).max(), 1e4)
        self.assertIn("holding", summary)

    def test_follows_a_file_and_the_bits_do_not_depend_on_ranks(self):
        rows = "".join(f"{t} {math.sin(0.4 * t) ** 2} 0 0 0 {2 * math.sin(0.3 * t) ** 2} 0\n" for t in range(0, 22))
        text = CHAIN + "platform: {name: buoy, prescribed_motion: {file: motion.txt}}\n"
        files = [("motion.txt", "# t x y z roll pitch yaw\n" + rows)]
        alone, spread = run(text, 0, files)[1], run(text, 2, files)[1]
        x = alone["/platform/buoy/position"][()]
        for t, row in zip(alone["/time"][()], x):
            if t == round(t):
                self.assertAlmostEqual(row[0], math.sin(0.4 * t) ** 2, delta=1e-12)
                self.assertAlmostEqual(row[4], 2 * math.sin(0.3 * t) ** 2, delta=1e-12)
        for path in ("/platform/buoy/position", "/platform/buoy/loads/holding"):
            self.assertEqual(alone[path][()].tobytes(), spread[path][()].tobytes())


class HeldPlatform(unittest.TestCase):
    def test_keeps_its_place_and_its_ledger_closes(self):
        _, result = run(HELD)
        x = result["/platform/buoy/position"][()]
        for column, place in ((1, 0), (3, 0), (5, 20)):
            self.assertLess(abs(x[:, column] - place).max(), 1e-12)
        self.assertGreater(x[:, 0].max() - x[:, 0].min(), 0.1)   # pushed from 5 s on
        for t, row in zip(result["/time"][()], x):
            if t <= 5:
                self.assertAlmostEqual(row[0], x[0, 0], delta=2e-3)   # rests till then
        for residual in residuals(result):
            self.assertLess(residual, 0.005)
        self.assertIn("/platform/buoy/loads/forces", result)
        self.assertIn("/platform/buoy/loads/stiffness", result)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
