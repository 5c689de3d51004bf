#!/usr/bin/python3
"""What long commands show on a terminal while they run: a line that says how far they are, and for how long yet.

Usage: progress_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import os
import pty
import re
import select
import signal
import subprocess
import time

import command_line
from command_line import DONE, INTERRUPTED, SOURCE, argv, run

CLEAR = "\r\x1b[K"
# Far longer than any test waits.
ENDLESS = ["solve", "icosahedron", "--strategy", "polyhedral", "--set", "formulation=coordinates"]
KNOWN_SHARE = ["solve", "dodecagon", "--strategy", "polyhedral", "--set", "formulation=coordinates"]


class Progress(command_line.CommandLine):
    def shown(self, arguments, expected, columns=200):
        """Runs on a terminal until the pattern is shown, and interrupts. Returns all that was shown, and the code."""
        terminal, inside = pty.openpty()
        with subprocess.Popen(["stty", "cols", str(columns)], stdin=inside) as stty:
            stty.wait()
        process = subprocess.Popen(argv(*arguments), stdout=subprocess.DEVNULL, stderr=inside, cwd=SOURCE)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        os.close(inside)
        text = ""
        deadline = time.monotonic() + 60
        sent = False
        with os.fdopen(terminal, "rb", buffering=0) as stream:
            while time.monotonic() < deadline:
                try:
                    if select.select([stream], [], [], 1)[0]:
                        text += stream.read(65536).decode()
                except OSError:  # the program has ended
                    break
                if not sent and re.search(expected, text):
                    process.send_signal(signal.SIGINT)
                    sent = True
        self.assertTrue(sent, f"{expected} was not shown: {text[-500:]!r}")
        return text, process.wait(timeout=60)

    def test_a_solve_says_how_much_time_is_left(self):
        text, code = self.shown(KNOWN_SHARE, r"polyhedral homotopies \d+ %, about \d+ \w+ left at this rate")
        self.assertEqual(code, INTERRUPTED)
        self.assertIn(CLEAR + "gcsbench: ", text, "the line is cleared before the message")

    def test_a_stage_of_unknown_length_says_how_long_it_has_taken(self):
        self.shown(["solve", "icosahedron", "--strategy", "full-space", "--set", "step_max=1e-6"],
                   r"tracking S, 2 s so far")
        self.shown(ENDLESS, r"mixed cells, \d s so far|polyhedral homotopies")

    def test_measuring_names_the_cell_and_what_it_does(self):
        for command in (["tables", "table1", "--instances", "icosahedron"], ["precision", "icosahedron"],
                        ["stability", "flat-triangle"]):
            with self.subTest(command):
                _, code = self.shown([*command, "--repetitions", 100000],
                                     r"answers: [-@\w]+, [-\w]+: [ \w]+.* \d+ %, ")
                self.assertEqual(code, INTERRUPTED)

    def test_repetitions_say_how_much_time_is_left(self):
        self.shown(["tables", "table1", "--instances", "k33", "--strategies", "rcp", "--repetitions", 100000],
                   r"repetitions \d+ %, about \d+ \w+ left")

    def test_a_narrow_terminal_gets_short_lines(self):
        text, _ = self.shown(["tables", "table1", "--instances", "icosahedron"], r"answers: ico", columns=20)
        for line in text.split(CLEAR):
            if line.startswith("answers"):
                self.assertLess(len(line), 20)

    def test_a_log_names_every_instance_and_how_far_repetitions_are(self):
        done = run("tables", "table1", "--instances", "k33,dodecagon", "--strategies", "rcp", "--repetitions", 20, "--log")
        self.assertEqual(done.returncode, DONE)
        lines = done.stderr.splitlines()
        self.assertTrue(all(re.match(r"\d\d:\d\d:\d\d \w", line) for line in lines), done.stderr)
        said = [line[9:] for line in lines]
        for expected in ("answers: k33", "answers: dodecagon", "repetitions 0 %", "repetitions 90 %"):
            self.assertEqual(said.count(expected), 1, done.stderr)

    def test_nothing_is_shown_elsewhere(self):
        for more in ([], ["--quiet"]):
            done = run("tables", "table1", "--instances", "dodecagon", "--strategies", "full-space,rcp",
                       "--repetitions", 50, *more)
            self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        terminal, inside = pty.openpty()
        with os.fdopen(terminal), os.fdopen(inside, "wb") as errors:
            done = subprocess.run(argv("--quiet", "solve", "dodecagon", "--strategy", "monodromy"),
                                  stdout=subprocess.DEVNULL, stderr=errors, check=False, cwd=SOURCE)
            self.assertEqual(done.returncode, DONE)
            self.assertEqual(select.select([terminal], [], [], 0.1)[0], [])


if __name__ == "__main__":
    command_line.main()
