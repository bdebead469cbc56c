"""Every kind of constraint, rope, winch and failure at once has the same bits on any number of ranks.

usage: test_every_constraint.py HAWSER SOURCE_DIR MPIEXEC
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py

HAWSER, SOURCE, MPIEXEC = sys.argv[1:4]
CASE = pathlib.Path(SOURCE) / "tests" / "runs" / "every_constraint.yml"


def run(out, ranks=0):
    mpirun = [MPIEXEC, "-n", str(ranks), "--oversubscribe"] if ranks else []
    return subprocess.run([*mpirun, HAWSER, "run", str(CASE), "-q", "--out", str(out)], capture_output=True,
                          text=True, timeout=300)


class EveryConstraint(unittest.TestCase):
    def test_has_the_same_bits_on_any_number_of_ranks(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            done = run(folder / "alone")
            self.assertEqual(done.returncode, 0, done.stderr)
            for ranks in (1, 2, 3, 5, 9):
                other = folder / str(ranks)
                done = run(other, ranks)
                self.assertEqual(done.returncode, 0, done.stderr)
                same = subprocess.run([pathlib.Path(SOURCE) / "scripts" / "compare", folder / "alone" / "result.h5",
                                       other / "result.h5"], capture_output=True, text=True)
                self.assertEqual(same.returncode, 0, f"{ranks} ranks: {same.stdout}{same.stderr}")

    def test_a_line_that_has_parted_pulls_at_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            self.assertEqual(run(folder / "run").returncode, 0)
            with h5py.File(folder / "run" / "result.h5") as f:
                names = [name.decode() for name in f["/lines/names"][:]]
                t, tension = f["/time"][:], f["/lines/end_a/effective_tension"][:]
            parted, neighbour = tension[:, names.index("ml5")], tension[:, names.index("ml6")]
            self.assertGreater(parted[t <= 2.0].min(), 3e6)  # it has until its time, 2 s
            self.assertEqual(abs(parted[t > 2.0]).max(), 0.0)
            self.assertGreater(neighbour.min(), 2.5e6)  # the others hold


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
