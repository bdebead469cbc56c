"""cases/top_tensioned_riser.yml: tensioner and guide as a user reads them from the result.

usage: test_top_tensioned_riser.py HAWSER SOURCE_DIR [unittest arguments]
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

HAWSER, SOURCE = sys.argv[1:3]
CASE = str(pathlib.Path(SOURCE) / "cases" / "top_tensioned_riser.yml")


class TopTensionedRiser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        done = subprocess.run([HAWSER, "run", CASE, "--out", folder.name + "/run", "-q", "--duration", "60 s"],
                              capture_output=True, text=True, timeout=100)
        assert done.returncode == 0, done.stderr
        with h5py.File(folder.name + "/run/result.h5") as result:
            cls.time = result["time"][:]
            cls.heave = result["platform/spar/position"][:, 2]
            cls.stroke = result["constraint/riser/tensioner/stroke"][:]
            cls.tension = result["constraint/riser/tensioner/tension"][:]
            cls.contact = result["constraint/riser/keel/force"][:]

    def test_stroke_is_the_heave_but_for_lean_set_down_and_stretch(self):
        """Within 0.25 m: 1522 m - sqrt(1522^2 - x^2) is 0.03 m at 10 m; the lean of 2 deg lifts the ring's 22 m
        by 0.01 m; 300 kN more stretch the riser of EA/L 4.1 MN/m by 0.08 m."""
        self.assertGreater(self.stroke.max(), 1.5)
        self.assertLess(self.stroke.min(), -1.0)
        self.assertLess(numpy.abs(self.stroke - self.heave).max(), 0.25)

    def test_tension_follows_the_gas_law_and_the_damper(self):
        """F = 5338 kN (40/(40 - x))^1.1 + 20 kN.s/m dx/dt; differences of samples 0.5 s apart are the rate
        to (w h)^2/6 = 0.3 % at the heave's period of 24 s, and to less in the jump of the start."""
        middle = slice(4, -4)
        law = 5338e3 * (40 / (40 - self.stroke)) ** 1.1
        rate = numpy.gradient(self.stroke, self.time)
        self.assertGreater(numpy.abs(self.tension - law)[middle].max(), 5e3)  # the damper is felt
        self.assertLess(numpy.abs(self.tension - law - 20e3 * rate)[middle].max(), 2e3)

    def test_pitch_swings_with_the_period_that_statics_print(self):
        """The keel guide stands open at rest, gap 25 mm; let go at 2 deg the riser rubs at it all the way (6 m at the
        keel), so the period told is the one with the gap closed. 3 %: drag, friction, large motion."""
        told = subprocess.run([HAWSER, "statics", CASE], capture_output=True, text=True, timeout=100)
        self.assertNotIn("NOT STABLE", told.stdout)
        self.assertNotIn("not stable", told.stdout + told.stderr)
        self.assertIn("guides with a gap count as closed", told.stdout)
        period = float(re.search(r"natural periods.*pitch ([0-9.]+)", told.stdout).group(1))
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([HAWSER, "run", CASE, "--out", folder + "/run", "-q", "--duration", "150 s"],
                                  capture_output=True, text=True, timeout=100)
            self.assertEqual(done.returncode, 0, done.stderr)
            with h5py.File(folder + "/run/result.h5") as result:
                time, pitch = result["time"][:], result["platform/spar/position"][:, 4]
        up = numpy.nonzero((pitch[:-1] < 0) & (pitch[1:] >= 0))[0]
        at = time[up] - pitch[up] * (time[up + 1] - time[up]) / (pitch[up + 1] - pitch[up])
        self.assertGreaterEqual(len(at), 3)
        self.assertAlmostEqual((at[-1] - at[0]) / (len(at) - 1) / period, 1.0, delta=0.03)

    def test_keel_guide_pushes_and_never_pulls(self):
        self.assertGreaterEqual(self.contact.min(), 0.0)
        self.assertGreater(self.contact.max(), 50e3)  # leaning by 2 deg: some 6 m at the keel
        self.assertEqual(self.contact[self.contact < 1.0].max(initial=0.0), 0.0)  # in contact or not


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
