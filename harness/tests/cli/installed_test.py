#!/usr/bin/python3
"""What `cmake --install` leaves can be used away from the source: the program and the library.

Usage: installed_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import math
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE, lost_links


LISTS = "project(example CXX)\nfind_package(gcsbench REQUIRED)\n" \
        "add_executable(example example.cpp)\ntarget_link_libraries(example gcsbench::solvers)\n"

class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = Path(cls.folder.name) / "prefix"
        build = Path(PROGRAM).parent.parent
        cls.compiler = cls.cache_entry(build, "CMAKE_CXX_COMPILER")
        cls.called(["cmake", "--install", build, "--prefix", cls.prefix])

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @staticmethod
    def cache_entry(build, name):
        lines = (build / "CMakeCache.txt").read_text(encoding="utf-8").splitlines()
        return next(line.split("=", 1)[1] for line in lines if line.startswith(name + ":"))

    @staticmethod
    def called(command, **options):
        done = subprocess.run(command, capture_output=True, text=True, timeout=400, check=False, **options)
        if done.returncode != 0:
            raise AssertionError(f"{command} failed: {done.stdout}{done.stderr}")
        return done.stdout

    def test_the_program_finds_its_data_where_it_was_moved_to(self):
        moved = Path(self.folder.name) / "moved"
        self.prefix.rename(moved)
        self.addCleanup(moved.rename, self.prefix)
        data = moved / "share" / "gcsbench"
        self.assertTrue((data / "results" / "published" / "hoffmann-yuan-2000.json").is_file())
        self.assertTrue((data / "results" / "reference" / "k33.json").is_file())
        # One that the source folder does not have.
        text = (data / "instances" / "k33.json").read_text(encoding="utf-8")
        (data / "instances" / "only-here.json").write_text(text.replace('"k33"', '"only-here"'), encoding="utf-8")
        described = self.called([moved / "bin" / "gcsbench", "describe", "only-here", "--json"], cwd=moved)
        self.assertEqual(json.loads(described)["id"], "only-here")

    def test_manual_and_completions_are_there(self):
        for file in ["share/man/man1/gcsbench.1", "share/bash-completion/completions/gcsbench",
                     "share/zsh/site-functions/_gcsbench", "share/fish/vendor_completions.d/gcsbench.fish"]:
            self.assertTrue((self.prefix / file).read_text(encoding="utf-8").strip(), file)

    def test_links_of_the_documents_lead_somewhere(self):
        documents = list((self.prefix / "share" / "doc" / "gcsbench").rglob("*.md"))
        self.assertIn("README.md", {document.name for document in documents})
        lost = {str(document): links for document in documents if (links := lost_links(document))}
        self.assertEqual(lost, {})

    def test_the_program_of_the_front_page_is_built_and_right(self):
        project = Path(self.folder.name) / "example"
        project.mkdir()
        (project / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\n" + LISTS, encoding="utf-8")
        readme = (SOURCE / "README.md").read_text(encoding="utf-8")
        (project / "example.cpp").write_text(re.search(r"```cpp\n(.*?)```", readme, re.DOTALL)[1], encoding="utf-8")
        self.called(["cmake", "-S", project, "-B", project / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                     f"-DCMAKE_CXX_COMPILER={self.compiler}"])
        self.called(["cmake", "--build", project / "build"])
        shown = [float(number) for number in self.called([project / "build" / "example"]).split()]
        along = (3.1**2 + 5**2 - 4**2) / (2 * 3.1)  # by the law of cosines
        self.assertEqual(len(shown), 2)
        self.assertAlmostEqual(shown[0], along, places=4)
        self.assertAlmostEqual(shown[1], math.sqrt(25 - along**2), places=4)


if __name__ == "__main__":
    command_line.main()
