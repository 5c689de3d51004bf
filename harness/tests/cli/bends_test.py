#!/usr/bin/python3
"""scripts/sweep-bends bends every constraint in every way that it says, and counts what full-space finds.

Usage: bends_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import unittest

import command_line
from command_line import PROGRAM, SOURCE

sweep_bends = command_line.load_script("sweep-bends")

INSTANCES = {instance["id"]: instance for instance in sweep_bends.with_sketch()}

# All lengths grow for growing t, and none vanishes.
GROWING = {
    "format": "gcsbench-instance/1", "id": "growing", "dimension": 2, "points": ["p1", "p2", "p3"],
    "constraints": [{"type": "distance", "between": ["p1", "p2"], "length": 2},
                    {"type": "distance", "between": ["p1", "p3"], "length": 2.2},
                    {"type": "distance", "between": ["p2", "p3"], "length": 1.9}],
    "sketch": {"p1": [0, 0], "p2": [1, 0], "p3": [0.4, 0.7]},
    "published": [{"quantity": "on path", "convention": "up to reflection", "value": 1, "source": "Euclid"}],
}


class Bends(unittest.TestCase):
    def test_every_constraint_is_bent_in_every_way_and_none(self):
        found = [(bent, bend) for bent, bend, _ in sweep_bends.choices(dict(GROWING))]
        self.assertEqual(len(found), 1 + 3 * len(sweep_bends.BENDS))
        self.assertEqual(len(set(found)), len(found))
        self.assertEqual(found[0], ("none", ""))

    def test_a_sample_has_the_numbers_of_other_programs(self):
        # By independent programs: the octahedron's S holds 4 whichever constraint is bent by 2; the disulfide's 8 with
        # 4-5 bent by 2, and with none.
        def by_two(bent, bend):
            return bend == "2" and bent in ("1-2", "4-5")
        octahedron = sweep_bends.sweep(PROGRAM, INSTANCES["octahedron"], by_two)
        self.assertEqual(set(octahedron.values()), {4})
        disulfide = sweep_bends.sweep(PROGRAM, INSTANCES["disulfide"],
                                      lambda bent, bend: bent == "none" or (bent, bend) == ("4-5", "2"))
        self.assertEqual(disulfide, {("none", ""): 8, ("4-5", "2"): 8})

    def test_where_nothing_bounds_t_the_table_says_so(self):
        found = sweep_bends.sweep(PROGRAM, GROWING)
        # A triangle has one solution up to reflection. A bent side bounds t, and S meets the triangle and its image.
        self.assertEqual(found["none", ""], "to ∞")
        self.assertEqual(found["1-2", "2"], 1)
        text = sweep_bends.text([(GROWING, found)], {"commit": "c", "compiler": "g++", "cpu": "toy"})
        self.assertIn("| none | to ∞ |", text)
        self.assertIn("in 1 of 1 instances: growing.", text)

    def test_a_summary_says_what_the_table_shows(self):
        found = {("none", ""): "to ∞", ("1-2", "2"): 1, ("1-2", "4"): "3*", ("1-3", "2"): 1}
        self.assertEqual(sweep_bends.summary(GROWING, found),
                         "Of 4 choices S closes for 3, with 1 to 3 solutions; not for 1 (to ∞: 1). The published 1 comes out "
                         "for 2 of them: 1-2 bent by 2, 1-3 bent by 2.")


if __name__ == "__main__":
    command_line.main()
