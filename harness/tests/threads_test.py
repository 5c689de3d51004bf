#!/usr/bin/python3
"""More threads give the same result, byte for byte. Under the thread sanitizer: without a data race.

Usage: threads_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import tempfile
import unittest
from pathlib import Path

import command_line


def run(*arguments):
    done = command_line.run(*arguments)
    if done.returncode != 0 or done.stderr:
        raise AssertionError(f"{arguments} gave {done.returncode}: {done.stderr[-4000:]}")
    return done.stdout


def solved(threads, *arguments):
    result = json.loads(run("solve", *arguments, "--threads", str(threads), "--quiet", "--out", "-"))
    del result["timing"], result["environment"]
    return result


class Threads(unittest.TestCase):
    def assert_same(self, *arguments):
        with self.subTest(arguments):
            self.assertEqual(solved(1, *arguments), solved(4, *arguments))

    def test_loops_of_monodromy(self):
        self.assert_same("disulfide", "--strategy", "monodromy")

    def test_paths_of_polyhedral_homotopies(self):
        for formulation in ["spheres", "coordinates"]:
            self.assert_same("k33", "--strategy", "polyhedral", "--set", f"formulation={formulation}")

    def test_certificates(self):
        self.assert_same("octahedron", "--strategy", "monodromy", "--certify")

    def test_a_solve_that_is_stopped(self):
        done = command_line.run("solve", "icosahedron", "--strategy", "monodromy", "--threads", "4", "--quiet",
                                "--time-limit", "1")
        self.assertEqual((done.returncode, done.stderr.count("WARNING")), (3, 0), done.stderr)

    def test_proofs_of_a_reference(self):
        with tempfile.TemporaryDirectory() as folder:
            result = str(Path(folder) / "disulfide.json")
            run("solve", "disulfide", "--strategy", "monodromy", "--quiet", "--out", result)
            run("verify", result, "--quiet")


if __name__ == "__main__":
    command_line.main()
