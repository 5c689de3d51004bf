#!/usr/bin/python3
"""Runs that are killed at any moment go on with --resume: nothing that was finished is lost or solved again.

Usage: killed_run_test.py PROGRAM SOURCE_DIR [unittest arguments]

With GCSBENCH_KILL_WHOLE_TABLES set in the environment also `tables all` without restriction, on the optimised
program with nothing else running: about 45 minutes.
"""

import json
import os
import random
import signal
import subprocess
import time
import unittest
from pathlib import Path

import command_line
from command_line import BAD_INPUT, DONE, NOT_SOLVED, SOURCE, argv

KILLS = 20
LIMIT_S = 120
WHOLE_TABLES_LIMIT_S = 3600
TABLES = ["tables", "all", "--instances", "k33,octahedron,hoffmann-yuan,tangents-durand",
          "--strategies", "full-space,rcp,cayley-menger,theta-scan,sphere-tangents", "--repetitions", 3]
PRECISION = ["precision", "k33", "octahedron", "--strategies", "full-space,rcp,cayley-menger", "--repetitions", 2]
STABILITY = ["stability", "near-miss", "--repetitions", 1]

# What two runs may differ in.
TIMES = ("warm_up_s", "estimate_s", "repetitions")
SESSIONS = ("started", "sessions", "cells")


def cell_name(cell):
    return (cell["instance"], cell["strategy"], json.dumps(cell["given"], sort_keys=True), cell["digits"])


def cells_of(record):
    return {cell_name(cell): cell for cell in record["cells"]}


def results(record):
    """The cells without times. How often each was repeated is a matter of time where it was not asked for."""
    was_asked = record["sessions"][-1]["repetitions"] is not None

    def result(cell):
        if cell["status"] == "timed out":  # and how far it came is chance
            return cell["status"], cell["options"]
        free = TIMES if was_asked else (*TIMES, "planned")
        repeated = len(cell["repetitions"]) if was_asked else cell["repetitions"] != []
        return {key: value for key, value in cell.items() if key not in free}, repeated

    return {name: result(cell) for name, cell in cells_of(record).items()}


class KilledRuns(command_line.CommandLine):
    def command(self, arguments, folder, *more):
        return argv(*arguments, "--out", folder, *more)

    def whole(self, arguments, limit_s):
        """The record of a run that nothing interrupts, and its seconds."""
        folder = self.folder / "whole"
        begin = time.monotonic()
        done = subprocess.run(self.command(arguments, folder), capture_output=True, text=True, timeout=limit_s,
                              cwd=SOURCE, check=False)
        self.assertIn(done.returncode, (DONE, NOT_SOLVED), done.stderr)
        return json.loads((folder / "run.json").read_text()), time.monotonic() - begin

    def killed(self, arguments, folder, after_s):
        """Starts or resumes the run and kills it after so many seconds; True when it was done before."""
        with subprocess.Popen(self.command(arguments, folder, "--resume"), stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, cwd=SOURCE) as process:
            try:
                self.assertIn(process.wait(timeout=after_s), (DONE, NOT_SOLVED))
                return True
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                return False

    def assert_kept(self, before, after):
        """Every cell of the earlier state is in the later one, with its answer and its repetitions."""
        later = cells_of(after)
        for name, cell in cells_of(before).items():
            self.assertEqual(cell["warm_up_s"], later[name]["warm_up_s"], f"{name} was solved again")
            if later[name]["repetitions"]:
                self.assertEqual(cell["repetitions"], later[name]["repetitions"][:len(cell["repetitions"])], name)

    def check(self, arguments, kills, seed, limit_s=LIMIT_S):
        whole, seconds = self.whole(arguments, limit_s)
        moments = random.Random(seed)
        folder = self.folder / "killed"
        file = folder / "run.json"
        before = {"cells": []}
        interrupted = 0
        done = False
        while not done:
            # Short enough that all kills meet a run that is not done, and long enough to come forward.
            after_s = moments.uniform(0, 2 * seconds / kills) if interrupted < kills else limit_s
            done = self.killed(arguments, folder, after_s)
            interrupted += not done
            if file.exists():
                after = json.loads(file.read_text())
                self.assert_kept(before, after)
                before = after
        self.assertGreaterEqual(interrupted, kills // 2, "the run is too short")
        self.assertEqual(results(before), results(whole))
        self.assertEqual({key: before[key] for key in before if key not in SESSIONS},
                         {key: whole[key] for key in whole if key not in SESSIONS})
        self.assertGreater(len(before["sessions"]), 1)
        self.assertEqual({path.name for path in folder.iterdir()},
                         {path.name for path in (self.folder / "whole").iterdir()})
        again = self.killed(arguments, folder, limit_s)
        self.assertTrue(again)
        self.assertEqual(json.loads(file.read_text())["cells"], before["cells"])

    def test_tables(self):
        self.check(TABLES, KILLS, 1)

    @unittest.skipUnless("GCSBENCH_KILL_WHOLE_TABLES" in os.environ, "takes most of an hour")
    def test_whole_tables(self):
        self.check(["tables", "all"], KILLS, 4, WHOLE_TABLES_LIMIT_S)

    def test_precision(self):
        self.check(PRECISION, 6, 2)

    def test_stability(self):
        self.check(STABILITY, 6, 3)


class Resume(command_line.CommandLine):
    """What may change between two sessions of a run, and what may not."""

    def setUp(self):
        super().setUp()
        self.run_folder = self.folder / "run"
        self.file = self.run_folder / "run.json"
        self.toy = self.write(json.loads((SOURCE / "instances" / "k33.json").read_text())
                              | {"id": "mine"}, "mine.json")
        self.assertEqual(self.measure().returncode, DONE)

    def measure(self, *more, instances="", strategies="full-space,rcp"):
        return command_line.run("tables", "table1", "--instances", instances or f"k33,{self.toy}",
                                     "--strategies", strategies, "--repetitions", 2, "--out", self.run_folder, *more)

    def record(self):
        return json.loads(self.file.read_text())

    def assert_refused(self, done, *mentioned):
        before = self.file.read_bytes()
        self.assert_one_message(done, BAD_INPUT, self.file, *mentioned, "--resume")
        self.assertEqual(self.file.read_bytes(), before)

    def changed(self, change):
        record = self.record()
        change(record)
        self.file.write_text(json.dumps(record))

    def test_the_record_says_how_to_repeat_it(self):
        record = self.record()
        for name in ("cpu", "compiler", "flags", "commit"):
            self.assertTrue(record["environment"][name], name)
        session, = record["sessions"]
        self.assertEqual(session["arguments"][1:3], ["tables", "table1"])
        self.assertEqual(Path(session["folder"]), SOURCE)
        self.assertEqual(len(session["load_average"]), 3)
        self.assertEqual((session["repetitions"], session["cell_limit_s"]), (2, 60))
        self.assertEqual(len({instance["fingerprint"] for instance in record["instances"]}), 2)

    def test_more_may_be_asked_for(self):
        before = self.record()
        done = self.measure("--resume", "--repetitions", 4, instances=f"octahedron,k33,{self.toy}",
                            strategies="full-space,rcp,plan-scan")
        self.assertEqual(done.returncode, BAD_INPUT, "an option is given twice")
        done = command_line.run("tables", "table1", "table2", "--instances", f"octahedron,k33,{self.toy}",
                                     "--strategies", "full-space,rcp,plan-scan", "--repetitions", 4, "--out",
                                     self.run_folder, "--resume")
        self.assertEqual(done.returncode, DONE, done.stderr)
        after = self.record()
        later = cells_of(after)
        for name, cell in cells_of(before).items():
            self.assertEqual(cell["repetitions"], later[name]["repetitions"][:2])
        self.assertGreater(len(later), len(before["cells"]))
        self.assertEqual({len(cell["repetitions"]) for cell in later.values() if cell["status"] == "complete"}, {4})
        self.assertEqual(len(after["sessions"]), 2)

    def test_less_would_lose_what_was_measured(self):
        self.assert_refused(self.measure("--resume", instances=self.toy), "k33, full-space", "not asked for now")
        self.assert_refused(self.measure("--resume", strategies="rcp"), "k33, full-space", "not asked for now")

    def test_an_instance_whose_content_changed_is_named(self):
        changed = json.loads(self.toy.read_text())
        del changed["constraints"][0]["length"]
        changed["constraints"][0]["squared"] = 3.25
        self.write(changed, "mine.json")
        self.assert_refused(self.measure("--resume"), "content of instance 'mine'")

    def test_the_layout_of_an_instance_may_change(self):
        self.toy.write_text(json.dumps(json.loads(self.toy.read_text()), indent=7))
        self.assertEqual(self.measure("--resume").returncode, DONE)

    def test_another_program_machine_or_seed_is_named(self):
        for name in ("commit", "compiler", "flags", "cpu", "instructions"):
            with self.subTest(name):
                original = self.file.read_bytes()
                self.changed(lambda record, name=name: record["environment"].update({name: "another"}))
                self.assert_refused(self.measure("--resume"), f"{name} another (now ")
                self.file.write_bytes(original)
        self.changed(lambda record: record.update(seed=7))
        self.assert_refused(self.measure("--resume"), "seed 7 (now 1)")


if __name__ == "__main__":
    command_line.main()
