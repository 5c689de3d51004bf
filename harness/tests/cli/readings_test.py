#!/usr/bin/python3
"""scripts/sweep-readings reads the printed icosahedron in every way it says, and counts what full-space finds.

Usage: readings_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import unittest

import command_line
from command_line import PROGRAM, SOURCE

sweep_readings = command_line.load_script("sweep-readings")


class Readings(unittest.TestCase):
    def test_the_readings_are_those_of_one_edge_from_vertex_8_to_vertex_10(self):
        printed = json.loads((SOURCE / "instances" / "icosahedron-printed.json").read_text(encoding="utf-8"))
        graphs = dict(sweep_readings.graphs(printed))
        # Vertex 8 has six neighbours; 10 itself and two that it shares with 10 cannot move.
        self.assertEqual(len(graphs), 1 + 3)
        corrected = json.loads((SOURCE / "instances" / "icosahedron.json").read_text(encoding="utf-8"))
        self.assertTrue(sweep_readings.is_icosahedron(corrected))
        self.assertEqual([graph for graph, instance in graphs.items() if sweep_readings.is_icosahedron(instance)],
                         ["11-8 as 11-10"])

    def test_a_sample_has_the_proven_numbers(self):
        # 30 bent constraints for each of two sketches of each graph. Proven by the tubes of mode=certified: 284 as
        # printed, 72 and 174 with 11-10, for p4 at 11 and at 1.1.
        last = [30 * number + 29 for number in (0, 4, 5)]
        self.assertEqual(list(sweep_readings.sweep(PROGRAM, last).values()), [284, 72, 174])

    def test_what_does_not_close_is_told_apart(self):
        text = sweep_readings.text({("g", 1, "1-2"): 32, ("g", 1, "2-3"): "gave up: too far", ("g", 1, "1-3"): 4},
                                   {"commit": "c", "compiler": "g++", "cpu": "toy"})
        self.assertIn("S closes for 2 of them, with 32 solutions for 1: the edge g, p4 at 1, 1-2 bent.", text)
        self.assertIn("| g | 1 | 4 | 4 (1), 32 (1) | 1 gave up: too far |", text)


if __name__ == "__main__":
    command_line.main()
