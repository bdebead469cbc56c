"""scripts/paper_figures as a user meets it: the quick run under mpirun.

usage: test_paper_figures.py HAWSER SOURCE_DIR [unittest arguments]
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HAWSER, SOURCE = sys.argv[1:3]
SCRIPT = str(pathlib.Path(SOURCE) / "scripts" / "paper_figures")


def paper_figures(*arguments):
    return subprocess.run([SCRIPT, *arguments, "--hawser", HAWSER], capture_output=True, text=True, timeout=110)


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.out = pathlib.Path(folder.name)
        cls.done = paper_figures("--quick", "--ranks", "2", "-o", str(cls.out))

    def test_draws_the_figures_and_writes_the_page(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        page = (self.out / "figures.md").read_text()
        for number in FIGURES:
            picture = self.out / f"figure_{number}.png"
            self.assertGreater(picture.stat().st_size, 10000, picture)
            self.assertIn(f"## Figure {number}: ", page)
            self.assertIn(f"(figure_{number}.png)", page)
        self.assertNotIn("nan", page)

    def test_finds_the_paper_s_claim_of_figure_4_in_the_quick_run(self):
        """Fourth order of the platform: the curves of 0.5 and 1.0 s differ by less than a line's width,
        1 % of the standard deviation."""
        page = (self.out / "figures.md").read_text()
        shares = [float(row[-1]) for row in self.rows(page, 4)]
        self.assertEqual(len(shares), 3)  # three motions
        self.assertTrue(all(0 < share < 1.0 for share in shares), shares)

    def test_keel_force_is_a_magnitude_and_stress_is_that_of_a_bent_pipe(self):
        """The oil riser's bending at touch-down is 120 MPa in a catenary of its static top angle: a factor of
        two either way for the storm."""
        page = (self.out / "figures.md").read_text()
        keel, stress = (self.rows(page, number) for number in (6, 8))
        for row in keel:
            for cell in row[2:5]:
                self.assertGreaterEqual(float(re.search(r", (-?[\d.]+) to", cell)[1]), 0.0)
        for row in stress:
            self.assertTrue(60 < float(row[2]) < 240, row)
            self.assertTrue(1400 < float(row[3]) < 1800, row)

    @staticmethod
    def rows(page, number):
        part = page[page.index(f"## Figure {number}"):]
        part = part[:part.index("\n## ")] if "\n## " in part else part
        return [[cell.strip() for cell in line.strip("|").split("|")] for line in part.splitlines()
                if re.match(r"\| \d+° ", line)]

    def test_uses_finished_runs_again_unless_the_case_has_changed(self):
        before = {p: p.stat().st_mtime_ns for p in self.out.rglob("result.h5")}
        self.assertGreater(len(before), 3)
        changed = self.out / "heading_0" / "coupled" / "status.json"
        changed.write_text(changed.read_text().replace('"done"', '"stopped"'))
        again = paper_figures("--quick", "--ranks", "1", "-o", str(self.out))
        self.assertEqual(again.returncode, 0, again.stderr)
        fresh = {p.parent for p, time in before.items() if p.stat().st_mtime_ns != time}
        self.assertEqual(fresh, {changed.parent})


class WrongUse(unittest.TestCase):
    def test_wrong_options_are_refused(self):
        self.assertEqual(paper_figures("--fast").returncode, 2)
        self.assertEqual(paper_figures("--ranks", "0").returncode, 2)

    def test_a_program_that_is_not_built_is_named(self):
        done = subprocess.run([SCRIPT, "--hawser", "/no/such/hawser"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("scripts/build", done.stderr)


FIGURES = (3, 4, 5, 6, 7, 8)

if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
