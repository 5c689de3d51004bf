#!/usr/bin/python3
"""Several ranks solve as one process does: to the last bit, and after any of them was killed.

Usage: ranks_test.py PROGRAM SOURCE_DIR [unittest arguments]

Skipped where there is no mpirun, or the program was built without MPI.
"""

import json
import os
import random
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

import command_line
from command_line import BAD_INPUT, CHECK_FAILED, DONE, SOURCE, argv, run

MPIRUN = shutil.which("mpirun")
MODULE = Path(argv()[0]).with_name("gcsbench_mpi.so")
LIMIT_S = 120
SOLVE = ["solve", "dodecagon", "--strategy", "monodromy"]


def mpirun(ranks, *arguments):
    own = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return [MPIRUN, *own, "--oversubscribe", "-n", str(ranks), *argv(*arguments)]


def threads_of(text):
    return json.loads(text)["environment"]["threads"]


def run_ranks(ranks, *arguments):
    """In the same folder as one process does, as files of instances are shown from there."""
    return subprocess.run(mpirun(ranks, *arguments), capture_output=True, text=True, timeout=LIMIT_S, cwd=SOURCE)


def answer(text):
    """All of a result that does not depend on the machine and its load."""
    return {key: value for key, value in json.loads(text).items() if key not in ("timing", "environment")}


def own_lines(done):
    return [line for line in done.stderr.splitlines() if line.startswith("gcsbench")]


def cells(folder):
    """Of a run, what does not depend on the load: every cell without its times."""
    run_file = json.loads((folder / "run.json").read_text())
    timed = ("warm_up_s", "limit_s", "estimate_s", "repetitions")
    found = [{key: value for key, value in cell.items() if key not in timed} for cell in run_file["cells"]]
    return found, [len(cell["repetitions"]) for cell in run_file["cells"]], run_file["instances"]


def ranks_of(process):
    """The processes that mpirun has started."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    return [int(child) for child in children.read_text().split()] if children.exists() else []


def is_alive(process_id):
    try:
        return Path(f"/proc/{process_id}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def code_after_kill(process):
    """The exit code of mpirun, a rank of which was killed: then the others end. Itself it may hang for good, with no rank alive:
    PMIx 4.2 waits in PMIx_server_finalize for a thread that waits for a lock that is gone."""
    deadline = time.monotonic() + LIMIT_S
    while process.poll() is None and any(map(is_alive, ranks_of(process))):
        if time.monotonic() > deadline:
            raise TimeoutError("a rank goes on after another one was killed")
        time.sleep(0.05)
    try:
        return process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        return process.wait()


class RanksWithoutMpi(command_line.CommandLine):
    def test_a_build_without_mpi_says_so_once(self):
        alone = self.folder / "gcsbench"
        shutil.copy(argv()[0], alone)
        for rank, lines in [(0, 1), (1, 0)]:
            done = subprocess.run([alone, "list"], capture_output=True, text=True, timeout=LIMIT_S,
                                  env={**os.environ, "OMPI_COMM_WORLD_SIZE": "2", "OMPI_COMM_WORLD_RANK": str(rank)})
            self.assertEqual((done.returncode, len(own_lines(done))), (BAD_INPUT, lines), done.stderr)
            self.assertEqual("GCSBENCH_WITH_MPI=ON" in done.stderr, rank == 0)


@unittest.skipUnless(MPIRUN and MODULE.exists(), "needs mpirun, and a program that was built with MPI")
class Ranks(command_line.CommandLine):
    def test_the_bits_are_those_of_one_process(self):
        solves = [[*SOLVE, "--certify"], ["solve", "disulfide", "--strategy", "polyhedral"],
                  ["solve", "platform", "--strategy", "monodromy"], ["solve", "octahedron", "--strategy", "rcp"]]
        for solve in solves:
            alone = run(*solve, "--out", "-")
            self.assertEqual(alone.returncode, DONE, alone.stderr)
            for ranks in [2, 3]:
                with self.subTest(solve=solve, ranks=ranks):
                    done = run_ranks(ranks, *solve, "--out", "-")
                    self.assertEqual(done.returncode, DONE, done.stderr)
                    self.assertEqual(answer(done.stdout), answer(alone.stdout))

    def test_the_first_rank_may_use_the_cores_of_those_that_wait(self):
        cores = len(os.sched_getaffinity(0))
        if cores < 2:
            self.skipTest("needs two cores")
        bound = mpirun(2, "solve", "octahedron", "--strategy", "monodromy", "--out", "-")
        bound[1:1] = ["--bind-to", "core"]
        done = subprocess.run(bound, capture_output=True, text=True, timeout=LIMIT_S, cwd=SOURCE)
        self.assertEqual((done.returncode, threads_of(done.stdout)), (DONE, 2), done.stderr)
        for ranks, given in [(2, 3), (3, 1)]:
            done = run_ranks(ranks, "solve", "octahedron", "--strategy", "monodromy", "--threads", given, "--out", "-")
            self.assertEqual((done.returncode, threads_of(done.stdout)), (DONE, ranks * given), done.stderr)

    def test_sweeps_have_the_cells_of_one_process(self):
        for sweep in [["stability", "flat-triangle", "near-miss", "--strategies", "full-space,rcp"],
                      ["precision", "octahedron", "disulfide", "--strategies", "rcp,cayley-menger"]]:
            folders = [self.folder / f"{sweep[0]}{ranks}" for ranks in (1, 2, 3)]
            words = [*sweep, "--repetitions", "1", "--out"]
            alone = run(*words, folders[0])
            self.assertIn(alone.returncode, (DONE, CHECK_FAILED), alone.stderr)
            for ranks, folder in enumerate(folders[1:], 2):
                with self.subTest(sweep=sweep, ranks=ranks):
                    done = run_ranks(ranks, *words, folder)
                    self.assertEqual(done.returncode, alone.returncode, done.stderr)
                    self.assertEqual(cells(folder), cells(folders[0]))

    def test_ranks_share_what_is_solved_for_answers_and_the_first_one_alone_measures_times(self):
        log = self.folder / "log"
        program = self.folder / "program"
        program.write_text(f"""#!/bin/sh
cat > /dev/null
echo $OMPI_COMM_WORLD_RANK >> {log}
echo '{{"solutions": []}}'
""")
        program.chmod(0o755)
        done = run_ranks(2, "stability", "flat-triangle", "--strategies", f"exec:{program}", "--repetitions", "3",
                         "--out", self.folder / "run")
        self.assertEqual(done.returncode, DONE, done.stderr)
        found, repetitions, _ = cells(self.folder / "run")
        solves = log.read_text().split()
        self.assertEqual(len(solves), len(found) + sum(repetitions))
        self.assertTrue(0 < solves.count("1") < len(found), solves)
        self.assertEqual(set(solves[len(found):]), {"0"})

    def test_a_sweep_of_which_a_rank_was_killed_goes_on(self):
        folder = self.folder / "run"
        words = ["stability", "flat-triangle", "--repetitions", "1"]
        alone = run(*words, "--out", self.folder / "alone")
        process = subprocess.Popen(mpirun(2, *words, "--out", folder), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        while len(ranks_of(process)) < 2 and process.poll() is None:
            time.sleep(0.01)
        time.sleep(0.3)
        for rank in ranks_of(process)[1:]:
            os.kill(rank, signal.SIGKILL)
        self.assertNotEqual(code_after_kill(process), DONE)
        done = run_ranks(2, *words, "--out", folder, "--resume")
        self.assertEqual(done.returncode, alone.returncode, done.stderr)
        self.assertEqual(cells(folder), cells(self.folder / "alone"))

    def test_one_message_tells_of_an_error(self):
        done = run_ranks(3, "solve", "nowhere.json", "--strategy", "monodromy")
        self.assertEqual((done.returncode, len(own_lines(done))), (BAD_INPUT, 1), done.stderr)

    def test_commands_that_do_not_solve_run_once(self):
        self.assertEqual(run_ranks(2, "list", "strategies").stdout, run("list", "strategies").stdout)

    def test_any_number_of_ranks_goes_on_after_one_was_killed(self):
        expected = answer(run(*SOLVE, "--out", "-").stdout)
        dice = random.Random(23)
        killed = 0
        for round_number in range(8):
            journal = self.folder / f"journal{round_number}"
            process = subprocess.Popen(mpirun(2 + round_number % 2, *SOLVE, "--resume", journal, "--out", "-"),
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(dice.uniform(0.2, 1.5))
            ranks = ranks_of(process)
            if ranks:
                os.kill(dice.choice(ranks), signal.SIGKILL)
                killed += code_after_kill(process) != 0
            process.wait(LIMIT_S)
            done = run_ranks(3 - round_number % 2, *SOLVE, "--resume", journal, "--out", "-")
            self.assertEqual(done.returncode, DONE, done.stderr)
            self.assertEqual(answer(done.stdout), expected)
        self.assertGreater(killed, 0, "no rank was killed while it worked")


if __name__ == "__main__":
    command_line.main()
