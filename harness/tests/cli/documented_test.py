#!/usr/bin/python3
"""The commands that the documents show can be copied from them.

Usage: documented_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE


class Documented(unittest.TestCase):
    def test_an_instance_of_ones_own_from_nothing_to_solved(self):
        text = (SOURCE / "instances" / "README.md").read_text(encoding="utf-8")
        script = re.search(r"```sh\n(.*?)```", text, re.DOTALL).group(1)
        path = f"{Path(PROGRAM).parent}:{os.environ['PATH']}"
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["bash", "-eu", "-c", script], capture_output=True, text=True, timeout=120, cwd=folder,
                                  env={**os.environ, "PATH": path}, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        # At most six assembly modes (K. H. Hunt, 1983) for each orientation of the triangle.
        self.assertIn("12 of 12 solutions exist", done.stdout)
        self.assertIn("proven: the exact number of 12 is met", done.stdout)
        self.assertRegex(done.stdout, r"platform, rcp: complete\n +on path +2 solutions")

    @unittest.skipUnless(shutil.which("doxygen"), "doxygen is not installed")
    def test_pages_of_the_public_headers_are_made_without_a_warning(self):
        settings = (SOURCE / "scripts" / "Doxyfile").read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["doxygen", "-"], input=f"{settings}\nOUTPUT_DIRECTORY = {folder}\n", cwd=SOURCE,
                                  capture_output=True, text=True, timeout=120, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            for page in ("classgcs_1_1Problem", "structgcs_1_1Answer", "structgcs_1_1Monodromy"):
                self.assertTrue((Path(folder) / "html" / f"{page}.html").is_file(), page)


if __name__ == "__main__":
    command_line.main()
