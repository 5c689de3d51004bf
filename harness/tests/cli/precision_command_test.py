#!/usr/bin/python3
"""`gcsbench precision`: what it writes, and its exit codes.

Usage: precision_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import csv
import json
import xml.etree.ElementTree as ElementTree

import command_line
from bad_instances import TOY
from command_line import BAD_INPUT, DONE, NOT_SOLVED, run
from path_command_test import FLAT


class Precision(command_line.CommandLine):
    def precision(self, *arguments):
        out = self.folder / "run"
        return out, run("precision", *arguments, "--repetitions", "3", "--out", out)

    def test_tables_and_plots_are_written_and_rebuilt_from_the_run(self):
        out, done = self.precision("k33")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertIn("### Error against run time: k33", done.stdout)
        rows = list(csv.DictReader((out / "precision-k33.csv").read_text().splitlines()))
        verdicts = json.loads(run("describe", "k33", "--json").stdout)["strategies"]
        applicable = {verdict["name"] for verdict in verdicts if verdict["applies"]}
        self.assertLess({"full-space", "rcp", "plan-scan", "monodromy", "polyhedral"}, applicable)
        self.assertEqual({row["row"].split()[0].rstrip(",") for row in rows}, applicable)
        for row in rows:
            if row["row"] == "rcp":
                self.assertEqual((row["solutions: missed"], row["solutions: spurious"]), ("0", "0"))
                self.assertLess(float(row["error: largest"]), 1e-14)
        plots = sorted(file.name for file in out.glob("*.svg"))
        self.assertEqual(plots, ["precision-k33.svg", "precision-profile-all.svg", "precision-profile-path.svg"])
        before = {name: (out / name).read_text() for name in plots}
        for name, text in before.items():
            ElementTree.fromstring(text)
            (out / name).unlink()
        self.assertEqual(run("report", out).returncode, DONE)
        self.assertEqual({name: (out / name).read_text() for name in plots}, before)

    def test_an_instance_of_the_users_own_is_measured_against_what_is_proven_in_the_run(self):
        out, done = self.precision(self.write(TOY))
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertIn("Reference: proven in this run, 2 solutions.", done.stdout)

    def test_where_nothing_is_proven_there_are_times_and_no_errors(self):
        out, done = self.precision(self.write(FLAT, "flat.json"), "--strategies", "plan-scan,monodromy")
        self.assertIn("Reference: none: no solution is proven.", done.stdout)
        for cell in json.loads((out / "run.json").read_text())["cells"]:
            self.assertIsNone(cell["accuracy"])

    def test_what_cannot_be_measured_is_said(self):
        self.assertEqual(run("precision", "no-such-instance").returncode, BAD_INPUT)
        self.assertEqual(run("precision", "k33", "--strategies", "no-such").returncode, BAD_INPUT)
        self.assertEqual(run("precision", "k33", "--strategies", "cayley-menger").returncode, NOT_SOLVED)


if __name__ == "__main__":
    command_line.main()
