#!/usr/bin/python3
"""scripts/sweep-seeds holds lists of solutions against each other, and keeps the rows of other scenes.

Usage: seeds_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import contextlib
import copy
import io
from unittest import mock

import command_line
from command_line import PROGRAM, SOURCE

sweep_seeds = command_line.load_script("sweep-seeds")


class Seeds(command_line.WithFolder):
    def sweep(self, *arguments):
        """(the exit code, the table)."""
        table = self.folder / "seeds.md"
        with mock.patch.object(sweep_seeds, "TABLE", table), mock.patch("sys.argv", ["sweep-seeds", PROGRAM, *arguments]), \
                contextlib.redirect_stdout(io.StringIO()), self.assertRaises(SystemExit) as ended:
            sweep_seeds.main()
        return ended.exception.code, table.read_text(encoding="utf-8")

    def test_a_list_is_another_where_a_solution_is_moved_missing_or_twice(self):
        first, second = (sweep_seeds.solved(PROGRAM, "disulfide", seed) for seed in (1, 2))
        known = sweep_seeds.List(first)
        self.assertEqual(len(known.places), 32)  # as many as the bound of the ring
        self.assertTrue(known.is_list_of(second))
        second["solutions"].reverse()
        self.assertTrue(known.is_list_of(second))
        moved, missing, twice = (copy.deepcopy(second) for _ in range(3))
        moved["solutions"][5]["points"]["p4"][1] = 0.25
        del missing["solutions"][7]
        twice["solutions"][3] = twice["solutions"][4]
        for other in (moved, missing, twice):
            self.assertFalse(known.is_list_of(other))

    def test_rows_of_other_scenes_stay_and_what_is_not_complete_is_named(self):
        code, table = self.sweep("2", "octahedron", "octahedral-3p3h", "platform")
        self.assertFalse(code)
        self.assertRegex(table, r"\| octahedral-3p3h \| 2 \| 2 \| 2 \| 8 \| 8 \|")  # mirror images differ in the planes alone
        self.assertRegex(table, r"\| octahedron \| 2 \| 2 \| 2 \| 8 \| 8 \|")  # 16 of six points in a frame
        self.assertRegex(table, r"\| platform \| 2 \| 2 \| 2 \| 40 \| 40 \|")
        self.assertIn("None.", table)
        solved = sweep_seeds.solved

        def losing(program, scene, seed, *options):
            result = solved(program, scene, seed, *options)
            return result | ({"status": "partial", "reason": "two paths failed"} if seed == 2 else {})

        with mock.patch.object(sweep_seeds, "solved", losing):
            code, table = self.sweep("3", "k33", "octahedron")
        self.assertTrue(code)
        self.assertIn("- k33, seed 2: partial: two paths failed\n- octahedron, seed 2: partial", table)
        self.assertRegex(table, r"\| k33 \| 3 \| 2 \| 2 \|.*\n(.*\n)?\| octahedron \| 3 \| 2 \| 2 \|.*\n\| platform \| 2 \| 2 \| 2 \|")


if __name__ == "__main__":
    command_line.main()
