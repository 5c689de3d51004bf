#!/usr/bin/python3
"""The commands that the documents show can be copied from them, and the files that texts and comments name are there.

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
from command_line import PROGRAM, SOURCE, lost_links

NAMED = re.compile(r"\b\w+(?:/\w+)*\.[ch]pp\b")
PLACE = re.compile(r"(?<![\w/.-])(?:harness|instances|results|scripts|solvers)(?:/[\w-]+(?:\.\w+)*(?![\w<*{-]|\.\w))+")
# By scripts/new-strategy, by the installation, and by runs.
MADE = ("my_idea.cpp", "gcsbench/gcsbench.hpp")
MADE_PLACE = "results/runs"


def texts(*endings):
    for top in ("README.md", "harness", "instances", "results", "scripts", "solvers"):
        for path in [SOURCE / top] if "." in top else sorted((SOURCE / top).rglob("*")):
            if path.suffix in endings and "runs" not in path.relative_to(SOURCE).parts:
                yield path, path.read_text(encoding="utf-8")


def without_directives(path, text):
    """Those of the preprocessor; in Markdown such lines are headings."""
    return text if path.suffix == ".md" else re.sub(r"^\s*#.*$", "", text, flags=re.M)


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

    def test_sources_that_comments_and_documents_name_are_there(self):
        sources = [f"/{path.relative_to(SOURCE)}" for path, _ in texts(".cpp", ".hpp", ".in")]
        sources += [source.removesuffix(".in") for source in sources]
        lost = [f"{path.relative_to(SOURCE)}: {name}" for path, text in texts(".cpp", ".hpp", ".md")
                for name in NAMED.findall(without_directives(path, text))
                if not name.endswith(MADE) and not any(source.endswith(f"/{name}") for source in sources)]
        self.assertEqual(lost, [])

    def test_places_that_comments_and_documents_name_are_there(self):
        lost = [f"{path.relative_to(SOURCE)}: {place}" for path, text in texts(".cpp", ".hpp", ".md")
                for place in PLACE.findall(without_directives(path, text))
                if not place.startswith(MADE_PLACE) and not place.endswith(MADE) and not (SOURCE / place).exists()]
        self.assertEqual(lost, [])

    def test_links_lead_somewhere(self):
        lost = [f"{path.relative_to(SOURCE)}: {link}" for path, _ in texts(".md") for link in lost_links(path)]
        self.assertEqual(lost, [])

    def test_the_front_page_has_the_verdicts_of_the_tables(self):
        def rows(text):
            return [[cell.strip() for cell in line.split("|")[1:6]] for line in text.splitlines() if line.startswith("|")]
        front = (SOURCE / "README.md").read_text(encoding="utf-8")
        shown = rows(front.split("<!-- verdicts -->")[1].split("<!-- end of verdicts -->")[0])[2:]
        measured = rows((SOURCE / "results" / "tables" / "verdicts.md").read_text(encoding="utf-8"))
        self.assertEqual(len(shown), 12)
        for row in shown:
            self.assertIn(row, measured)


if __name__ == "__main__":
    command_line.main()
