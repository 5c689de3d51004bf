#!/usr/bin/python3
"""What a solve keeps for later runs: the journal of --resume, and start systems.

Usage: kept_files_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import signal
import subprocess
import time

import command_line
from bad_instances import TOY
from command_line import BAD_INPUT, INTERRUPTED, NOT_SOLVED, SOURCE, argv, run


class Journal(command_line.CommandLine):
    SOLVE = ["solve", "dodecagon", "--strategy", "monodromy", "--out", "-"]

    def interrupted(self, journal, sent):
        """Starts to solve and sends the signal once some results are in the journal."""
        solve = argv(*self.SOLVE, "--resume", journal)
        with subprocess.Popen(solve, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              cwd=SOURCE) as process:
            while process.poll() is None and (not journal.exists() or journal.stat().st_size < 1 << 18):
                time.sleep(0.01)
            process.send_signal(sent)
        return process.returncode

    def test_an_interrupted_solve_goes_on(self):
        journal = self.folder / "run.journal"
        whole = self.repeatable_part(run(*self.SOLVE, "--threads", 2))
        for sent, code in [(signal.SIGKILL, -signal.SIGKILL), (signal.SIGTERM, INTERRUPTED)]:
            with self.subTest(sent):
                journal.unlink(missing_ok=True)
                self.assertEqual(self.interrupted(journal, sent), code, "too late: the instance is too small")
                size = journal.stat().st_size
                done = run(*self.SOLVE, "--resume", journal, "--threads", 2)
                self.assertEqual(self.repeatable_part(done), whole)
                self.assertGreater(json.loads(done.stdout)["timing"]["recalled_steps"], 0)
                self.assertGreater(journal.stat().st_size, size)
        finished = journal.read_bytes()
        self.assertEqual(self.repeatable_part(run(*self.SOLVE, "--resume", journal)), whole)
        self.assertEqual(journal.read_bytes(), finished)
        done = run(*self.SOLVE, "--resume", journal, "--seed", 2)
        self.assert_one_message(done, BAD_INPUT, journal, "another run", "seed")
        self.assertEqual(journal.read_bytes(), finished)

    def test_places_where_none_can_be_kept(self):
        solve = ["solve", "octahedron", "--strategy", "monodromy", "--resume"]
        self.assert_one_message(run(*solve, self.write(TOY)), BAD_INPUT, "toy.json", "no journal")
        self.assertEqual(json.loads((self.folder / "toy.json").read_text()), TOY)
        self.assert_one_message(run(*solve, self.folder / "missing" / "x"), BAD_INPUT, "cannot be written")
        self.assert_one_message(run(*solve, self.folder), BAD_INPUT, "cannot be written")

    def test_a_strategy_without_a_journal_says_so(self):
        done = run("solve", "octahedron", "--strategy", "full-space", "--resume", self.folder / "x.journal")
        self.assert_usage_error(done, "--resume", "full-space keeps no journal", "monodromy")
        self.assertFalse((self.folder / "x.journal").exists())

    def test_none_is_begun_with_options_that_are_refused(self):
        journal = self.folder / "journal"
        done = run("solve", "octahedron", "--strategy", "monodromy", "--set", "arcs=1", "--resume", journal)
        self.assert_one_message(done, BAD_INPUT, "arcs=1")
        self.assertFalse(journal.exists())


class StartSystems(command_line.CommandLine):
    SOLVE = ["solve", "octahedron", "--strategy", "monodromy", "--out", "-", "--set"]

    def test_are_written_and_read(self):
        start = self.folder / "start.json"
        solutions = self.repeatable_part(run(*self.SOLVE, f"save_start={start}"))["solutions"]
        self.assertEqual(json.loads(start.read_text())["format"], "gcsbench-start/1")
        self.assertEqual(self.repeatable_part(run(*self.SOLVE, f"start={start}"))["solutions"], solutions)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["start.json"])

    def test_a_search_without_an_end_leaves_the_old_one(self):
        start = self.write("old", "start.json")
        done = run("solve", "icosahedron", "--strategy", "monodromy", "--set", f"save_start={start}",
                   "--time-limit", 0.5)
        self.assertEqual(done.returncode, NOT_SOLVED, done.stderr)
        self.assertEqual(start.read_text(), "old")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["start.json"])

    def test_of_several_parts_none_is_kept(self):
        start = self.folder / "start.json"
        done = run("solve", "octahedra@2", "--strategy", "monodromy", "--set", f"save_start={start}")
        self.assert_one_message(done, BAD_INPUT, start, "several parts", "reduce=off")
        self.assertFalse(start.exists())
        done = run("solve", "octahedra@2", "--strategy", "monodromy", "--set", f"save_start={start}", "--set",
                   "reduce=off")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(start.exists())

    def test_what_is_none_is_refused(self):
        self.assert_one_message(run(*self.SOLVE, f"start={self.write(TOY)}"), BAD_INPUT, "toy.json", "/format")
        self.assert_one_message(run(*self.SOLVE, f"start={self.folder}"), BAD_INPUT, self.folder, "a directory")
        done = run(*self.SOLVE, f"save_start={self.folder / 'none' / 'start.json'}")
        self.assert_one_message(done, BAD_INPUT, "cannot be written")
        done = run(*self.SOLVE, "start=a.json", "--set", "save_start=b.json")
        self.assert_one_message(done, BAD_INPUT, "start=a.json", "save_start=b.json")


if __name__ == "__main__":
    command_line.main()
