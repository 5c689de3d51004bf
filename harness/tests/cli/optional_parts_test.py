#!/usr/bin/python3
"""Parts of the build can be left out, and `gcsbench list` says which.

Usage: optional_parts_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import subprocess

import command_line
from command_line import SOURCE, run


def listed():
    return json.loads(run("list", "--json").stdout)


def option_of(strategy):
    return "GCSBENCH_WITH_" + strategy.replace("-", "_").upper()


class OptionalParts(command_line.WithFolder):
    def configure(self, *options):
        return subprocess.run(["cmake", "-S", SOURCE, "-B", self.folder, *options], capture_output=True, text=True,
                              timeout=120, check=False)

    def test_a_full_build_has_every_strategy(self):
        self.assertFalse([part for part in listed()["left_out"] if part["name"].startswith("strategy")])

    def test_every_strategy_can_be_left_out(self):
        kept, *others = [strategy["name"] for strategy in listed()["strategies"]]
        done = self.configure("-DGCSBENCH_BUILD_TESTS=OFF", "-DGCSBENCH_BUILD_BENCHMARKS=OFF",
                              *["-D" + option_of(name) + "=OFF" for name in others])
        self.assertEqual(done.returncode, 0, done.stderr)
        table = (self.folder / "generated" / "strategy_table.cpp").read_text()
        self.assertIn(kept.replace("-", "_") + "_entry()", table)
        for name in others:
            self.assertNotIn(name.replace("-", "_") + "_entry()", table)
            self.assertIn('{"strategy ' + name + '", "' + option_of(name) + '"}', table)

    def test_tests_are_not_built_without_what_they_test(self):
        done = self.configure("-DGCSBENCH_WITH_RCP=OFF")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("GCSBENCH_BUILD_TESTS=OFF", done.stderr)


if __name__ == "__main__":
    command_line.main()
