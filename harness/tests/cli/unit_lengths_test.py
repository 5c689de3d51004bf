#!/usr/bin/python3
"""scripts/sweep-unit-lengths makes every minimally rigid graph once, and says how each solve ends.

Usage: unit_lengths_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import random
import unittest

import command_line
from command_line import PROGRAM, run

sweep_unit_lengths = command_line.load_script("sweep-unit-lengths")

K33 = [(a, b) for a in range(3) for b in range(3, 6)]
PRISM = [(0, 1), (1, 2), (0, 2), (3, 4), (4, 5), (3, 5), (0, 3), (1, 4), (2, 5)]


class UnitLengths(unittest.TestCase):
    def test_the_graphs_are_as_many_as_there_are(self):
        # OEIS A227117, A328419
        for dimension, numbers in ((2, [1, 1, 1, 3, 13, 70]), (3, [1, 1, 1, 4, 26])):
            self.assertEqual(numbers, [len(sweep_unit_lengths.rigid_graphs(points, dimension))
                                       for points in range(dimension, dimension + len(numbers))])
        self.assertIn(sweep_unit_lengths.canonical(K33, 6), sweep_unit_lengths.rigid_graphs(6, 2))

    def test_a_canonical_form_does_not_depend_on_names_and_tells_graphs_apart(self):
        dice = random.Random(1)
        for graph in (K33, PRISM):
            for _ in range(20):
                names = dice.sample(range(6), 6)
                renamed = [(names[a], names[b]) for a, b in graph]
                dice.shuffle(renamed)
                self.assertEqual(sweep_unit_lengths.canonical(renamed, 6), sweep_unit_lengths.canonical(graph, 6))
        self.assertNotEqual(sweep_unit_lengths.canonical(K33, 6), sweep_unit_lengths.canonical(PRISM, 6))

    def test_solves_end_as_they_must_and_others_are_listed(self):
        found = sweep_unit_lengths.sweep(PROGRAM, sweep_unit_lengths.rigid_graphs(5, 2), 5, 2)
        # Three equilateral triangles side by side do not move. Where of two, folded together, opposite corners coincide, a
        # point that hangs on both turns about them.
        self.assertEqual(sorted(result["status"] for _, result, _ in found), ["complete", "complete", "infinite"])
        text = sweep_unit_lengths.text([("plane, 5 points", found)])
        self.assertIn("| plane, 5 points | 3 | 2 | 1 | 0 | 4 |", text)
        self.assertTrue(text.endswith("## Others\n\nNone.\n"))
        found[0][1].update(status="partial", reason="two paths failed")
        self.assertIn("plane, 5 points: 0-1", sweep_unit_lengths.text([("plane, 5 points", found)]))
        self.assertIn("two paths failed", sweep_unit_lengths.text([("plane, 5 points", found)]))

    def test_what_grows_with_the_square_of_the_way_that_is_left_is_at_infinity(self):
        """Two rhombi at a point, the opposite ones a bar apart: a triangle with the sides 1 and twice 0 or √3, so twice √3. It and
        the rhombi may be turned over, and p7 is on p0 or p3: 8 up to reflection. With a rhombus folded the rest is at infinity."""
        rhombi = [(0, 1), (0, 2), (0, 4), (0, 5), (1, 2), (1, 3), (1, 7), (2, 3), (2, 7), (3, 6), (4, 5), (4, 6), (5, 6)]
        problem = json.dumps(sweep_unit_lengths.instance(rhombi, 8, 2))
        for seed in ("1", "2", "6"):
            solve = run("--quiet", "solve", "-", "--strategy", "monodromy", "--seed", seed, "--out", "-", text_in=problem)
            result = json.loads(solve.stdout)
            self.assertEqual((result["reason"], result["status"], result["counts"]["complex"]), ("", "complete", 8))


if __name__ == "__main__":
    command_line.main()
