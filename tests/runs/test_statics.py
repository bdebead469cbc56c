"""`hawser statics` and `hawser check --statics` as a user meets them.

usage: test_statics.py HAWSER SOURCE_DIR MPIEXEC [unittest arguments]
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py

HAWSER, SOURCE, MPIEXEC = sys.argv[1:4]
CASES = pathlib.Path(SOURCE) / "cases"
HEAVE = str(CASES / "heave_decay.yml")
CHAIN = str(CASES / "hanging_chain.yml")
SPAR = str(CASES / "truss_spar" / "truss_spar.yml")


def hawser(*arguments, ranks=0):
    mpirun = [MPIEXEC, "-n", str(ranks), "--oversubscribe"] if ranks else []
    return subprocess.run(mpirun + [HAWSER, *map(str, arguments)], capture_output=True, text=True,
                          timeout=60)


def statics(*arguments):
    """The report of `hawser statics --json`."""
    done = hawser("statics", *arguments, "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class RestoringCurve(unittest.TestCase):
    def test_without_lines_there_is_none(self):
        done = hawser("statics", HEAVE, "--offset", "0:10:5")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("there are no lines in this case", done.stderr)

    def test_marks_lines_above_their_breaking_load(self):
        weak = ("--set", "line_types.chain.breaking_load=4000 kN")
        said = hawser("statics", SPAR, "--offset", "0,40", "--lines", "ml*", *weak).stdout
        rows = [line for line in said.splitlines() if line.lstrip().startswith(("0.00 ", "40.00 "))]
        self.assertEqual([row.rstrip().endswith("!") for row in rows[-2:]], [False, True], said)

    def test_of_the_truss_spar_is_that_of_the_elastic_catenary(self):
        """1 %: the table is rounded to four digits; the rods have bending of none, a soft bed and
        44 elements a line, together 0.1 %."""
        with open(pathlib.Path(SOURCE) / "tests" / "data" / "truss_spar_restoring.csv") as table:
            expected = list(csv.DictReader(row for row in table if row[0] != "#"))
        curve = statics(SPAR, "--lines", "ml*", "--offset",
                        ",".join(row["offset"] for row in expected))["restoring"]
        self.assertEqual(len(curve["lines"]), 12)
        for got, row in zip(curve["points"], expected):
            with self.subTest(offset=row["offset"]):
                self.assertAlmostEqual(got["restoring"] / 1e3, float(row["restoring"]),
                                       delta=0.01 * float(row["restoring"]) + 1.0)
                for key in ("slope", "least_tension", "greatest_tension"):
                    value = float(row[key])
                    self.assertAlmostEqual(got[key] / 1e3, value, delta=0.01 * value, msg=key)
        # The weather group slackens, the other two share the pull.
        self.assertIn(curve["points"][-1]["least_line"], ("ml1", "ml2", "ml3", "ml4"))
        self.assertIn(curve["points"][-1]["greatest_line"], ("ml8", "ml9"))

    def test_is_the_same_in_the_three_directions_of_the_three_groups(self):
        curves = [statics(SPAR, "--lines", "ml*", "--offset", "25", "--heading", heading)
                  ["restoring"]["points"][0] for heading in (0, 120, -120)]
        for curve in curves[1:]:
            self.assertAlmostEqual(curve["restoring"] / curves[0]["restoring"], 1.0, delta=1e-6)
            self.assertLess(abs(curve["transverse"]), 1e-6 * curve["restoring"])

    def test_has_the_slope_that_its_forces_have(self):
        for free in ("none", "heave", "all"):
            with self.subTest(free=free):
                points = statics(SPAR, "--offset", "19.9:20.1:0.1", "--heading", "40", "--free", free)
                points = points["restoring"]["points"]
                slope = (points[2]["restoring"] - points[0]["restoring"]) / 0.2
                self.assertAlmostEqual(points[1]["slope"] / slope, 1.0, delta=1e-4)  # differences: h^2

    def test_leaves_in_balance_what_is_free_and_in_place_what_is_held(self):
        """All six free but the offset: lines, weight and buoyancy balance, so that the restoring force has no
        part across it and the curve is that of an equilibrium under a force along the heading."""
        curve = statics(SPAR, "--offset", "30", "--free", "all")["restoring"]
        self.assertEqual(curve["free"], ["transverse", "heave", "roll", "pitch", "yaw"])
        point = curve["points"][0]
        self.assertLess(abs(point["transverse"]), 1.0)
        self.assertEqual(point["position"]["surge"], 30.0)
        self.assertGreater(point["position"]["pitch"], 0.5)  # pulled back below the waterline
        held = statics(SPAR, "--offset", "30", "--lines", "ml*")["restoring"]
        self.assertEqual(held["free"], [])  # of some lines: the curve of these alone
        self.assertEqual(held["points"][0]["position"],
                         {"surge": 30, "sway": 0, "heave": 0, "roll": 0, "pitch": 0, "yaw": 0})

    def test_says_what_is_held_and_what_is_free(self):
        said = hawser("statics", SPAR, "--offset", "0,10").stdout
        self.assertIn("held as designed: transverse, roll, pitch, yaw", said)
        self.assertIn("free, settled under weight, buoyancy and all lines: heave", said)
        said = hawser("statics", SPAR, "--offset", "0,10", "--lines", "ml*").stdout
        self.assertIn("held as designed: transverse, heave, roll, pitch, yaw", said)

    def test_refuses_a_wrong_line_before_anything_is_computed(self):
        """The case has no equilibrium (code 4): only the name is told."""
        sunk = ("--set", "platform.mass=9e9 kg")
        self.assertEqual(hawser("statics", SPAR, *sunk).returncode, 4)
        for command in (("statics", "--offset", "5", "--lines", "cable*"), ("modes", "--line", "cable*")):
            done = hawser(command[0], SPAR, *command[1:], *sunk)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn('no line is called "cable*"', done.stderr)

    def test_of_a_run_is_one_pose(self):
        """platform.initial moves the start, not the equilibrium nor the tensions beside it."""
        with tempfile.TemporaryDirectory() as folder:
            done = hawser("run", SPAR, "--out", folder + "/run", "-q", "--duration", "0.5",
                          "--set", "platform.initial.surge=5 m", "--set", "analysis.dynamics.statistics_from=0 s")
            self.assertEqual(done.returncode, 0, done.stderr)
            with h5py.File(folder + "/run/result.h5") as file:
                place = file["statics/platform/spar/position"][:]
                tension = file["statics/lines/end_a/effective_tension"][:]
                moved = file["platform/spar/position"][0]
        report = statics(SPAR)
        self.assertAlmostEqual(place[0], report["platform"]["position"]["surge"], delta=1e-6)
        self.assertAlmostEqual(moved[0] - place[0], 5.0, delta=1e-6)
        for now, line in zip(tension, report["lines"], strict=True):
            if line["name"].startswith("ml"):
                self.assertAlmostEqual(now, line["tension_a"], delta=1.0)

    def test_wants_a_platform(self):
        done = hawser("statics", CHAIN, "--offset", "0,1")
        self.assertEqual(done.returncode, 3)
        self.assertIn("no platform", done.stderr)

    def test_can_be_written_as_csv(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "curve.csv"
            done = hawser("statics", SPAR, "--offset", "0:10:5", "-o", file)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = list(csv.DictReader(file.read_text().splitlines()))
            self.assertEqual([float(row["offset [m]"]) for row in rows], [0, 5, 10])
            done = hawser("statics", SPAR, "-o", file)
            rows = list(csv.DictReader(file.read_text().splitlines()))
            self.assertGreaterEqual(len(rows), 16)

    def test_needs_a_line_of_that_name(self):
        done = hawser("statics", SPAR, "--offset", "0", "--lines", "cable*")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("cable*", done.stderr)


class Tables(unittest.TestCase):
    def test_balance_at_the_equilibrium(self):
        """Weight, buoyancy with the heave stiffness, and the lines: to 2 % of the line load, for
        the wind and current push down and tilt a little."""
        report = statics(SPAR, "--set", "analysis.statics.loads=[]")
        p = report["platform"]
        self.assertTrue(p["stable"])
        weight = 9.80665 * p["mass"]
        self.assertAlmostEqual(p["acting_buoyancy"] - weight, p["vertical_line_load"],
                               delta=1e-6 * weight)
        self.assertAlmostEqual(p["line_load"][2], -p["vertical_line_load"],
                               delta=0.02 * p["vertical_line_load"])

    def test_tell_the_hanging_chain_in_closed_form(self):
        """V at the top is the weight of what hangs, H is the same at both ends, and what hangs is
        sqrt(h^2 + 2 h H/w) long: 0.3 m for elements of 7.5 m. On a soft bed, where it lies w/k deep,
        it touches sqrt(2 H/k) = 1.4 m earlier."""
        line = statics(CHAIN)["lines"][0]
        w = line["submerged_weight"] / line["length"]
        declination = math.radians(line["declination_a"])
        H, V = (line["tension_a"] * f(declination) for f in (math.sin, math.cos))
        self.assertAlmostEqual(V / w, line["touchdown"] + math.sqrt(2 * H / 100e3), delta=0.5)
        self.assertAlmostEqual(H / line["tension_b"], 1.0, delta=1e-3)
        self.assertAlmostEqual(math.sqrt(98**2 + 2 * 98 * H / w), V / w, delta=0.3)
        self.assertAlmostEqual(line["lowest_tension"] / H, 1.0, delta=1e-3)
        self.assertEqual(line["azimuth_a"], 0.0)

    def test_are_the_same_under_mpirun_and_said_once(self):
        alone, together = hawser("statics", HEAVE), hawser("statics", HEAVE, ranks=3)
        self.assertEqual(together.returncode, 0, together.stderr)
        self.assertEqual(alone.stdout, together.stdout)
        self.assertIn("GM of the hull alone", alone.stdout)

    def test_touchdown_and_grounded_length_make_up_the_line(self):
        for line in statics(SPAR)["lines"]:
            if line["name"].startswith("scr"):
                # all of it but what the stiff pipe lifts where it meets the bed
                self.assertAlmostEqual(line["touchdown"] + line["grounded"], line["length"],
                                       delta=2.0)


class Damaged(unittest.TestCase):
    def test_without_a_line_the_others_balance_the_same_platform(self):
        """Without a weather line the spar goes away from it until the others pull back as much, and the
        mass that was `auto` stays what floats with all lines."""
        calm = ("--set", "analysis.statics.loads=[]")
        whole, damaged = statics(SPAR, *calm), statics(SPAR, *calm, "--without", "ml1")
        self.assertEqual(len(damaged["lines"]), len(whole["lines"]) - 1)
        p, q = whole["platform"], damaged["platform"]
        self.assertAlmostEqual(p["mass"], q["mass"], delta=1e-6 * p["mass"])
        # ml1 pulled towards +x or -x with its horizontal tension; the slope of the rest is K11 of lines
        line = whole["lines"][0]
        azimuth, slope = math.radians(line["azimuth_a"]), q["line_stiffness"][0][0]
        pull = line["tension_a"] * math.sin(math.radians(line["declination_a"])) * math.cos(azimuth)
        moved = q["position"]["surge"] - p["position"]["surge"]
        # trim and the curve's bend: a quarter
        self.assertAlmostEqual(moved / (-pull / slope), 1.0, delta=0.25)
        self.assertEqual(hawser("statics", SPAR, "--without", "cable*").returncode, 3)


class Modes(unittest.TestCase):
    def modes(self, *arguments):
        done = hawser("modes", *arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_are_those_of_the_hull_alone_by_hand(self):
        """2 pi sqrt((103 801 + 42 380 + 39 000 t) / 12.63 MN/m) = 24.06 s; surge is not held."""
        modes = {mode["name"]: mode for mode in self.modes(HEAVE)["coupled"]}
        self.assertAlmostEqual(modes["heave"]["period"], 24.06, delta=0.05)
        self.assertNotIn("period", modes["surge"])
        self.assertEqual(modes["surge"]["without_period"], "not held")
        self.assertIn("not held", hawser("modes", HEAVE).stdout)

    def test_agree_with_statics_and_with_the_worked_example(self):
        """The design table has heave 22.6 s with all lines and surge 131 to 135 s by hand: 6 %,
        for its line loads and added mass are rounded and pitch comes in."""
        report = self.modes(SPAR, "--count", "2")
        periods = statics(SPAR)["platform"]["periods"]
        for mode in report["coupled"]:
            self.assertTrue(mode["converged"], mode["name"])
            self.assertAlmostEqual(mode["period"], periods[mode["name"]], delta=1e-6)
        modes = {mode["name"]: mode for mode in report["coupled"]}
        self.assertAlmostEqual(modes["heave"]["period"] / 22.6, 1.0, delta=0.06)
        self.assertAlmostEqual(modes["surge"]["period"] / 135.0, 1.0, delta=0.06)
        self.assertTrue(0.0 < modes["surge"]["line_inertia"] < 0.1)
        self.assertGreater(modes["surge"]["line_stiffness"], 0.9)

    def test_list_as_many_as_asked_for_of_the_lines_asked_for(self):
        report = self.modes(SPAR, "--count", "3", "--line", "ml[12]")
        self.assertEqual([line["name"] for line in report["lines"]], ["ml1", "ml2"])
        for line in report["lines"]:
            periods = [mode["period"] for mode in line["modes"]]
            self.assertEqual(len(periods), 3)
            self.assertEqual(periods, sorted(periods, reverse=True))
            for mode in line["modes"]:
                self.assertEqual(len(mode["shape"]), len(line["arc_length"]))
                self.assertAlmostEqual(mode["axial"] + mode["in_plane"] + mode["out_of_plane"], 1)
        self.assertEqual(hawser("modes", SPAR, "--line", "cable").returncode, 3)


class Check(unittest.TestCase):
    def test_with_statics_prints_the_summary(self):
        done = hawser("check", SPAR, "--statics")
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in ("valid.", "GM of the hull alone", "natural periods", "added mass taken at",
                      "greatest crest", "scr_oil"):
            self.assertIn(words, done.stdout)

    def test_without_equilibrium_ends_with_four(self):
        done = hawser("check", HEAVE, "--statics", "--set",
                      "environment.current={heading: 0 deg, profile: [[0 m, 1 m/s]]}")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("nothing holds the platform in surge", done.stderr)
        # the reason first, then what is left to say; nowhere that all is well
        self.assertNotIn("valid", done.stdout)
        last = done.stderr.splitlines()[-1]
        self.assertIn("keys are valid (0 errors, 0 warnings), but it has no static equilibrium", last)

    def test_with_statics_is_one_json_document(self):
        done = hawser("check", HEAVE, "--statics", "--json")
        report = json.loads(done.stdout)
        self.assertTrue(report["valid"] and report["equilibrium"])
        self.assertEqual(report["statics"]["platform"]["name"], "spar")
        done = hawser("check", HEAVE, "--statics", "--json", "--set",
                      "environment.current={heading: 0 deg, profile: [[0 m, 1 m/s]]}")
        self.assertEqual(done.returncode, 4)
        report = json.loads(done.stdout)
        self.assertTrue(report["valid"] and not report["equilibrium"])
        self.assertIn("nothing holds the platform in surge", report["reason"])

    def refused(self, case, *settings):
        """What `check --statics` says when there is no equilibrium."""
        arguments = [word for setting in settings for word in ("--set", setting)]
        done = hawser("check", case, "--statics", *arguments)
        self.assertIn(done.returncode, (3, 4), done.stderr)
        return done.stderr

    def test_looks_at_weight_and_buoyancy_before_the_lines(self):
        for case in (HEAVE, SPAR):
            said = self.refused(case, "platform.mass=300000 t", "platform.displacement=103800 t")
            self.assertIn("spar: weight", said)
            self.assertIn("more than the buoyancy", said)
            self.assertNotIn("ml1", said)

        said = self.refused(SPAR, "platform.mass=103800 kg")  # for t: it would jump out by 71 m
        self.assertIn("do not balance the buoyancy", said)
        self.assertIn("its unit", said)
        done = hawser("check", SPAR, "--statics", "--set", "platform.mass=97000 t")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"truss_spar.yml:\d+:\d+: warning: platform: weight")
        self.assertIn("1 warning. It has a static equilibrium", done.stdout)
        told = json.loads(hawser("check", SPAR, "--statics", "--json", "--set",
                                 "platform.mass=97000 t").stdout)
        self.assertEqual(told["warnings"], 1)
        self.assertTrue(any("weight" in p["message"] for p in told["problems"]))

    def test_warns_of_a_platform_step_that_is_long_for_a_natural_period(self):
        def said(step):
            done = hawser("check", HEAVE, "--statics", "--set",
                          f"analysis.dynamics.steps.platform={step} s", "--set",
                          f"output.interval={step} s")
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stderr
        self.assertNotIn("is long for the natural period", said(2))
        self.assertRegex(said(5), r"step of 5 s is long for the natural period in heave of \d\d")

    def test_refuses_what_no_line_can_be(self):
        said = self.refused(CHAIN, "lines.chain.end_b={anchor: {position: [330 m, 0 m]}}")
        self.assertIn("chain", said)
        said = self.refused(CHAIN, "line_types.chain.EA=200 kN")
        self.assertIn("own weight", said)
        said = self.refused(CHAIN, "lines.chain.sections=[{type: chain, length: 0 m}]")
        self.assertIn("length", said)

    def test_warns_of_a_hull_that_does_not_stand(self):
        done = hawser("check", HEAVE, "--statics", "--set",
                      "platform.centre_of_gravity=[0, 0, -40 m]")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("not stable in", done.stderr)
        self.assertIn("NOT STABLE in", done.stdout)
        with tempfile.TemporaryDirectory() as folder:
            run = hawser("run", HEAVE, "--out", folder + "/run", "--set",
                         "platform.centre_of_gravity=[0, 0, -40 m]", "--set",
                         "analysis.dynamics.duration=2 s")
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(folder + "/run/summary.txt", encoding="utf-8") as summary:
                self.assertIn("! the equilibrium is not stable in", summary.read())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
