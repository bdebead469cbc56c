"""Seas of several trains, and one that was measured, from the case file to the result.

usage: test_seas.py HAWSER SOURCE_DIR MPIEXEC [unittest arguments]
"""

import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

HAWSER, SOURCE, MPIEXEC = sys.argv[1:4]
CASES = pathlib.Path(SOURCE).resolve() / "cases"
LINES = "line/ml1/end_a/effective_tension"


class Seas(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_case(self, case, *arguments, ranks=0):
        out = self.folder / f"run{ranks}"
        start = [MPIEXEC, "-n", str(ranks), "--oversubscribe"] if ranks else []
        done = subprocess.run(start + [HAWSER, "run", str(case), "--out", str(out), "-q", *arguments],
                              capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def test_two_trains_add_up_on_any_number_of_ranks(self):
        bits = []
        for ranks in (0, 3):
            out = self.run_case(CASES / "two_seas.yml", "--duration", "30 s", "--set",
                                "analysis.dynamics.ramp=5 s", "--set",
                                "analysis.dynamics.statistics_from=5 s", "--set",
                                "output.lines=[{select: \"*\", at: [end_a]}]", ranks=ranks)
            with h5py.File(out / "result.h5") as result:
                each = result["environment/elevation_of_trains"][:]
                total = result["environment/elevation"][:]
                motion = result["platform/spar/position"][:]
                self.assertTrue(numpy.allclose(each.sum(axis=1), total, rtol=0, atol=1e-12))
                self.assertEqual(each.shape[1], 2)
                bits.append((motion.tobytes(), total.tobytes(), result[LINES][:].tobytes()))
            summary = (out / "summary.txt").read_text()
            self.assertIn("JONSWAP (gamma 5): Hs 2.5 m, Tp 15 s, towards 60 deg, 100 components, "
                          "seed 11; measured at the origin", summary)
            self.assertIn("(spread, s 8, 12 directions), 120 components, seed 12; measured", summary)
            self.assertIn("all trains together: Hs 4.717 m; measured", summary)
            self.assertIn("environment/elevation_of_train_2", summary)
        self.assertEqual(bits[0], bits[1])

    def test_a_measured_elevation_comes_back_at_the_gauge(self):
        """Band and samples such that the record's own sinusoids are kept: 4 and 11 whole periods."""
        record = [(n * 0.5, 1.5 * math.cos(2 * math.pi * 4 * n / 160) +
                   0.5 * math.sin(2 * math.pi * 11 * n / 160)) for n in range(160)]
        (self.folder / "gauge.txt").write_text(
            "time elevation\n" + "".join(f"{t} {eta:.17g}\n" for t, eta in record))
        case = self.folder / "measured.yml"
        case.write_text(f"""format: 1
base: {CASES / "two_seas.yml"}
environment:
  waves:
    - {{type: elevation_file, file: gauge.txt, heading: 30 deg, band: [0.2 rad/s, 2 rad/s]}}
analysis: {{dynamics: {{duration: 20 s, ramp: 0 s, statistics_from: 0 s}}}}
""")
        out = self.run_case(case, ranks=2)
        with h5py.File(out / "result.h5") as result:
            time, eta = result["time"][:], result["environment/elevation"][:]
            self.assertNotIn("elevation_of_trains", result["environment"])
        expected = numpy.interp(time, *zip(*record))
        self.assertLess(abs(eta - expected).max(), 1e-9)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
