#!/usr/bin/python3
"""scripts/new-strategy makes a strategy that compiles without warnings, is listed, and keeps the contract.

The sources are copied, the script is run in the copy, and CMake configures it: that writes the table of strategies.
Only the new strategy and the table are compiled, by the commands of this build, and linked in place of the table in
its libraries with the objects of the program and of the contract tests. A build from nothing does the same with
every other file compiled anew, of which none has changed.

Usage: new_strategy_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE

BUILD = Path(PROGRAM).parent.parent

NAME = "my-idea"
CONTRACT = ["every strategy supports an instance",
            "all instances are solved as claimed, stopped, repeated and restated, and strategies agree"]


def run(*command, **how):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=False, **how)


class Copy:
    """The sources in a folder of their own."""

    def __init__(self, folder):
        self.root = Path(folder) / "source"
        kept = [path for path in SOURCE.iterdir() if path.name not in ("build", ".git", "results")]
        self.root.mkdir()
        for path in kept:
            (shutil.copytree if path.is_dir() else shutil.copy)(path, self.root / path.name)

    def new_strategy(self, *names):
        return run(self.root / "scripts" / "new-strategy", *names, cwd=self.root.parent)

    def content(self):
        return {path.relative_to(self.root): path.read_bytes()
                for path in (self.root / "solvers").rglob("*") if path.is_file()}


class Refusals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.copy = Copy(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_names_that_cannot_be_or_are_taken_change_nothing(self):
        before = self.copy.content()
        for name in ["", "MyIdea", "my_idea", "9lives", "-x", "x-", "a--b", "a/b", "../a", "a b", "é", "tbb", "rcp",
                     "newton-multistart"]:
            done = self.copy.new_strategy(name)
            self.assertEqual(done.returncode, 2, name)
            self.assertEqual(done.stdout, "", name)
            self.assertEqual(done.stderr.count("\n"), 1, name)
            self.assertIn(f"'{name}'" if name != "rcp" and name != "newton-multistart" else "already", done.stderr)
        self.assertEqual(self.copy.content(), before)

    def test_one_name_is_needed(self):
        before = self.copy.content()
        for names in [[], ["a", "b"]]:
            done = self.copy.new_strategy(*names)
            self.assertEqual(done.returncode, 2)
            self.assertIn("Usage", done.stderr)
        self.assertEqual(self.copy.content(), before)


class NewStrategy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.copy = Copy(cls.folder.name)
        cls.made = cls.copy.new_strategy(NAME)
        cls.again = cls.copy.new_strategy(NAME)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def commands(self, target):
        """What this build runs last for a target."""
        return run("ninja", "-C", BUILD, "-t", "commands", "-s", target).stdout.strip().splitlines()[-1]

    def table(self, *options):
        """The table of strategies that CMake writes for the copy."""
        folder = Path(tempfile.mkdtemp(dir=self.folder.name))
        done = run("cmake", "-S", self.copy.root, "-B", folder, "-G", "Ninja", "-DGCSBENCH_BUILD_TESTS=OFF",
                   "-DGCSBENCH_BUILD_BENCHMARKS=OFF", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return folder / "generated" / "strategy_table.cpp"

    def compiled(self, source, like):
        """The object of `source`, compiled as this build compiles `like`, where a warning is an error."""
        target = "solvers/strategies/CMakeFiles/gcs_strategies.dir/" + like + ".o"
        words = shlex.split(self.commands(target).split("&&")[-1])
        produced = Path(self.folder.name) / (source.parent.parent.name + "-" + source.stem + ".o")
        words[words.index("-o") + 1] = str(produced)
        words[words.index("-c") + 1] = str(source)
        for option in ("-MF", "-MT"):
            words[words.index(option) + 1] = str(produced) + ".d"
        done = run(*words, "-Werror", cwd=BUILD)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return produced

    def linked(self, target, *objects):
        """The program `target` of this build with these objects in place of what its libraries have."""
        produced = Path(self.folder.name) / Path(target).name
        words = shlex.split(next(part for part in self.commands(target).split("&&") if " -o " in part))
        at = words.index("-o")
        words[at + 1] = str(produced)
        done = run(*words[:at], *objects, *words[at:], cwd=BUILD)
        self.assertEqual(done.returncode, 0, done.stderr)
        return produced

    def test_it_writes_a_source_and_a_line_once(self):
        self.assertEqual(self.made.returncode, 0, self.made.stderr)
        self.assertEqual(self.again.returncode, 2)
        lists = (self.copy.root / "solvers" / "strategies" / "CMakeLists.txt").read_text()
        self.assertEqual(lists.count("gcs_add_strategy(my_idea)\n"), 1)
        source = (self.copy.root / "solvers" / "strategies" / "my_idea.cpp").read_text()
        self.assertNotIn("@", source)
        if shutil.which("clang-format"):
            done = run("clang-format", "--dry-run", "--Werror", self.copy.root / "solvers/strategies/my_idea.cpp")
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_strategy_that_throws_is_a_fault_of_the_program(self):
        begin = "SolveReport solve(const SolveRequest& request) override {"
        text = (self.copy.root / "solvers" / "strategies" / "my_idea.cpp").read_text()
        self.assertEqual(text.count(begin), 1)
        source = Path(self.folder.name) / "broken" / "strategies" / "my_idea.cpp"
        source.parent.mkdir(parents=True)
        source.write_text(text.replace(begin, begin + '\n    if (request.seed == 1) throw std::logic_error("broken");'))
        program = self.linked("harness/gcsbench", self.compiled(source, "newton_multistart.cpp"),
                              self.compiled(self.table(), table_source()))
        for seed, code in (("1", 70), ("2", 0)):
            done = run(program, "--quiet", "solve", "k33", "--strategy", NAME, "--seed", seed, cwd=SOURCE)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual("broken" in done.stderr, code == 70)

    def test_it_compiles_is_listed_and_keeps_the_contract(self):
        strategy = self.compiled(self.copy.root / "solvers" / "strategies" / "my_idea.cpp",
                                 "newton_multistart.cpp")
        table = self.compiled(self.table(), table_source())
        program = self.linked("harness/gcsbench", strategy, table)
        listed = run(program, "list", "strategies", cwd=SOURCE).stdout
        self.assertIn(NAME, listed)
        solved = run(program, "--quiet", "solve", "k33", "--strategy", NAME, cwd=SOURCE)
        self.assertEqual(solved.returncode, 0, solved.stderr)

        others = [line.split()[0] for line in listed.splitlines() if not line.startswith(NAME)]
        alone = self.compiled(self.table(*[f"-DGCSBENCH_WITH_{name.upper().replace('-', '_')}=OFF" for name in others]),
                              table_source())
        contract = self.linked("harness/tests/contract_tests", strategy, alone)
        done = run(contract, ",".join(name.replace(",", "\\,") for name in CONTRACT), cwd=SOURCE)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:])
        self.assertIn(f"{len(CONTRACT)} test cases", done.stdout)


def table_source():
    """The table as the objects of this build are named, which lies outside the sources."""
    targets = run("ninja", "-C", BUILD, "-t", "targets", "all").stdout
    line = next(line for line in targets.splitlines() if "strategy_table.cpp.o:" in line)
    return line.split("gcs_strategies.dir/")[1].split(".o:")[0]


if __name__ == "__main__":
    if not (BUILD / "build.ninja").exists():
        print("skipped: it takes its commands from Ninja, and this build has none")
        sys.exit(77)
    command_line.main()
