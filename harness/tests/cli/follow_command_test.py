#!/usr/bin/python3
"""`gcsbench follow`: figures against closed forms, from results, along polylines, and bad input.

Usage: follow_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import math

import command_line
from command_line import BAD_INPUT, DONE, NOT_SOLVED, run

# c turns about b; a–c is longest, 7, where the triangle is flat.
TRIANGLE = {"format": "gcsbench-instance/1", "id": "triangle", "dimension": 2, "points": ["a", "b", "c"],
            "constraints": [{"id": "ab", "type": "distance", "between": ["a", "b"], "length": 3},
                            {"id": "bc", "type": "distance", "between": ["b", "c"], "length": 4},
                            {"id": "ca", "type": "distance", "between": ["c", "a"], "length": 5}],
            "sketch": {"a": [0, 0], "b": [3, 0], "c": [3, -4]}}


def corner(length):
    """c where ca is that long, below a–b as in the sketch."""
    x = (9 + length * length - 16) / 6
    return [x, -math.sqrt(length * length - x * x)]


class Follow(command_line.CommandLine):
    def followed(self, instance, *options, code=DONE):
        done = run("follow", instance, *options, "--out", "-")
        self.assertEqual((done.returncode, done.stderr), (code, ""))
        return json.loads(done.stdout)["legs"]

    def assert_at(self, leg, length):
        self.assertEqual((leg["end"], leg["reason"]), ("reached", ""))
        self.assertLess(math.dist(leg["figure"]["points"]["c"], corner(length)), 1e-13)

    def test_a_triangle_follows_its_side(self):
        triangle = self.write(TRIANGLE, "triangle.json")
        for proof in ("on", "off"):
            leg, = self.followed(triangle, "--to", "ca=6.5", "--proof", proof)
            self.assert_at(leg, 6.5)
            self.assertEqual(leg["proven"], proof == "on")
            self.assertEqual(leg["to"], {"ca": 6.5})

    def test_a_fold_is_enclosed(self):
        triangle = self.write(TRIANGLE, "triangle.json")
        leg, = self.followed(triangle, "--to", "ca=8")
        low, high = leg["fold"]["values"]["ca"]
        self.assertTrue(leg["proven"] and low <= 7 <= high < low + 1e-9, leg)
        low, high = leg["fold"]["t"]
        self.assertTrue(low <= 2 / 3 <= high < low + 1e-9, leg)
        self.assertEqual((leg["beyond"]["status"], leg["beyond"]["solutions"]), ("complete", []))
        text = run("follow", triangle, "--to", "ca=8").stdout
        self.assertIn("folds, proven", text)
        self.assertIn("0 solutions on S", text)

    def test_a_polyline_ends_at_its_first_fold(self):
        triangle = self.write(TRIANGLE, "triangle.json")
        legs = self.followed(triangle, "--to", "ca=6,4.5,7.5,5")
        self.assertEqual([leg["end"] for leg in legs], ["reached", "reached", "folds"])
        self.assert_at(legs[0], 6)
        self.assert_at(legs[1], 4.5)
        text = run("follow", triangle, "--to", "ca=6,4.5,7.5,5").stdout
        self.assertIn("2 of 4 reached", text)
        self.assertEqual(sum(line.startswith("  end") for line in text.splitlines()), 3)

    def test_from_a_solution_of_a_result_there_and_back(self):
        result = self.folder / "result.json"
        self.assertEqual(run("solve", "k33", "--strategy", "monodromy", "--out", result).returncode, DONE)
        stored = json.loads(result.read_text())
        real = [one for one in stored["solutions"] if one["real"]]
        one = stored["instance"]["constraints"][0]
        form = "length" if "length" in one else "squared"
        for number, solution in enumerate(real, 1):
            to = f"{one['id']}={one[form] * 1.001!r},{one[form]!r}"
            legs = self.followed("k33", "--from", f"{result}:{number}", "--to", to)
            self.assertTrue(all(leg["proven"] for leg in legs))
            if [leg["end"] for leg in legs] != ["reached", "reached"]:
                continue
            for name, place in solution["points"].items():
                self.assertLess(math.dist(legs[1]["figure"]["points"][name], place), 1e-9)

    def test_what_is_not_decided_has_a_reason(self):
        done = run("follow", self.write(TRIANGLE, "triangle.json"), "--to", "ca=7")
        self.assertEqual(done.returncode, NOT_SOLVED)
        self.assertIn("undecided: ", done.stdout)

    def test_a_line_that_the_frame_puts_on_an_axis(self):
        result = self.folder / "line.json"
        run("solve", "hoffmann-yuan", "--strategy", "theta-scan", "--out", result)
        constraint = json.loads(result.read_text())["instance"]["constraints"][0]
        to = f"{constraint['id']}={constraint['length'] * 1.001!r},{constraint['length']!r}"
        legs = self.followed("hoffmann-yuan", "--from", result, "--to", to)
        self.assertEqual([leg["end"] for leg in legs], ["reached", "reached"])
        self.assertTrue(all(leg["proven"] for leg in legs))
        for name, place in json.loads(result.read_text())["solutions"][0]["points"].items():
            self.assertLess(math.dist(legs[1]["figure"]["points"][name], place), 1e-9)

    def test_bad_input(self):
        triangle = self.write(TRIANGLE, "triangle.json")
        for options, words in ((["--to", "cd=1"], ["cd", "'ca'"]), (["--to", "ca=-1"], ["> 0"]),
                               (["--to", "ca=long"], ["ca=long"]), (["--from", self.folder / "none.json"], ["none.json"])):
            with self.subTest(options):
                self.assert_one_message(run("follow", triangle, *options), BAD_INPUT, *words)
        for options, words in ((["--to", "ca"], ["ID=VALUE"]), (["--to", "ca=1", "--to", "ca=2"], ["given twice"]),
                               (["--to", "ca=5,6", "--to", "ab=3"], ["as many"]), (["--proof", "maybe"], ["maybe"])):
            with self.subTest(options):
                self.assert_usage_error(run("follow", triangle, *options), *words)
        blank = {name: value for name, value in TRIANGLE.items() if name != "sketch"}
        self.assert_usage_error(run("follow", self.write(blank, "triangle.json")), "no sketch")


if __name__ == "__main__":
    command_line.main()
