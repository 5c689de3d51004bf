#!/usr/bin/python3
"""`gcsbench compare`: what it says of two runs, and its exit codes.

Usage: compare_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import tempfile
from pathlib import Path

import command_line
from command_line import BAD_INPUT, CHECK_FAILED, DONE, run


class Compare(command_line.CommandLine):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.before = Path(folder.name) / "before"
        done = run("tables", "table1", "--instances", "k33,octahedron", "--strategies", "full-space,rcp",
                   "--repetitions", 15, "--out", cls.before)
        assert done.returncode == DONE, done.stderr
        cells = json.loads((cls.before / "run.json").read_text())["cells"]
        cls.cells = len(cells)
        cls.timed = sum(1 for cell in cells if cell["repetitions"])

    def changed(self, change, name="after"):
        """A copy of the run with something changed."""
        record = json.loads((self.before / "run.json").read_text())
        change(record)
        folder = self.folder / name
        folder.mkdir()
        (folder / "run.json").write_text(json.dumps(record))
        return folder

    def compared(self, change, *more):
        return run("compare", self.before, self.changed(change), *more)

    def test_a_run_with_itself(self):
        done = run("compare", self.before, self.before / "run.json")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertIn(f"Answers of {self.cells} cells in both runs: 0 worse, 0 better, 0 otherwise different.", done.stdout)
        self.assertTrue(done.stdout.endswith("B has not regressed.\n"))

    def test_a_count_that_is_worse(self):
        def lose_one(record):
            record["cells"][0]["counts"]["on_path"] -= 1
            record["cells"][0]["work"]["iterations"] += 1
        done = self.compared(lose_one, "--out", self.folder / "tables")
        self.assertEqual(done.returncode, CHECK_FAILED, done.stderr)
        self.assertRegex(done.stdout, r"\| k33, full-space +\| +on_path \| +\d+ \| +\d+ \| worse \|")
        self.assertRegex(done.stdout, r"\| k33, full-space +\| iterations \|")
        names = {path.name for path in (self.folder / "tables").iterdir()}
        self.assertEqual(names, {f"compare-{name}.{ext}" for name in ("answers", "times", "work")
                                 for ext in ("md", "csv", "tex")})

    def test_times(self):
        def scale(factor):
            def change(record):
                for cell in record["cells"]:
                    for repetition in cell["repetitions"]:
                        for name in repetition:
                            repetition[name] *= factor
            return change
        done = self.compared(scale(100))
        self.assertEqual(done.returncode, CHECK_FAILED, done.stderr)
        self.assertIn(f"Times of {self.timed} cells: {self.timed} slower,", done.stdout)
        done = run("compare", self.folder / "after", self.before)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertIn(f" {self.timed} faster,", done.stdout)
        done = run("compare", self.before, self.folder / "after", "--margin", 1e6)
        self.assertEqual(done.returncode, DONE, done.stderr)

    def test_what_the_runs_were_made_with(self):
        def change(record):
            record["environment"].update(commit="0123abc", cpu="another")
            del record["cells"][0]
        done = self.compared(change)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertRegex(done.stdout, r"\| commit +\| +\w+\S* \| +0123abc \|")
        self.assertIn("different processors", done.stdout)
        self.assertIn("Cells that only one run has measured", done.stdout)
        self.assertIn(f"A: started {json.loads((self.before / 'run.json').read_text())['started']} by `", done.stdout)

    def test_precision_and_stability(self):
        for command in (["precision", "k33"], ["stability", "near-miss"]):
            with self.subTest(command):
                folder = self.folder / command[0]
                made = run(*command, "--strategies", "rcp,plan-scan", "--repetitions", 1, "--out", folder)
                self.assertEqual(made.returncode, DONE, made.stderr)
                done = run("compare", folder, folder)
                self.assertEqual(done.returncode, DONE, done.stderr)
                self.assertIn("too few runs", done.stdout)

    def test_bad_input(self):
        self.assert_one_message(run("compare", self.before, self.folder / "none"), BAD_INPUT, "none",
                                "no such file")
        self.assert_one_message(run("compare", self.folder, self.before), BAD_INPUT, "run.json", "no such file")
        text = (self.before / "run.json").read_text()
        for broken, what in (("", "empty"), ("{}", "gcsbench-run/1"), ("[1]", "gcsbench-run/1"), (text[:-100], "line "),
                             (text.replace('"full-space"', "7"), "a string"), ("\0" * 100, "zero byte")):
            with self.subTest(broken[:10]):
                file = self.write(broken, "broken.json")
                self.assert_one_message(run("compare", self.before, file), BAD_INPUT, file, what)

        def rename(record):
            for part in record["instances"] + record["cells"]:
                part["id" if "id" in part else "instance"] = "other"
        self.assert_one_message(self.compared(rename), BAD_INPUT, "no cell in common", self.before)
        for margin in ("nan", "-1", "x"):
            self.assert_usage_error(run("compare", self.before, self.before, "--margin", margin), "--margin")
        self.assert_usage_error(run("compare", self.before), "RUN_B")


if __name__ == "__main__":
    command_line.main()
