#!/usr/bin/python3
"""Runs in places that refuse them: full, read-only or shared folders, broken files, signals. Each ends with one
message and leaves no half-written file, and what was kept before is kept.

Usage: hostile_places_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import os
import random
import resource
import shlex
import signal
import subprocess
import time
import unittest

import command_line
from command_line import BAD_INPUT, CHECK_FAILED, DONE, INTERRUPTED, NOT_SOLVED, SOURCE, argv, run

TABLES = ["tables", "table1", "--instances", "k33", "--strategies", "full-space,rcp", "--repetitions", 2]
MEASURING = {
    "tables": TABLES,
    "precision": ["precision", "k33", "--strategies", "rcp", "--repetitions", 2],
    "stability": ["stability", "near-miss", "--strategies", "rcp", "--repetitions", 2],
}
# Some minutes each, so that a signal always comes in time, with a cell that is soon measured.
LONG = {
    "tables": ["tables", "table1", "--instances", "k33,icosahedron", "--repetitions", 100000],
    "precision": ["precision", "k33", "icosahedron"],
    "stability": ["stability"],
}
WRITING = {
    "solve": ["solve", "k33", "--strategy", "rcp"],
    "path": ["path", "k33"],
    "follow": ["follow", "k33"],
}


def mounts_are_permitted():
    return subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", "/mnt"], capture_output=True,
                          check=False).returncode == 0


class HostilePlaces(command_line.CommandLine):
    def assert_refused(self, done, *mentioned):
        self.assert_one_message(done, BAD_INPUT, *mentioned)
        self.assertEqual(list(self.folder.rglob("*.unfinished")), [])

    def start(self, *arguments):
        """The program in the background, which does not outlive the test."""
        process = subprocess.Popen(argv(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   cwd=SOURCE)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_until(self, is_so, process):
        """However slow the machine is: the test's own limit ends what never comes."""
        while not is_so():
            self.assertIsNone(process.poll(), "it has ended before")
            time.sleep(0.02)

    def stored(self):
        """A folder with a finished run."""
        folder = self.folder / "run"
        self.assertEqual(run(*TABLES, "--out", folder).returncode, DONE)
        return folder


class Folders(HostilePlaces):
    def test_that_are_none(self):
        file = self.write("mine", "file")
        link = self.folder / "link"
        link.symlink_to(self.folder / "nowhere" / "else")
        for name, command in MEASURING.items():
            for place in (file, file / "below", link, "/proc/none"):
                with self.subTest(name, place=place):
                    self.assert_refused(run(*command, "--out", place), place)
        self.assertEqual(file.read_text(), "mine")
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"file", "link"})

    def test_in_which_run_json_is_a_folder(self):
        (self.folder / "run.json").mkdir()
        self.assert_refused(run(*TABLES, "--out", self.folder), self.folder / "run.json", "directory")
        self.assert_refused(run(*TABLES, "--out", self.folder, "--resume"), self.folder / "run.json", "directory")

    def test_that_another_process_uses(self):
        folder = self.stored()
        first = self.start(*LONG["tables"], "--out", folder)
        self.wait_until(lambda: "icosahedron" in (folder / "run.json").read_text(), first)
        for command in MEASURING.values():
            for more in ([], ["--resume"]):
                self.assert_one_message(run(*command, "--out", folder, *more), BAD_INPUT, folder, "another process")
        self.assertEqual(run("report", folder, "--out", self.folder / "tables").returncode, DONE)
        first.send_signal(signal.SIGKILL)
        first.wait()
        self.assertEqual(run(*TABLES, "--out", folder).returncode, DONE)


class FileLimits(HostilePlaces):
    def limited(self, arguments, size):
        """Runs where no file may be larger than `size` bytes."""
        return subprocess.run(argv(*arguments), capture_output=True, text=True, timeout=120, cwd=SOURCE, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))

    def test_are_said_and_nothing_is_lost(self):
        folder = self.stored()
        before = (folder / "run.json").read_bytes()
        for name, command in MEASURING.items():
            with self.subTest(name):
                self.assert_refused(self.limited([*command, "--out", folder], 1000), folder / "run.json", "large")
                self.assertEqual((folder / "run.json").read_bytes(), before)
        for name, command in WRITING.items():
            with self.subTest(name):
                file = self.write("old", "result.json")
                self.assert_refused(self.limited([*command, "--out", file], 100), file, "large")
                self.assertEqual(file.read_text(), "old")


@unittest.skipUnless(mounts_are_permitted(), "mounts are not permitted")
class Disks(HostilePlaces):
    def on_disk(self, options, commands, then="true"):
        """Runs the commands in turn on a file system of its own, with these options, mounted on the test's folder.
        Returns the last one's outcome; `then`, a command of the shell, sees the disk and prints to descriptor 3."""
        shell = [f"mount -t tmpfs {options} tmpfs {self.folder}"]
        lines = [" ".join(shlex.quote(str(word)) for word in command) for command in commands]
        shell += [f"{line} > /dev/null 2>&1" for line in lines[:-1]]
        shell += [lines[-1], "code=$?", f"{{ {then}; }} >&3", "exit $code"]
        seen, inside = os.pipe()
        with os.fdopen(seen) as report:
            done = subprocess.run(["unshare", "-m", "bash", "-c", f"exec 3>&{inside}; " + "\n".join(shell)],
                                  capture_output=True, text=True, timeout=120, cwd=SOURCE,
                                  check=False, pass_fds=[inside])
            os.close(inside)
            self.seen = report.read()
        return done

    def program(self, *arguments):
        return argv(*arguments)

    def test_full(self):
        for name, command in MEASURING.items():
            with self.subTest(name):
                file = self.folder / "run" / "run.json"
                done = self.on_disk("-o size=4k", [self.program(*command, "--out", file.parent)],
                                    f"ls {file.parent}; cat {file} 2> /dev/null")
                self.assert_refused(done, file, "No space left")
                names, _, last_with_room = self.seen.partition("\n")
                self.assertIn(names, ("", "run.json"))
                if names:
                    self.assertEqual(json.loads(last_with_room)["format"], "gcsbench-run/1")

    def test_filled_while_a_run_goes_on(self):
        out = self.folder / "run"
        more = ["tables", "table1", "--instances", "k33,octahedron,disulfide", "--strategies",
                "full-space,rcp,cayley-menger", "--repetitions", 2]
        done = self.on_disk("-o size=256k", [
            self.program(*TABLES, "--out", out),
            ["bash", "-c", f"head -c 1M /dev/zero > {self.folder}/filler"],
            self.program(*more, "--out", out, "--resume"),
        ], f"ls {out}; rm {self.folder}/filler; cat {out}/run.json")
        self.assert_refused(done, out / "run.json", "No space left")
        names, record = self.seen.split("{", 1)
        self.assertNotIn("unfinished", names)
        self.assertEqual({cell["instance"] for cell in json.loads("{" + record)["cells"]}, {"k33"})

    def test_without_room_for_another_file(self):
        # The root folder and the run's take one inode each.
        done = self.on_disk("-o nr_inodes=2", [self.program(*TABLES, "--out", self.folder / "run")])
        self.assert_refused(done, self.folder / "run", "No space left")

    def test_read_only(self):
        for name, command in (MEASURING | WRITING).items():
            with self.subTest(name):
                out = self.folder / "out"
                done = self.on_disk("-o ro", [self.program(*command, "--out", out)])
                self.assert_refused(done, out, "Read-only file system")


class Signals(HostilePlaces):
    def test_end_a_run_with_what_was_measured(self):
        for name, sent in (("tables", signal.SIGINT), ("precision", signal.SIGTERM), ("stability", signal.SIGINT)):
            with self.subTest(name):
                folder = self.folder / name
                process = self.start(*LONG[name], "--out", folder)
                self.wait_until((folder / "run.json").exists, process)
                process.send_signal(sent)
                output, errors = process.communicate()
                self.assertEqual((process.returncode, errors), (INTERRUPTED, ""))
                self.assertTrue(output.startswith("### "))
                cells = json.loads((folder / "run.json").read_text())["cells"]
                self.assertGreater(len(cells), 0)
                self.assertEqual(run("report", folder, "--out", self.folder / "report").stdout, output)


class BrokenFiles(HostilePlaces):
    """Whatever a file holds, the program ends in one of its own ways."""

    def broken_texts(self, text):
        damage = random.Random(5)
        for _ in range(12):
            yield text[:damage.randrange(len(text))]
        for _ in range(24):
            position = damage.randrange(len(text))
            yield text[:position] + damage.choice('{}[]",:-9e\\ \x00') + text[position + 1:]
        yield from ("", "{}", "[]", "null", "7", '"', "\0", "{" * 100000, '{"format": 7}')

    def assert_orderly(self, done):
        self.assertIn(done.returncode, (DONE, CHECK_FAILED, BAD_INPUT, NOT_SOLVED), done.stderr)
        if done.returncode == BAD_INPUT:
            self.assert_one_message(done, BAD_INPUT)
        self.assertNotIn("internal error", done.stderr)

    def test_runs(self):
        folder = self.stored()
        file = folder / "run.json"
        text = file.read_text()
        for number, broken in enumerate(self.broken_texts(text)):
            with self.subTest(number):
                file.write_text(broken)
                self.assert_orderly(run("report", folder))
                self.assert_orderly(run("compare", folder, folder))
                file.write_text(broken)
                done = run(*TABLES, "--out", folder, "--resume")
                self.assert_orderly(done)
                if done.returncode == BAD_INPUT:
                    self.assertEqual(file.read_text(), broken)

    def test_results(self):
        file = self.folder / "result.json"
        self.assertEqual(run("solve", "k33", "--strategy", "rcp", "--certify", "--out", file).returncode, DONE)
        for number, broken in enumerate(self.broken_texts(file.read_text())):
            with self.subTest(number):
                file.write_text(broken)
                self.assert_orderly(run("verify", file))
                self.assert_orderly(run("reference", file, "--out", self.folder / "reference.json"))

    def test_of_another_kind(self):
        folder = self.stored()
        result = self.folder / "result.json"
        self.assertEqual(run("solve", "k33", "--strategy", "rcp", "--out", result).returncode, DONE)
        for command in (["report"], ["compare", folder]):
            self.assert_refused(run(*command, result), result, "gcsbench-result/1", "gcsbench-run/1")
        for command in (["verify"], ["reference", "--out", self.folder / "x"]):
            self.assert_refused(run(*command, folder / "run.json"), folder / "run.json", "format",
                                "gcsbench-result/1")
        (folder / "run.json").write_bytes(result.read_bytes())
        self.assert_refused(run(*TABLES, "--out", folder, "--resume"), folder / "run.json", "gcsbench-run/1")
        self.assertEqual((folder / "run.json").read_bytes(), result.read_bytes())


if __name__ == "__main__":
    command_line.main()
