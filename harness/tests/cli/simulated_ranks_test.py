#!/usr/bin/python3
"""scripts/simulate-ranks: what is simulated is what the program does.

Usage: simulated_ranks_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
from unittest import mock

import command_line
from command_line import PROGRAM, SOURCE, run

simulate_ranks = command_line.load_script("simulate-ranks")


class SimulatedRanks(command_line.WithFolder):
    def test_the_journal_has_all_paths_with_their_steps(self):
        journal, out = self.folder / "journal", self.folder / "result.json"
        run("--quiet", "solve", "disulfide", "--strategy", "monodromy", "--resume", journal, "--out", out)
        result = json.loads(out.read_text())
        blocks, unknowns = simulate_ranks.steps_of(journal)
        work, counts = result["statistics"], result["counts"]
        self.assertEqual(unknowns, 3 * 8 - 6)
        self.assertGreaterEqual(sum(map(len, blocks)), work["loop_paths"] + counts["paths"])  # a path is followed in legs
        steps, all_steps = sum(map(sum, blocks)), work["iterations"] + work["rejected_steps"]
        self.assertLessEqual(steps, all_steps)
        self.assertGreater(steps, 0.97 * all_steps)  # the others are of paths that were followed again

    def test_lanes_take_the_next_path_when_theirs_ends(self):
        for steps, lanes, rounds in (([5, 1, 1, 1], 2, 5), ([1, 1, 1, 5], 2, 6), ([3] * 10, 1, 30)):
            self.assertEqual(simulate_ranks.Machine(1, 0, 0, 0, lanes).solve_s([([steps], 1)], 1), rounds)

    def test_equal_ranks_share_paths(self):
        with mock.patch.multiple(simulate_ranks, LATENCY_S=0, HANDLING_S=0):
            machine = simulate_ranks.Machine(1, 0, 0, 0, 1)
            self.assertEqual(machine.solve_s([([[10] * 16], 1)], 4), 160)  # too few to send
            for ranks in (2, 3, 4):
                whole = machine.solve_s([([[10] * 6400], 1)], ranks)
                self.assertGreaterEqual(whole, 64000 / ranks)
                self.assertLess(whole, 64000 / ranks + 160)  # but for the last ones
            self.assertEqual(machine.solve_s([([[10] * 6400], 1)], 1), 64000)

    def test_blocks_side_by_side_leave_nobody_idle_while_one_is_sorted_in(self):
        with mock.patch.multiple(simulate_ranks, LATENCY_S=0, HANDLING_S=0):
            machine = simulate_ranks.Machine(1, 1, 0, 0, 1)
            blocks = [[10] * 320] * 20
            one_by_one, side_by_side = (machine.solve_s([(blocks, number)], 2) for number in (1, 2))
        self.assertGreaterEqual(one_by_one, 20 * (1600 + 320))
        self.assertGreaterEqual(side_by_side, 20 * (3200 + 320) / 2)
        self.assertLess(side_by_side, 1.05 * 20 * (3200 + 320) / 2)

    def test_stages_are_told_by_their_paths(self):
        blocks = [[1] * 100] * 3 + [[1] * 32] * 2 + [[1] * 3] * 5  # 320 were handed out in the search: the last 20 in vain
        result = {"statistics": {"loop_paths": 320}, "counts": {"paths": 32}}
        stages = simulate_ranks.stages_of(blocks, result)
        self.assertEqual([(len(some), number) for some, number in stages], [(3, 8), (2, 3), (5, 2)])

    def test_a_lane_takes_paths_of_the_next_item_when_its_own_ends(self):
        ends = [0.0, 0.0]
        self.assertEqual(simulate_ranks.follow(ends, [5, 1], 0.0, 1), 5)
        self.assertEqual(simulate_ranks.follow(ends, [2, 2], 0.0, 1), 5)
        self.assertEqual(sorted(ends), [5, 5])
        self.assertEqual(simulate_ranks.follow(ends, [1], 7.0, 1), 8)  # that comes later


if __name__ == "__main__":
    command_line.main()
