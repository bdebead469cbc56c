"""Pictures of runs, by the scripts that draw them: several platforms, lines that part, mode shapes.

usage: test_pictures.py HAWSER SOURCE_DIR [unittest arguments]
"""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

HAWSER, SOURCE = sys.argv[1:3]
SCRIPTS = pathlib.Path(SOURCE).resolve() / "scripts"
CASES = pathlib.Path(SOURCE).resolve() / "cases"

# A column that floats by itself, held by springs, at a place of its own.
COLUMN = """format: 1
environment:
  seabed: {depth: 300 m}
  waves: [WAVES]
platforms:
  NAMED:
    position: [PLACE]
    mass: auto
    centre_of_gravity: [0, 0, -14 m]
    radii_of_gyration: {roll: 9 m, pitch: 9 m, yaw: 4 m}
    members:
      - {name: column, from: [0, 0, 8 m], to: [0, 0, -20 m], diameter: 10 m, Cd: 0.8, Ca: 1.0, end_Cd: [0, 1.0]}
    stiffness: {linear: {surge: 60 kN/m, sway: 60 kN/m, yaw: 5 MN.m/rad}}
analysis: {dynamics: {duration: 360 s, ramp: 40 s, statistics_from: 120 s, steps: {platform: 0.25 s}}}
output: {channels: [platform.motions, environment]}
"""


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, *arguments):
        done = subprocess.run([HAWSER, *map(str, arguments)], capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def run_case(self, case, out, *arguments):
        self.program("run", case, "--out", self.folder / out, "-q", "--force", *arguments)
        return self.folder / out

    def script(self, name, *arguments, code=0):
        done = subprocess.run([SCRIPTS / name, *map(str, arguments)], capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout, done.stderr

    def column(self, name, place, waves, *arguments):
        """A run of the column at a place, and its operators: frequencies and a motion's."""
        case = self.folder / f"{name}.yml"
        case.write_text(COLUMN.replace("NAMED", name).replace("PLACE", place).replace("WAVES", waves))
        return self.run_case(case, name, *arguments)

    def operators(self, run, *arguments):
        table = self.folder / "rao.csv"
        self.script("plot_rao", run, "-o", self.folder / "rao.png", "--csv", table, *arguments)
        with open(table, newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return {m: numpy.array([float(r[f"{m}_re_{u}"]) + 1j * float(r[f"{m}_im_{u}"]) for r in rows])
                for m, u in (("surge", "m_per_m"), ("heave", "m_per_m"), ("pitch", "deg_per_m"))}

    def test_operators_do_not_depend_on_where_the_platform_is(self):
        """The same column at the origin and 2 km off in a wave at 40 deg: k r = 69 rad here, so a phase that belongs to
        the origin would be anything. What is left is what the waves have not settled: 1 in 1e4."""
        wave = "{type: airy, H: 1 m, T: 10 s, heading: 40 deg}"
        here = self.operators(self.column("near", "0, 0", wave))
        there = self.operators(self.column("far", "1500 m, -1300 m", wave))
        for motion in ("surge", "heave", "pitch"):
            self.assertAlmostEqual(abs(there[motion][0] / here[motion][0] - 1), 0, delta=2e-3, msg=motion)
        with h5py.File(self.folder / "far" / "result.h5", "a") as file:  # as of a run that did not record it
            del file["platform/far/elevation"]
        _, words = self.script("plot_rao", self.folder / "far", code=2)
        self.assertIn("platform/far/elevation was not recorded: far is designed to be at x = 1500, y = -1300 m", words)

    def test_a_sweep_tells_the_resonance_between_its_waves(self):
        runs = [self.column(f"T{T}", "0, 0", f"{{type: airy, H: 0.2 m, T: {T} s, heading: 0}}") for T in (6, 8, 11)]
        _, words = self.script("plot_rao", *runs, "-o", self.folder / "rao.png", "--csv", self.folder / "rao.csv")
        self.assertRegex(words, "heave: the natural period of [89].* s lies between the waves of 8 and 11 s; the peak there "
                         "is not seen")

    def test_random_waves_far_from_the_origin_stay_coherent(self):
        """Over 2 km a group of 8 s waves takes five minutes, longer than a window of two: with the elevation at the
        origin nothing would be coherent."""
        wave = "{type: jonswap, Hs: 0.5 m, Tp: 8 s, heading: 40 deg, seed: 3, components: 150}"
        run = self.column("far", "1500 m, -1300 m", wave, "--duration", "1100 s")

        def coherence():
            self.script("plot_rao", run, "-o", self.folder / "rao.png", "--csv", self.folder / "rao.csv")
            with open(self.folder / "rao.csv", newline="") as file:
                rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
            return numpy.median([float(r["surge_coherence"]) for r in rows])

        self.assertGreater(coherence(), 0.85)  # but for the resonance
        with h5py.File(run / "result.h5", "a") as file:
            file["platform/far/elevation"][...] = file["environment/elevation"][...]
        self.assertLess(coherence(), 0.5)


    def test_a_line_that_parts_is_told_and_drawn(self):
        run = self.run_case(CASES / "truss_spar" / "truss_spar.yml", "parted", "--duration", "20 s", "--set",
                            "analysis.dynamics.ramp=5 s", "--set",
                            "lines.mooring.fail={line: ml8, time: 8 s, at: 1000 m}")
        drawn, words = self.script("plot", run)
        self.assertEqual(words, "")
        names = {pathlib.Path(line).stem for line in drawn.splitlines()}
        self.assertLessEqual({"tensions", "system", "range_effective_tension", "ledger"}, names)
        with h5py.File(run / "result.h5") as file:
            of = [name.decode() for name in file["lines/names"][:]].index("ml8")
            parted, arc = file["lines/parted"][:], file["line/ml8/nodes/arc_length"][:]
            self.assertEqual(parted[of, 0], 8.0)
            self.assertLess(abs(parted[of, 1] - 1000.0), numpy.diff(arc).max())  # at a node
            self.assertTrue(numpy.isnan(numpy.delete(parted, of, axis=0)).all())
            tension = file["line/ml8/end_a/effective_tension"][:]
            self.assertLess(tension[-1], 0.5 * tension[0])

    def test_modes_are_drawn_of_platforms_and_of_lines_that_lie_or_stand(self):
        for case, choices in (("two_platforms.yml", ([], ["--platform", "buoy"], ["--line", "bm1"])),
                              ("truss_spar/truss_spar.yml", (["--line", "ttr1", "--modes", "3"],)),
                              ("hanging_chain.yml", ([],))):
            report = self.folder / "modes.json"
            report.write_text(self.program("modes", CASES / case, "--json"))
            for choice in choices:
                picture = self.folder / "modes.png"
                self.script("plot_modes", report, "-o", picture, *choice)
                self.assertGreater(picture.stat().st_size, 30_000, (case, choice))
                picture.unlink()
        report.write_text(self.program("modes", CASES / "two_platforms.yml", "--json"))
        _, words = self.script("plot_modes", report, "--platform", "barge", code=1)
        self.assertIn("no platform is called barge; there are spar, buoy", words)

    def test_hydrodynamic_data_are_drawn(self):
        report = self.folder / "hydro.json"
        report.write_text(self.program("hydro", "info", CASES / "oc3_hywind" / "hydro" / "oc3_hywind", "--json"))
        drawn, _ = self.script("plot_hydro", report, "-o", self.folder / "oc3")
        self.assertEqual([pathlib.Path(line).name for line in drawn.splitlines()],
                         ["oc3_radiation.png", "oc3_excitation.png", "oc3_drift.png"])
        for line in drawn.splitlines():
            self.assertGreater(pathlib.Path(line).stat().st_size, 30_000, line)

    def test_paper_figures_want_one_platform(self):
        path = self.folder / "result.h5"
        with h5py.File(path, "w") as file:
            file["time"] = [0.0, 1.0]
            file["platform/one/position"] = file["platform/two/position"] = numpy.zeros((2, 6))
        done = subprocess.run([sys.executable, "-c", "import sys; sys.path.insert(0, sys.argv[1]); sys.dont_write_bytecode"
                               " = True; import paper_results; paper_results.Hour(sys.argv[2])", SCRIPTS, path],
                              capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("holds 2 platforms (one, two)", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
