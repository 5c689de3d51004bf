#!/usr/bin/python3
"""scripts/sweep-components: its scenes, its ways, and its table.

Usage: components_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import math
import random
import unittest

import command_line
from command_line import PROGRAM

sweep = command_line.load_script("sweep-components")


class Components(unittest.TestCase):
    def test_the_known_figure_is_reached_and_all_others_from_there(self):
        # All of its solutions are on one component.
        scene = sweep.measured(PROGRAM, 8, 1)
        self.assertEqual((scene.real, scene.reached, scene.ways), (6, 6, {}))

    def test_mirror_images_are_one_solution(self):
        known = sweep.Solutions()
        points = sweep.sweeping.random_figure(5, random.Random(1))
        known.add({"points": points})
        mirrored = {name: [7 - x, y + 1] for name, (x, y) in points.items()}
        self.assertEqual(known.number_of({"points": mirrored})[0], 0)
        mirrored["p3"][0] += 1e-4
        self.assertEqual(known.number_of({"points": mirrored})[0], -1)

    def test_two_values_leave_the_known_figure_along_a_line_and_come_back(self):
        problem, dice = sweep.sweeping.random_scene(8, 4)
        pair = problem["constraints"][0], problem["constraints"][5]
        sketch = sweep.beside(PROGRAM, problem, pair, dice)
        for constraint in problem["constraints"]:
            ratio = math.dist(*(sketch[name] for name in constraint["between"])) / constraint["length"]
            self.assertAlmostEqual(ratio, 1, delta=sweep.NEAR + 1e-9 if constraint in pair else 1e-9)
        known = sweep.Solutions()
        known.add({"points": problem["sketch"]})
        result = sweep.on_path(PROGRAM, problem, {}, sketch)
        self.assertIn(0, [known.number_of(solution)[0] for solution in result["solutions"]])

    def test_rows_count_what_was_missing(self):
        def ways(*numbers):
            return {way: sweep.Found(set(of), 3, 0.5) for way, of in zip(sweep.WAYS, numbers)}
        scenes = [sweep.Scene(6, 6, {}), sweep.Scene(8, 4, ways({1, 2, 3}, {1}, ())), sweep.Scene(4, 2, ways({1}, (), ()))]
        self.assertEqual([row[1:] for row in sweep.rows(8, scenes)],
                         [[3, 2, 6, "random starts", 4, 2, 6, "1.00"], [3, 2, 6, "S, each constraint bent", 1, 1, 6, "1.00"],
                          [3, 2, 6, "two values released", 0, 0, 6, "1.00"]])


if __name__ == "__main__":
    command_line.main()
