"""The program as a user meets it: exit codes, stopping, results on any number of ranks.

usage: test_program.py HAWSER SOURCE_DIR MPIEXEC [unittest arguments]
"""

import importlib.machinery
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy

HAWSER, SOURCE, MPIEXEC = sys.argv[1:4]
CASES = pathlib.Path(SOURCE) / "cases"
HEAVE = str(CASES / "heave_decay.yml")
SPAR = str(CASES / "truss_spar" / "truss_spar.yml")


def mpirun(ranks):
    return [MPIEXEC, "-n", str(ranks), "--oversubscribe"] if ranks else []


def hawser(*arguments, ranks=0, timeout=60):
    """Runs the program, alone (ranks=0) or under mpirun; returns the finished process."""
    return subprocess.run(mpirun(ranks) + [HAWSER, *map(str, arguments)], capture_output=True,
                          text=True, timeout=timeout)


class Run(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "run"

    def status(self):
        return json.loads((self.out / "status.json").read_text())

    def long_run(self, ranks=0):
        """Starts a run that would last for ever and waits until it is in its time loop."""
        process = subprocess.Popen(
            mpirun(ranks) + [HAWSER, "run", HEAVE, "--duration", "1e9 s", "--out", str(self.out),
                             "-q", "--set", "output.interval=1000 s"],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        log = self.out / "log.txt"
        for _ in range(300):
            if log.exists() and "static start found" in log.read_text():
                return process
            time.sleep(0.05)
        self.fail("the run did not start")

    def assert_stopped(self, process, code=7):
        _, said = process.communicate(timeout=30)
        self.assertEqual(process.returncode, code, said)
        self.assertEqual(self.status()["state"], "stopped")
        self.assertEqual(self.status()["exit_code"], 7)
        with h5py.File(self.out / "result.h5") as result:
            self.assertFalse(bool(result.attrs["complete"]))
            self.assertGreater(len(result["time"]), 0)
            self.assertEqual(result["time"][-1], self.status()["saved_to"])


class HeaveDecay(Run):
    def test_swings_with_the_period_worked_out_by_hand(self):
        """2 pi sqrt((103 801 + 42 300 + 39 000 t) / 12.63 MN/m) = 24.05 s; quadratic damping does
        not change the period to first order, 1 % is for the damping and the draft in the wave."""
        self.assertEqual(hawser("run", HEAVE, "--out", self.out, "-q").returncode, 0)
        with h5py.File(self.out / "result.h5") as result:
            t = result["time"][:]
            heave = result["platform/spar/position"][:, 2]
        heave = heave - result_rest(heave)
        up = [t[i] - heave[i] * (t[i + 1] - t[i]) / (heave[i + 1] - heave[i])
              for i in range(len(t) - 1) if heave[i] < 0 <= heave[i + 1]]
        period = (up[-1] - up[0]) / (len(up) - 1)
        self.assertAlmostEqual(period, 24.05, delta=0.24)
        self.assertAlmostEqual(heave[0], 2.0, delta=0.01)
        peaks = [max(heave[(t >= k * period) & (t < (k + 1) * period)]) for k in range(1, 6)]
        falls = [a / b for a, b in zip(peaks, peaks[1:])]
        self.assertTrue(all(a > b > 1 for a, b in zip(falls, falls[1:])), falls)


def result_rest(heave):
    return numpy.mean(heave[len(heave) // 2:])


class ExitCodes(Run):
    def test_two_for_a_wrong_command_line(self):
        for ranks in (0, 2):
            done = hawser("run", HEAVE, "--no-such-option", ranks=ranks)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.count("--no-such-option"), 1, done.stderr)

    def test_three_for_wrong_input_said_once_on_any_number_of_ranks(self):
        for ranks in (0, 3):
            done = hawser("run", HEAVE, "--out", self.out, "--set", "platform.mass=3 m", ranks=ranks)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertEqual(done.stderr.count("error: platform.mass"), 1, done.stderr)
            self.assertNotIn("MPI_ABORT", done.stderr)
            self.assertFalse(self.out.exists())

    def test_three_for_a_database_that_is_not_there(self):
        for ranks in (0, 3):
            done = hawser("run", HEAVE, "--out", self.out, "--set",
                          "platform.hydrodynamics.database.path=nowhere", ranks=ranks)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("nowhere", done.stderr)

    def test_four_without_equilibrium(self):
        done = hawser("run", HEAVE, "--out", self.out, "-q", "--set",
                      "environment.current={heading: 0 deg, profile: [[0 m, 1 m/s]]}")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("nothing holds the platform in surge", done.stderr)
        self.assertEqual(self.status()["state"], "failed")

    def test_five_for_a_run_that_diverges_with_what_it_has(self):
        for ranks in (0, 3):
            done = hawser("run", HEAVE, "--out", self.out, "-q", "--force", "--duration", "1e6 s",
                          "--set", "analysis.dynamics.steps.platform=25 s", ranks=ranks)
            self.assertEqual(done.returncode, 5, done.stderr)
            self.assertEqual(done.stderr.count("error: "), 1, done.stderr)
            self.assertEqual(self.status()["exit_code"], 5)
            with h5py.File(self.out / "result.h5") as result:
                self.assertFalse(bool(result.attrs["complete"]))

    def test_six_for_a_result_in_the_way_and_a_folder_that_cannot_be(self):
        self.assertEqual(hawser("run", HEAVE, "--out", self.out, "-q").returncode, 0)
        before = (self.out / "result.h5").stat().st_mtime_ns
        for ranks in (0, 2):
            done = hawser("run", HEAVE, "--out", self.out, "-q", ranks=ranks)
            self.assertEqual(done.returncode, 6, done.stderr)
            self.assertIn("--force", done.stderr)
        self.assertEqual((self.out / "result.h5").stat().st_mtime_ns, before)
        done = hawser("run", HEAVE, "--out", "/proc/no/such/place", "-q")
        self.assertEqual(done.returncode, 6, done.stderr)

    def test_zero_for_help_version_and_dry_run(self):
        for arguments in (["--help"], ["run", "--help"], ["version"], ["run", SPAR, "--dry-run"]):
            done = hawser(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(done.stdout)
        done = hawser("run", SPAR, "--dry-run", ranks=3)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count("rank 2:"), 1)

    def test_dry_run_tells_the_steps_of_each_line(self):
        done = hawser("run", SPAR, "--dry-run", "--set", "lines.ttr.time_step=10 ms",
                      "--set", "lines.mooring.model=quasi_static")
        self.assertIn("steps of a line (ttr) in a pass: 25 of 0.01 s and 50 of 0.01 s", done.stdout)
        self.assertIn("in a pass: 13 of 0.019231 s and 25 of 0.02 s", done.stdout)
        self.assertIn("lines without dynamics: one solution a pass", done.stdout)


class Stopping(Run):
    def test_a_file_named_stop_ends_with_seven(self):
        process = self.long_run()
        (self.out / "STOP").touch()
        self.assert_stopped(process)

    def test_a_signal_ends_with_seven(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
            with self.subTest(number):
                process = self.long_run()
                process.send_signal(number)
                self.assert_stopped(process)
            subprocess.run(["rm", "-rf", self.out], check=True)

    def test_a_killed_run_leaves_a_status_that_says_so_to_the_plot(self):
        process = self.long_run()
        plot = importlib.machinery.SourceFileLoader("plot", str(
            pathlib.Path(SOURCE) / "scripts" / "plot")).load_module()
        self.assertEqual(plot.end_of(self.out), "has not ended")
        process.kill()
        process.wait(timeout=30)
        self.assertEqual(self.status()["state"], "running")
        self.assertEqual(plot.end_of(self.out), "was killed")

    def test_sigusr1_to_mpirun_ends_all_ranks_with_seven(self):
        process = self.long_run(ranks=3)
        process.send_signal(signal.SIGUSR1)
        self.assert_stopped(process)


class Summary(Run):
    def test_flags_a_line_that_goes_slack_and_is_compressed(self):
        chain = pathlib.Path(SOURCE) / "cases" / "hanging_chain.yml"
        motion = "lines.chain.end_a.motion.heave."
        arguments = ["run", chain, "--duration", "20 s", "-q", "--set", "analysis.dynamics.ramp=4 s",
                     "--set", "analysis.dynamics.statistics_from=10 s", "--out", self.out]
        self.assertEqual(hawser(*arguments).returncode, 0)
        self.assertNotIn("slack", (self.out / "summary.txt").read_text())
        done = hawser(*arguments, "--force", "--set", motion + "amplitude=8 m", "--set",
                      motion + "period=5 s")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex((self.out / "summary.txt").read_text(),
                         r"! chain: slack \(below \d+\.\d kN somewhere\) for [\d.]+ s in all, first at "
                         r"t = [\d.]+ s, least tension at [\d.]+ m")


class Ranks(Run):
    def test_the_truss_spar_has_the_same_bits_on_any_number_of_ranks(self):
        arguments = ["run", SPAR, "--duration", "4 s", "--set", "analysis.dynamics.ramp=1 s",
                     "--set", "analysis.dynamics.statistics_from=2 s", "-q", "--out"]
        self.assertEqual(hawser(*arguments, self.out).returncode, 0)
        for ranks in (1, 2, 3, 5, 9, 5):  # four packs of lines: 9 ranks leave workers idle
            other = self.folder / "other"
            subprocess.run(["rm", "-rf", other], check=True)
            done = hawser(*arguments, other, ranks=ranks)
            self.assertEqual(done.returncode, 0, done.stderr)
            same = subprocess.run(
                [pathlib.Path(SOURCE) / "scripts" / "compare", self.out / "result.h5",
                 other / "result.h5"], capture_output=True, text=True)
            self.assertEqual(same.returncode, 0, f"{ranks} ranks: {same.stdout}{same.stderr}")


class Progress(Run):
    def test_under_mpirun_comes_in_lines_from_rank_zero(self):
        done = hawser("run", HEAVE, "--out", self.out, ranks=2)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line for line in done.stderr.splitlines() if line.startswith("t ")]
        self.assertTrue(15 <= len(lines) <= 21, done.stderr)  # one per 5 %
        self.assertRegex(lines[-1], r"^t 240\.0/240\.0 s  100\.0 %  \S+x real time")
        self.assertNotIn("\r", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
