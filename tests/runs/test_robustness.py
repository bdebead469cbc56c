"""What goes wrong is said with line, place, time and cause, and what was saved can be read.

usage: test_robustness.py HAWSER SOURCE_DIR [unittest arguments]
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

HAWSER, SOURCE = sys.argv[1:3]
CHAIN = str(pathlib.Path(SOURCE) / "cases" / "hanging_chain.yml")


def hawser(*arguments):
    return subprocess.run([HAWSER, *arguments], capture_output=True, text=True, timeout=100)


def chain(*arguments, **changes):
    """The hanging chain with keys changed: `a__b` stands for a.b."""
    for key, value in changes.items():
        arguments += ("--set", key.replace("__", ".") + "=" + value)
    return hawser(*arguments)


class AStepThatCannotConverge(unittest.TestCase):
    """The top of the chain is carried off by 2 km in 3 s."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name) / "run"
        self.done = chain("run", CHAIN, "--out", str(self.out), "-q",
                          lines__chain__end_a__motion__surge__amplitude="2 km")

    def test_ends_the_run_with_line_time_place_and_cause(self):
        self.assertEqual(self.done.returncode, 5, self.done.stderr)
        self.assertEqual(self.done.stderr.count("error:"), 1, self.done.stderr)
        said = re.search(r"error: chain, t = ([\d.]+) s: .*largest at s = (\d+) m; likely cause: (.*)",
                         self.done.stderr)
        self.assertIsNotNone(said, self.done.stderr)
        status = json.loads((self.out / "status.json").read_text())
        self.assertEqual(status["exit_code"], 5)
        self.assertGreater(float(said[1]), status["saved_to"])
        self.assertLess(float(said[1]), status["saved_to"] + 1)
        self.assertLessEqual(float(said[2]), 300)

    def test_leaves_a_result_without_a_single_nan(self):
        with h5py.File(self.out / "result.h5") as result:
            self.assertFalse(bool(result.attrs["complete"]))
            self.assertGreater(len(result["time"]), 10)

            def finite(name, item):
                # NaN: nothing to compare with
                told = not any(word in name for word in ("statistics", "utilisation", "breaking_load", "yield"))
                if told and isinstance(item, h5py.Dataset) and item.dtype.kind == "f":
                    self.assertTrue(numpy.isfinite(item[()]).all(), name)
            result.visititems(finite)


class Refused(unittest.TestCase):
    """By `hawser check --statics`, with the reason."""

    def check(self, code, *words, **changes):
        done = chain("check", "--statics", CHAIN, **changes)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stdout + done.stderr)

    def test_a_section_without_length(self):
        self.check(3, "length", "above 0 m", **{"lines__chain__sections[0]__length": "0 m"})

    def test_an_anchor_out_of_reach(self):
        self.check(3, "300 m long", "509.5", lines__chain__end_b__anchor__position="[500 m, 0 m]")

    def test_stiffness_beyond_sense(self):
        self.check(4, "chain: no static solution", "EA = 1 N",
                   line_types__chain__EA="1 N")
        self.check(3, "line_types.chain: EA = 1e+30 N", "rounding", line_types__chain__EA="1e30 N")
        self.check(4, "chain: no static solution", "EI = 1e+20 N.m2", line_types__chain__EI="1e20 N.m2")

    def test_nothing_that_is_sound(self):
        self.check(0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
