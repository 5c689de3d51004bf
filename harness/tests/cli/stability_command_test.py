#!/usr/bin/python3
"""`gcsbench stability`: what it writes, and its exit codes.

Usage: stability_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import csv
import xml.etree.ElementTree as ElementTree

import command_line
from command_line import BAD_INPUT, DONE, run


class Stability(command_line.CommandLine):
    def test_a_family_is_written_and_rebuilt_from_the_run(self):
        out = self.folder / "run"
        done = run("stability", "near-miss", "--repetitions", "3", "--out", out)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertIn("### near-miss: ", done.stdout)
        rows = list(csv.DictReader((out / "stability-near-miss.csv").read_text().splitlines()))
        self.assertEqual(len({row["section"] for row in rows}), 4)
        for row in rows:
            if row["section"].startswith("error / (condition"):
                self.assertLess(float(row[": 1e-8"]), 10)
        before = (out / "stability.svg").read_text()
        ElementTree.fromstring(before)
        (out / "stability.svg").unlink()
        self.assertEqual(run("report", out).returncode, DONE)
        self.assertEqual((out / "stability.svg").read_text(), before)

    def test_an_unknown_family_is_named(self):
        done = run("stability", "near-mis")
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("did you mean 'near-miss'?", done.stderr)


if __name__ == "__main__":
    command_line.main()
