#!/usr/bin/python3
"""scripts/sweep-order: its orders, on a graph by hand, and what it reads of a scene.

Usage: order_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import random
import unittest

import command_line
from command_line import PROGRAM

sweep = command_line.load_script("sweep-order")


def by_hand():
    # a joins 0 with 1 and 2 with 3, b joins 1 with 2, c nothing, and nothing leads to 4.
    curves = [("a", {0, 1}), ("a", {2, 3}), ("b", {1, 2})]
    alone = [("a", {4}), ("b", {0}), ("b", {3}), ("b", {4})] + [("c", {solution}) for solution in range(5)]
    return sweep.Graph(5, [(value, frozenset(members)) for value, members in curves + alone])


class Order(unittest.TestCase):
    def needed(self, order):
        return sweep.played(by_hand(), 0, 4, order(by_hand(), 0, random.Random(1)))

    def test_only_what_curves_lead_to_is_reached(self):
        self.assertEqual(by_hand().reach(3), {0, 1, 2, 3})
        self.assertEqual(by_hand().reach(4), {4})

    def test_the_plain_order_counts_every_curve_of_its_rounds(self):
        # a, b, c from 0; of a nothing is open then, b and c from 1; a from 2.
        self.assertEqual(self.needed(sweep.Plain), [1, 6, 6])

    def test_who_foresees_walks_only_what_leads_on(self):
        self.assertEqual(self.needed(sweep.Foreseen), [1, 3, 3])

    def test_every_order_comes_to_the_same_end(self):
        for order in sweep.ORDERS.values():
            needed = self.needed(order)
            self.assertEqual((needed[0], len(needed)), (1, len(sweep.PARTS)), order)
            self.assertLessEqual(needed[-1], 9, order)

    def test_all_curves_of_a_shipped_scene_are_read(self):
        graph = sweep.walked(PROGRAM, "disulfide")
        self.assertEqual((graph.size, len(graph.values)), (18, 18))
        self.assertEqual(len(graph.on_curve), 18 * 18)
        rows = list(sweep.rows("disulfide", [graph]))
        self.assertEqual([row[3] for row in rows], [*sweep.ORDERS])

    def test_a_scene_with_too_few_solutions_has_no_order(self):
        self.assertIsNone(sweep.walked(PROGRAM, sweep.sweeping.random_scene(8, 1)[0]))


if __name__ == "__main__":
    command_line.main()
