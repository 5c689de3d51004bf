"""The program as a process, and what every test of a command checks."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = ""
SOURCE = Path()

DONE, CHECK_FAILED, BAD_INPUT, NOT_SOLVED, INTERRUPTED = 0, 1, 2, 3, 130

# A solve that takes far longer than any test waits.
ENDLESS = ["solve", "icosahedron", "--strategy", "full-space", "--set", "step_max=1e-6"]


def run(*arguments, text_in="", cwd=None):
    """Runs the program; returns the completed process with text streams."""
    return subprocess.run([PROGRAM, *map(str, arguments)], input=text_in, capture_output=True, text=True,
                          timeout=120, cwd=cwd or SOURCE, check=False)


class CommandLine(unittest.TestCase):
    """Shared checks."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, content, name="toy.json"):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        elif isinstance(content, str):
            path.write_text(content)
        else:
            path.write_text(json.dumps(content))
        return path

    def assert_one_message(self, done, code, *mentioned):
        """One line for a person on standard error, nothing on standard output."""
        self.assertEqual(done.returncode, code, done.stderr[:2000])
        self.assertEqual(done.stdout, "")
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr[:2000])
        self.assertTrue(lines[0].startswith("gcsbench: "), lines[0][:2000])
        self.assertLess(len(lines[0]), 1000)
        for word in mentioned:
            self.assertIn(str(word), lines[0])

    def repeatable_part(self, done):
        """The result on standard output but for what may differ between two runs."""
        self.assertEqual(done.returncode, DONE, done.stderr)
        result = json.loads(done.stdout)
        del result["timing"], result["environment"]
        return result

    def assert_usage_error(self, done, *mentioned):
        """A message, then the usage, on standard error."""
        self.assertEqual(done.returncode, BAD_INPUT, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertTrue(done.stderr.startswith("gcsbench: "), done.stderr)
        self.assertIn("Usage: gcsbench", done.stderr)
        for word in mentioned:
            self.assertIn(word, done.stderr)


def main():
    """Runs the tests of the script: its arguments are PROGRAM SOURCE_DIR [unittest arguments]."""
    global PROGRAM, SOURCE
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    SOURCE = Path(sys.argv.pop(1)).resolve()
    unittest.main()
