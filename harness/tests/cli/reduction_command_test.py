#!/usr/bin/python3
"""Scenes with hung points and of several parts from outside: counts of any size, lists as long as asked for.

Usage: reduction_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import tempfile
import unittest
from pathlib import Path

import command_line
from command_line import BAD_INPUT, DONE, run


def solved(*arguments):
    return json.loads(run("solve", *arguments, "--out", "-").stdout)


class Reduction(unittest.TestCase):
    def test_two_octahedra_have_the_product_of_their_solutions(self):
        # 8 classes each at most, two sides of the common triangle, half of them mirror images.
        result = solved("octahedra@2", "--strategy", "monodromy", "--certify")
        self.assertEqual(result["status"], "complete")
        self.assertEqual(result["counts"]["complex_up_to_reflection"], 8 * 8 * 2)
        self.assertEqual(result["totals"]["complex"], 8 * 8 * 2)
        self.assertEqual(len(result["solutions"]), 8 * 8 * 2)
        self.assertTrue(result["proofs"]["complete"])

    def test_a_list_may_be_a_part_of_what_is_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "result.json"
            done = run("solve", "octahedra@10", "--strategy", "monodromy", "--max-solutions", "5", "--out", file)
            self.assertEqual(done.returncode, DONE)
            result = json.loads(file.read_text())
            self.assertEqual(result["status"], "partial")
            self.assertEqual(result["counts"]["complex_up_to_reflection"], 8**10 * 2**9)
            self.assertEqual(len(result["solutions"]), 5)
            self.assertEqual(run("verify", file).returncode, DONE)

    def test_a_count_of_hundreds_of_digits_is_a_text_in_the_file_and_short_on_the_screen(self):
        arguments = ["octahedron-hung@1000", "--strategy", "monodromy", "--max-solutions", "1"]
        count = solved(*arguments)["counts"]["complex_up_to_reflection"]
        self.assertEqual(int(count), 8 * 2**1000)
        summary = run("solve", *arguments).stdout
        self.assertIn("about 8.572e301", summary)
        self.assertLess(max(len(line) for line in summary.splitlines()), 200)

    def test_what_is_solved_apart_is_described(self):
        parts = json.loads(run("describe", "octahedra@3", "--json").stdout)["parts"]
        self.assertEqual([len(part["places"]) for part in parts], [6, 3, 3])
        self.assertEqual([len(part["base"]) for part in parts], [0, 3, 3])
        self.assertIn("3 parts", run("describe", "octahedra@3").stdout)
        hung = json.loads(run("describe", "k33-hung@10", "--json").stdout)["parts"]
        self.assertEqual(sum(part["hung"] for part in hung), 10)

    def test_a_path_strategy_follows_the_core_when_asked_to(self):
        whole = solved("octahedron-hung@3", "--strategy", "rcp")
        self.assertEqual((whole["claim"], whole["options"]["reduce"]), ("on path", "off"))
        core = solved("octahedron-hung@3", "--strategy", "rcp", "--set", "reduce=on")
        self.assertEqual(core["claim"], "on path of the core")
        alone = solved("octahedron-hung@0", "--strategy", "rcp")
        self.assertEqual(core["statistics"]["iterations"], alone["statistics"]["iterations"])

    def test_members_of_families_are_known_by_name(self):
        for name, nearest in [("octahedra@4", "octahedra@1"), ("octahedron@2", "octahedra")]:
            done = run("describe", name)
            self.assertEqual(done.returncode, BAD_INPUT)
            self.assertIn(nearest, done.stderr)
        self.assertEqual(run("describe", "short-edge@1e-8").returncode, DONE)


if __name__ == "__main__":
    command_line.main()
