"""The tension-leg platform of cases/tlp against closed forms of taut vertical tendons.

usage: test_tlp.py HAWSER SOURCE_DIR [unittest arguments]
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

HAWSER, SOURCE = sys.argv[1:3]
TLP = str(pathlib.Path(SOURCE) / "cases" / "tlp" / "tlp.yml")

# Of the case.
RHO, G = 1025.0, 9.80665
TENDONS, L, PORCH = 8, 415.0, -34.0
STEEL = math.pi * (1.2 - 0.056) * 0.056  # of one tendon [m2]
EA = 210e9 * STEEL
PRETENSION = 17160e3  # at the top [N]
COLUMN, PONTOON, PONTOON_LENGTH, CA = math.pi / 4 * 16.88**2, 78.75, 2 * 34.685, 1.2
WATERPLANE = RHO * G * 4 * COLUMN  # [N/m]
ARM2 = (45.125**2 + 41.125**2) / 2  # mean square of the tendons' x [m2]
TENDON_MASS = TENDONS * L * STEEL * 7850
CALM = ["environment.waves=[]", "environment.current.profile=[[0 m, 0 m/s]]"]


def settings(changes):
    return [word for change in changes for word in ("--set", change)]


def statics(*changes):
    done = subprocess.run([HAWSER, "statics", TLP, "--json", *settings(changes)], capture_output=True, text=True,
                          timeout=60)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def pushed(speed):
    """The platform at rest in a steady wind, in still water."""
    return statics(*CALM, f"environment.wind.speed={speed} m/s")


def curve(*arguments):
    """The restoring curve of `hawser statics --offset`."""
    done = subprocess.run([HAWSER, "statics", TLP, "--json", *arguments], capture_output=True, text=True,
                          timeout=60)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)["restoring"]


def periods(inertia, stiffness):
    return 2 * math.pi * math.sqrt(inertia / stiffness)


def inertias():
    """Of surge [kg], heave [kg] and pitch [kg.m2] with the water's and, along their axis, the tendons' part.
    Pitch turns about the point that surge, free at its rate, leaves at rest: M55 - M15^2/M11."""
    m, z_g = statics()["platform"]["mass"], 3.0
    columns = RHO * 4 * COLUMN  # per metre of draft, Ca 1
    across = RHO * CA * PONTOON * 2 * PONTOON_LENGTH  # two pontoons
    m11 = m + columns * 35 + across
    m15 = m * z_g - columns * 35**2 / 2 - across * 29.75
    m55 = (m * (45.1**2 + z_g**2) + columns * 35**3 / 3 + across * (29.75**2 + 43.125**2 + 34.685**2 / 3)
           + TENDON_MASS / 3 * ARM2)
    return m11, m + 2 * across + TENDON_MASS / 3, m55 - m15**2 / m11


class Offset(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.reports = [pushed(speed) for speed in (20, 35, 50, 65)]

    def test_pulls_the_platform_down_by_the_circle_of_its_tendons(self):
        """L - sqrt(L^2 - x^2) less what the tendons stretch: the water that the columns take in by going
        down pulls at EA/L, 1.1 % of the set-down. 0.2 %: their sag, 8/3 of its square over L, and
        the tilt of their pull, (T L/EA)(x/L)^2/2."""
        for report in self.reports:
            x = report["platform"]["position"]["surge"]
            down = -report["platform"]["position"]["heave"]
            circle = L - math.sqrt(L**2 - x**2)
            with self.subTest(offset=x):
                self.assertGreater(x, 4.0)
                self.assertAlmostEqual(down / circle, 1 - WATERPLANE * L / (TENDONS * EA), delta=0.002)
        self.assertGreater(x, 40.0)  # a tenth of the length

    def test_pulls_it_back_with_tension_times_offset_over_length(self):
        """A heavy taut string between ends x apart: H = (x/h) (V_top - V_bottom)/ln(V_top/V_bottom).
        0.1 %: the flex joints add 2 k/(T L) = 0.03 %, and where they bend the tendon its angle, from
        which V_top is worked out here, differs."""
        for report in self.reports:
            x = report["platform"]["position"]["surge"]
            down = -report["platform"]["position"]["heave"]
            expected = 0.0
            for line in report["lines"]:
                top = line["tension_a"] * math.cos(math.radians(line["declination_a"]))
                bottom = top - line["submerged_weight"]
                expected += x / (L - down) * (top - bottom) / math.log(top / bottom)
            with self.subTest(offset=x):
                self.assertAlmostEqual(-report["platform"]["line_load"][0] / expected, 1.0, delta=0.001)

    def test_shares_the_added_pull_so_that_the_hull_balances(self):
        """All eight together carry the pretension and the water that the columns take in: 1e-3 for
        columns that lean by a hundredth of a degree and take in water by strips."""
        for report in self.reports:
            down = -report["platform"]["position"]["heave"]
            expected = TENDONS * PRETENSION + WATERPLANE * down
            self.assertAlmostEqual(-report["platform"]["line_load"][2] / expected, 1.0, delta=1e-3)


class RestoringCurve(unittest.TestCase):
    def test_goes_down_the_circle_of_the_tendons(self):
        """As above: L - sqrt(L^2 - x^2) less 1.1 % of stretch; in any direction."""
        for heading in (0, 30):
            points = curve("--offset", "10:50:10", "--heading", str(heading))["points"]
            for point in points:
                x = point["offset"]
                circle = L - math.sqrt(L**2 - x**2)
                self.assertAlmostEqual(-point["position"]["heave"] / circle,
                                       1 - WATERPLANE * L / (TENDONS * EA), delta=0.002)
                self.assertEqual(point["position"]["pitch"], 0.0)

    def test_with_heave_held_stretches_them(self):
        """What `--free none` is: at 30 m each tendon is 1.083 m longer, 110 MN more; 2 % for what the
        free one has stretched."""
        free, held = (curve("--offset", "30", "--free", f)["points"][0] for f in ("heave", "none"))
        stretch = math.hypot(30, L) - L
        self.assertEqual(held["position"]["heave"], 0.0)
        self.assertAlmostEqual(held["least_tension"] - free["least_tension"], EA / L * stretch,
                               delta=0.02 * EA / L * stretch)


class Pretension(unittest.TestCase):
    def test_is_met_and_leaves_the_published_mass_to_the_platform(self):
        """40 500 t and 54 500 t of displacement: rounded by the source to 0.1 Mkg each."""
        report = statics(*CALM, "environment.wind.speed=0.001 m/s")
        for line in report["lines"]:
            self.assertAlmostEqual(line["tension_a"] / PRETENSION, 1.0, delta=1e-5)
        self.assertAlmostEqual(report["platform"]["mass"] / 40.5e6, 1.0, delta=0.0025)
        self.assertAlmostEqual(report["platform"]["position"]["heave"], 0.0, delta=1e-4)


class Decay(unittest.TestCase):
    def period(self, mode, amount):
        """Of free oscillations about the upright position, from crossings of their mean."""
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [HAWSER, "run", TLP, "--out", folder + "/run", "-q", "--duration", "30 s",
                 *settings([*CALM, "environment.wind.speed=0.001 m/s", f"platform.initial.{mode}={amount}",
                            "output.interval=0.1 s", "analysis.dynamics.ramp=0 s",
                            "analysis.dynamics.statistics_from=5 s"])],
                capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 0, done.stderr)
            with h5py.File(folder + "/run/result.h5") as result:
                t = result["time"][:]
                x = result["platform/tlp/position"][:, 2 if mode == "heave" else 4]
        x = x - numpy.mean(x[t > 5])
        up = numpy.flatnonzero((x[:-1] < 0) & (x[1:] >= 0))
        when = t[up] - x[up] * (t[up + 1] - t[up]) / (x[up + 1] - x[up])
        self.assertGreater(len(when), 8)
        return (when[-1] - when[0]) / (len(when) - 1)

    def test_of_heave_has_the_period_of_the_tendons_EA_over_L(self):
        """A third of the tendons' mass moves with the hull. 0.5 %: crossings are interpolated in 18 samples
        a period, the drag's damping does nothing to the period in first order."""
        expected = periods(inertias()[1], TENDONS * EA / L + WATERPLANE)
        self.assertAlmostEqual(self.period("heave", "0.03 m") / expected, 1.0, delta=0.005)

    def test_of_pitch_has_the_period_of_the_tendons_EA_over_L(self):
        """1.5 %: the tendons' heads take along water and steel sideways, up to 1.4 % of the inertia."""
        expected = periods(inertias()[2], TENDONS * EA / L * ARM2)
        self.assertAlmostEqual(self.period("pitch", "0.04 deg") / expected, 1.0, delta=0.015)


class Modes(unittest.TestCase):
    def test_of_surge_heave_and_pitch_are_those_of_the_closed_forms(self):
        """0.5 % in surge: a third of the tendons and of the water about them moves with the hull, if they stay
        straight; pitch 1 %: what they do instead at that rate is up to 1.4 % of the inertia."""
        done = subprocess.run([HAWSER, "modes", TLP, "--json", "--count", "1",
                               *settings([*CALM, "environment.wind.speed=0.001 m/s"])], capture_output=True, text=True,
                              timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        period = {mode["name"]: mode["period"] for mode in json.loads(done.stdout)["coupled"]}
        tendons = TENDON_MASS + TENDONS * L * RHO * math.pi / 4 * 1.2**2
        bottom = PRETENSION - L * 9.80665 * (STEEL * 7850 - RHO * math.pi / 4 * 1.2**2)
        tension = (PRETENSION - bottom) / math.log(PRETENSION / bottom)
        mass, heave, pitch = inertias()
        self.assertAlmostEqual(period["surge"] / periods(mass + tendons / 3, TENDONS * tension / L), 1.0, delta=0.005)
        self.assertAlmostEqual(period["heave"] / periods(heave, TENDONS * EA / L + WATERPLANE), 1.0, delta=0.002)
        self.assertAlmostEqual(period["pitch"] / periods(pitch, TENDONS * EA / L * ARM2), 1.0, delta=0.01)


class Storm(unittest.TestCase):
    def test_keeps_all_tendons_taut_and_the_ledger_closed(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([HAWSER, "run", TLP, "--out", folder + "/run", "-q", "--duration", "180 s"],
                                  capture_output=True, text=True, timeout=100)
            self.assertEqual(done.returncode, 0, done.stderr)
            with h5py.File(folder + "/run/result.h5") as result:
                tension = result["lines/end_b/effective_tension"][:]
                position = result["platform/tlp/position"][:]
                mean, residual = result["ledger/tlp/mean"][:], result["ledger/tlp/residual"][:]
        self.assertGreater(tension.min(), 0.0)
        # heave is tied to surge by the circle; 0.1 m is what 80 MN more or less would stretch
        # the eight tendons, and no wave pulls that much without the slack excluded above
        circle = numpy.sqrt(L**2 - position[:, 0]**2) - L
        self.assertLess(numpy.abs(position[:, 2] - circle).max(), 0.1)
        for k in (0, 2, 4):
            self.assertLess(abs(residual[k]), 0.005 * numpy.abs(mean[:, k]).max())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
