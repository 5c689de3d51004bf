#!/usr/bin/python3
"""scripts/scaling: its graphs, what it takes from solves, and its table.

Usage: scaling_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import importlib.util
import random
import unittest

import command_line
from command_line import PROGRAM

scaling = command_line.load_script("scaling")
sweep_unit_lengths = command_line.load_script("sweep-unit-lengths")


class Scaling(command_line.WithFolder):
    def test_graphs_are_minimally_rigid_and_nothing_hangs(self):
        rigid = sweep_unit_lengths.rigid_graphs(7, 2)
        for seed in range(20):
            edges = scaling.sweeping.random_graph(7, random.Random(seed))
            self.assertIn(sweep_unit_lengths.canonical(edges, 7), rigid)
            self.assertGreaterEqual(min(sum(point in edge for edge in edges) for point in range(7)), 3)

    def test_what_is_counted_is_found_and_proven(self):
        for seed in (1, 2):
            problem = scaling.instance(f"random-8-{seed}")
            classes, count = scaling.counted(PROGRAM, problem)
            solve = scaling.solved(PROGRAM, problem)
            self.assertTrue(solve.is_complete)
            self.assertEqual(solve.classes, classes)
            proven, real, all_proven, took = scaling.certified(PROGRAM, problem)
            self.assertEqual((proven, all_proven), (classes, True))
            self.assertGreaterEqual(real, 1)  # the figure of which the lengths are
            self.assertTrue(all(0 < one.peak_bytes < 1e9 and one.cpu_s < 100 for one in (count, took)))

    def test_more_loops_are_tried_where_the_number_is_known(self):
        # A graph of which the first loops reach half.
        problem = scaling.instance("random-11-6")
        solve = scaling.solved(PROGRAM, problem)
        self.assertTrue(solve.is_complete)
        self.assertEqual(solve.classes, scaling.counted(PROGRAM, problem)[0])

    def test_a_code_is_the_upper_triangle_of_the_adjacency_matrix(self):
        # The prism: OEIS A306420 has 24 for 6 points at 7916.
        problem = scaling.instance("coded-6-7916")
        self.assertEqual(len(problem["constraints"]), 9)
        self.assertEqual(scaling.counted(PROGRAM, problem)[0], 12)

    def test_rows_that_are_not_measured_stay(self):
        scaling.TABLE = self.folder / "scaling.md"
        scaling.TABLE.write_text("growth" + scaling.whole_text(["| coded-18 | 1 |", "| random-8-1 | 2 |"]), encoding="utf-8")
        scaling.write_whole(PROGRAM, "random-8-1")
        growth, rows = scaling.parts()
        self.assertEqual((growth, rows[0], len(rows)), ("growth", "| coded-18 | 1 |", 2))
        count = scaling.counted(PROGRAM, scaling.instance("random-8-1"))[0]
        self.assertRegex(rows[1], rf"^\| random-8-1 \| {count} \| .* \| {count} \| [0-9]+ \| yes \| ")

    def test_the_table_and_the_plot_show_medians(self):
        solves = [scaling.Solve(10, True, 100, paths, 5000, s, 10**9, {}) for paths, s in ((300, 0.01), (200, 0.02), (400, 0.03))]
        stopped = scaling.Solve(10, False, 900, 100, 4000, 0.04, 10**9, {})
        row = scaling.scaling_row(10, [*solves, stopped])
        self.assertEqual(scaling.cells(row), [10, 4, 3, "100", "0.02", "3", "11.2", "5", "50", "1e+04"])
        row = scaling.scaling_row(10, [stopped])
        self.assertEqual(scaling.line(scaling.cells(row)), "| 10 | 1 | 0 | – | – | – | 4 | 10 | 100 | – |")

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs python3-matplotlib")
    def test_the_plot_is_a_picture(self):
        row = scaling.scaling_row(10, [scaling.Solve(10, True, 100, 300, 5000, 0.01, 10**9, {})])
        scaling.plot([row], self.folder / "scaling.svg")
        self.assertIn("<svg", (self.folder / "scaling.svg").read_text())


if __name__ == "__main__":
    command_line.main()
