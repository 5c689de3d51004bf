"""The program as a process, and what every test of a command checks."""

import importlib.machinery
import importlib.util
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# Every script of tests is called with PROGRAM SOURCE_DIR [unittest arguments].
PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), Path(sys.argv[2]).resolve()

DONE, CHECK_FAILED, BAD_INPUT, NOT_SOLVED, INTERRUPTED = 0, 1, 2, 3, 130

# A solve that takes far longer than any test waits.
ENDLESS = ["solve", "icosahedron", "--strategy", "full-space", "--set", "step_max=1e-6"]


# The path of a relative link to a file or picture, without its anchor.
LINK = re.compile(r"""(?:\]\(|src=")([^)"#:\s]+)(?:#[^)"]*)?[)"]""")


def lost_links(document):
    """Of its relative links, those that lead nowhere."""
    return [link for link in LINK.findall(document.read_text(encoding="utf-8"))
            if not (document.parent / link).exists()]


def sources():
    """(name, text) of the sources of the library and of the program, without tests and what stands beside them."""
    for house in ("solvers", "harness"):
        for path in sorted((SOURCE / house).rglob("*.[ch]pp")):
            if not {"tests", "fuzz", "benchmarks"} & set(path.relative_to(SOURCE).parts):
                yield str(path.relative_to(SOURCE)), path.read_text(encoding="utf-8")


def load_script(name):
    """A program of scripts/ as a module, which sees those beside it, and is found by the processes that it starts."""
    if str(SOURCE / "scripts") not in sys.path:
        sys.path.append(str(SOURCE / "scripts"))
    loader = importlib.machinery.SourceFileLoader(name.replace("-", "_"), str(SOURCE / "scripts" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    sys.modules[loader.name] = module
    loader.exec_module(module)
    return module


def argv(*arguments):
    return [PROGRAM, *map(str, arguments)]


def run(*arguments, text_in="", cwd=SOURCE):
    """Runs the program; returns the completed process with text streams."""
    return subprocess.run(argv(*arguments), input=text_in, capture_output=True, text=True, timeout=300, cwd=cwd,
                          check=False)


class WithFolder(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class CommandLine(WithFolder):
    """Shared checks."""

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


def main(**how):
    """Runs the tests of the script that was called."""
    return unittest.main(argv=[sys.argv[0], *sys.argv[3:]], **how)
