"""What is left of a run, seen from outside: results of different rank counts are the same bits,
scripts/compare finds a single bit, and a killed run leaves every reported segment readable.

usage: test_results.py SYNTHETIC_MAIN SCRIPTS MPIEXEC [unittest arguments]
"""

import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy as np

PROGRAM, SCRIPTS, MPIEXEC = sys.argv[1:4]


def run(*arguments):
    return subprocess.run(arguments, capture_output=True, text=True, check=False)


def compare(a, b):
    result = run(os.path.join(SCRIPTS, "compare"), a, b)
    return result.returncode, result.stdout + result.stderr


class InAFolder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="hawser_results_")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def path(cls, *parts):
        return os.path.join(cls.folder, *parts)


class Figures(InAFolder):
    def test_plot_draws_what_each_kind_of_run_recorded(self):
        figures = {
            "spar": {"motions", "environment", "tensions", "offset", "system", "ledger",
                     "range_effective_tension", "range_von_mises_stress", "touchdown",
                     "constraints"},
            "pair": {"motions_spar", "motions_tender", "environment", "tensions", "offset_spar", "offset_tender",
                     "system", "ledger_spar", "ledger_tender", "range_effective_tension",
                     "range_von_mises_stress", "touchdown", "constraints"},
            "decay": {"motions", "decay", "ledger"},
            "chain": {"tensions", "lines"},
        }
        for kind, names in figures.items():
            folder = self.path(kind)
            subprocess.run([PROGRAM, kind, folder, "60"], check=True, capture_output=True)
            done = run(os.path.join(SCRIPTS, "plot"), folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, "")
            drawn = [line for line in done.stdout.splitlines()]
            self.assertEqual({os.path.basename(f) for f in drawn}, {n + ".png" for n in names})
            for file in drawn:
                self.assertGreater(os.path.getsize(file), 10_000, file)
        self.assertEqual(run(os.path.join(SCRIPTS, "plot"), self.path("nothing")).returncode, 2)

    def test_a_platform_tells_where_it_is_designed_to_be(self):
        folder = self.path("placed")
        subprocess.run([PROGRAM, "pair", folder, "10"], check=True, capture_output=True)
        with h5py.File(os.path.join(folder, "result.h5")) as file:
            self.assertEqual(list(file["platform/tender"].attrs["design_position"]), [120, 60, 0])
            self.assertEqual(list(file["platform/spar"].attrs["design_position"]), [0, 0, 0])


class Results(InAFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        subprocess.run([PROGRAM, "spar", cls.path("alone"), "30"], check=True, capture_output=True)
        cls.result = cls.path("alone", "result.h5")

    def changed(self, change):
        """compare of the result with a copy that `change` has worked on."""
        copy = self.path("copy.h5")
        shutil.copy(self.result, copy)
        with h5py.File(copy, "r+") as file:
            change(file)
        return compare(self.result, copy)

    def test_any_rank_count_gives_the_same_bits(self):
        for ranks in (2, 3):
            folder = self.path(f"ranks{ranks}")
            done = run(MPIEXEC, "-n", str(ranks), "--oversubscribe", PROGRAM, "spar", folder, "30")
            self.assertEqual(done.returncode, 0, done.stderr)
            code, words = compare(self.result, os.path.join(folder, "result.h5"))
            self.assertEqual(code, 0, words)
            self.assertIn("identical", words)

    def test_compare_finds_one_bit_and_says_where_and_when(self):
        def flip(file):
            data = file["/lines/end_a/effective_tension"]
            values = data[:]
            bits = values.view(np.uint64)
            bits[7, 3] ^= np.uint64(1)  # the last bit of line 3 at t = 3.5 s
            data[:] = values

        code, words = self.changed(flip)
        self.assertEqual(code, 1)
        first = words.splitlines()[1]
        # the same number also shows through the line's own path
        self.assertRegex(first, r"/line(s|/ml4)/end_a/effective_tension\[7\]")
        self.assertIn("/lines/end_a/effective_tension[7][3] at t = 3.5 s", words)
        self.assertEqual(words.count("at t ="), 2)

    def test_compare_names_the_earliest_of_several(self):
        def change(file):
            file["/environment/elevation"][20] += 1.0
            file["/platform/spar/position"][10, 2] += 1.0

        code, words = self.changed(change)
        self.assertEqual(code, 1)
        self.assertIn("first: /platform/spar/position[10][2] at t = 5 s", words)

    def test_compare_tells_minus_zero_from_zero_and_equal_nan_are_equal(self):
        with h5py.File(self.result, "r") as file:
            self.assertTrue(np.isnan(file["/lines/end_a/force"][:, 13]).all())

        def sign(file):
            file["/platform/spar/loads/wave1"][0, 0] = -0.0

        self.assertEqual(self.changed(lambda file: None)[0], 0)
        with h5py.File(self.result, "r") as file:
            self.assertEqual(file["/platform/spar/loads/wave1"][0, 0], 0.0)
        self.assertEqual(self.changed(sign)[0], 1)

    def test_compare_leaves_out_what_belongs_to_the_run(self):
        def change(file):
            for name in ("created", "command", "build_host"):
                file.attrs[name] = "other"
            file.attrs["ranks"] = 99
            file["/performance/wall"][()] = 1e6

        self.assertEqual(self.changed(change)[0], 0)

    def test_compare_sees_attributes_texts_tables_and_missing_data(self):
        def units(file):
            file["/time"].attrs["units"] = "min"

        def title(file):
            file.attrs["title"] = "other"

        def text(file):
            file["/input/case"][()] = "other"

        def table(file):
            rows = file["/statistics/table"][:]
            rows["mean"][4] = np.nextafter(rows["mean"][4], 1e9)
            file["/statistics/table"][:] = rows

        def missing(file):
            del file["/ledger/spar/residual"]

        for change in (units, title, text, table, missing):
            self.assertEqual(self.changed(change)[0], 1, change.__name__)

    def test_compare_refuses_wrong_use(self):
        self.assertEqual(run(os.path.join(SCRIPTS, "compare"), self.result).returncode, 2)
        self.assertEqual(compare(self.result, self.path("nothing.h5"))[0], 2)

    def test_a_disk_that_fills_up_ends_all_ranks_with_exit_code_6_and_the_path(self):
        for ranks in ([], [MPIEXEC, "-n", "3", "--oversubscribe"]):
            folder = self.path(f"full{len(ranks)}")
            done = run(*ranks, PROGRAM, "spar", folder, "100", "120000")
            self.assertEqual(done.returncode, 6, done.stderr)
            self.assertIn("segment_00001.h5.part", done.stderr)
            self.assertNotIn("segment_00001.h5", os.listdir(folder))
            if ranks:  # alone the caller writes it
                with open(os.path.join(folder, "status.json")) as file:
                    status = json.load(file)
                self.assertEqual((status["state"], status["exit_code"]), ("failed", 6))
                self.assertIn("segment_00001.h5.part", status["message"])
                self.assertEqual(status["saved_to"], 0)

    def test_a_killed_run_leaves_every_reported_segment_readable(self):
        folder = self.path("killed")
        job = subprocess.Popen(
            [MPIEXEC, "-n", "2", "--oversubscribe", PROGRAM, "spar", folder, "1000000"],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
        )
        reported = 0
        for line in job.stdout:
            if line.startswith("segment"):
                reported = int(line.split()[1])
            if reported == 3:
                time.sleep(0.013)  # somewhere in the fourth or later
                os.kill(self.ranks_of(job.pid)[-1], signal.SIGKILL)
                break
        for line in job.stdout:  # what was reported before the others were ended
            if line.startswith("segment"):
                reported = int(line.split()[1])
        job.stdout.close()
        self.assertNotEqual(job.wait(timeout=30), 0)
        self.assertGreaterEqual(reported, 3)
        for n in range(1, reported + 1):
            with h5py.File(os.path.join(folder, f"segment_{n:05d}.h5"), "r") as file:
                np.testing.assert_array_equal(file["/time"][:], 0.5 * np.arange(100 * n - 100, 100 * n))
                self.assertTrue(np.isfinite(file["/lines/end_a/effective_tension"][:]).all())
                self.assertTrue(np.isfinite(file["/lines/nodes/position"][:]).all())
        drawn = run(os.path.join(SCRIPTS, "plot"), folder)  # what is left can be looked at
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))
        self.assertIn("motions.png", drawn.stdout)

    @staticmethod
    def ranks_of(launcher):
        """Processes of our program whose parent is the launcher."""
        found = []
        for name in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{name}/stat") as file:
                    fields = file.read().rsplit(")", 1)[1].split()
            except OSError:
                continue
            if int(fields[1]) == launcher:
                found.append(int(name))
        return sorted(found)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
