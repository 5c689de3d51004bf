#!/usr/bin/python3
"""External programs as strategies: what they answer is assessed, and whatever they do has one clear outcome.

Usage: exec_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import os
import shlex
import signal
import subprocess
import textwrap
import time
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE, argv, run

# Sides 3, 4, 5: one class, two mirror images.
TRIANGLE = {"format": "gcsbench-instance/1", "id": "triangle", "title": "Right triangle", "dimension": 2,
            "points": ["a", "b", "c"], "notes": "a secret",
            "constraints": [{"type": "distance", "between": ["a", "b"], "length": 3},
                            {"type": "distance", "between": ["b", "c"], "length": 4.0},
                            {"type": "distance", "between": ["a", "c"], "squared": 25.00}],
            "published": [{"quantity": "complex", "convention": "all signs", "value": 4, "source": "Euclid"}]}
RIGHT = {"points": {"a": [1, 1], "b": [1, 4], "c": [5, 4]}}
MIRRORED = {"points": {"a": [1, 1], "b": [1, 4], "c": [-3, 4]}}


def answer(*solutions, **members):
    return {"solutions": list(solutions), **members}


class ExternalProgram(command_line.WithFolder):
    def setUp(self):
        super().setUp()
        self.instance = self.write("triangle.json", json.dumps(TRIANGLE))
        self.out = self.folder / "result.json"

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def script(self, text):
        """The strategy that runs this Python program."""
        path = self.write("solver.py", textwrap.dedent(text))
        return "exec:exec /usr/bin/python3 " + shlex.quote(path)

    def prints(self, text):
        """The strategy whose program prints this."""
        return "exec:cat " + shlex.quote(self.write("answer", text if isinstance(text, str) else json.dumps(text)))

    def command(self, strategy, *more, instance=None):
        return argv("--quiet", "solve", instance or self.instance, "--strategy", strategy, "--out", self.out, *more)

    def solve(self, strategy, *more, instance=None, env=None):
        done = subprocess.run(self.command(strategy, *more, instance=instance), capture_output=True, timeout=120,
                              cwd=SOURCE, check=False, env=env)
        done.stdout, done.stderr = done.stdout.decode(), done.stderr.decode()
        done.result = json.loads(self.out.read_text()) if self.out.exists() else None
        return done

    def check_gives_up(self, strategy, *words):
        done = self.solve(strategy)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertEqual(done.result["status"], "gave up")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("gcsbench: exec:"), done.stderr)
        for word in words:
            self.assertIn(word, done.result["reason"])
        return done

    # ---- answers

    def test_solutions_are_moved_into_the_frame_and_mirror_images_are_one(self):
        done = self.solve(self.prints(answer(RIGHT, MIRRORED)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.result["status"], "complete")
        self.assertEqual(done.result["claim"], "some real")
        [solution] = done.result["solutions"]
        for name, position in {"a": [0, 0], "b": [3, 0], "c": [3, 4]}.items():
            for found, expected in zip(solution["points"][name], position):
                self.assertAlmostEqual(found, expected, 14)
        self.assertLess(solution["residual"], 1e-14)
        self.assertIsNone(done.result["counts"]["real_up_to_reflection"])

    def test_certificates_reach_what_a_program_finds(self):
        done = self.solve(self.prints(answer(RIGHT, claim="all complex")), "--certify")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.result["counts"]["certified"], 1)
        self.assertTrue(done.result["proofs"]["complete"])
        self.assertIn("all complex, as the program claims", done.stdout)

    def test_complex_solutions_are_pairs(self):
        flat = dict(TRIANGLE, points=["a", "b", "c", "d"], constraints=[
            {"type": "distance", "between": list(pair), "length": length} for pair, length in
            [(("a", "b"), 2), (("a", "c"), 1.25), (("b", "c"), 1.25), (("c", "d"), 1), (("b", "d"), 1)]], id="flat")
        height = 0.75
        # d on the line x = ... through b and c: both real; of the pairs one is made complex by a complex motion.
        angle_cos, angle_sin = 1.25, 0.75j  # cos² + sin² = 1
        across = (1 - 0.625 ** 2) ** 0.5
        d = [1.5 + across * height / 1.25, height / 2 + across * 1 / 1.25]
        points = {"a": [0, 0], "b": [2, 0], "c": [1, height], "d": d}
        turned = {name: [angle_cos * x - angle_sin * y, angle_sin * x + angle_cos * y] for name, (x, y) in points.items()}
        pairs = {name: [[complex(c).real, complex(c).imag] for c in position] for name, position in turned.items()}
        done = self.solve(self.prints(answer({"points": pairs}, claim="all complex")),
                          instance=self.write("flat.json", json.dumps(flat)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.result["counts"]["complex_up_to_reflection"], 1)

    def test_planes_may_have_normals_of_any_length(self):
        scene = str(SOURCE / "instances" / "octahedral-3p3h.json")
        self.assertEqual(self.solve("monodromy", instance=scene).returncode, 0)
        known = next(s for s in json.loads(self.out.read_text())["solutions"] if s["real"])
        scaled = {name: {"normal": [factor * c for c in plane["normal"]], "offset": factor * plane["offset"]}
                  for (name, plane), factor in zip(known["planes"].items(), [3, 1e-170, 1e170])}
        done = self.solve(self.prints(answer({"points": known["points"], "planes": scaled})), instance=scene)
        self.assertEqual(done.returncode, 0, done.stderr)
        [solution] = done.result["solutions"]
        for name, plane in known["planes"].items():
            self.assertAlmostEqual(solution["planes"][name]["offset"], plane["offset"], 12)

    def test_a_program_gets_the_problem_and_no_more(self):
        kept = self.folder / "seen.json"
        done = self.solve(self.script(f"""
            import json, os, sys
            text = sys.stdin.read()
            open({str(kept)!r}, "w").write(text)
            assert os.environ["GCSBENCH_SEED"] == "7" and os.environ["GCSBENCH_THREADS"] == "2"
            print(json.dumps({answer(RIGHT)!r}))
            """), "--seed", "7", "--threads", "2", env={**os.environ, "GCSBENCH_SEED": "9", "GCSBENCH_THREADS": "9"})
        self.assertEqual(done.returncode, 0, done.stderr)
        text = kept.read_text()
        seen = json.loads(text)
        self.assertEqual(seen["format"], "gcsbench-instance/1")
        self.assertEqual(seen["points"], TRIANGLE["points"])
        self.assertEqual([c["between"] for c in seen["constraints"]], [c["between"] for c in TRIANGLE["constraints"]])
        self.assertIn("25.0", text)
        for word in ["triangle", "Right", "secret", "published", "Euclid"]:
            self.assertNotIn(word, text)

    def test_gcsbench_is_an_external_program_too(self):
        for instance, strategy, count in [("k33", "rcp", "on_path"), ("octahedron", "monodromy", "complex_up_to_reflection"),
                                          ("hoffmann-yuan", "theta-scan", "real_up_to_reflection"),
                                          ("octahedral-3p3h", "monodromy", "complex_up_to_reflection"),
                                          ("tangents-durand", "sphere-tangents", "complex_up_to_reflection")]:
            inner = self.solve(strategy, instance=instance).result
            command = "exec:" + shlex.join(argv("--quiet", "solve", "-", "--strategy", strategy, "--out", "-"))
            done = self.solve(command, instance=instance)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.result["claim"], inner["claim"])
            self.assertEqual(done.result["counts"][count], inner["counts"][count])
            self.assertEqual(len(done.result["solutions"]), len(inner["solutions"]))
            self.assertEqual(done.result["path"], inner["path"])
            self.assertGreater(done.result["timing"]["cpu_s"], 0)

    def test_a_program_knows_which_one_runs_it(self):
        done = self.solve('exec:"$GCSBENCH_PROGRAM" --quiet solve - --strategy monodromy --out -')
        self.assertEqual((done.returncode, len(done.result["solutions"])), (0, 1), done.stderr)

    def test_what_a_program_says_of_itself_is_passed_on(self):
        done = self.solve(self.prints(answer(RIGHT, status="partial", reason="out of luck")))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.result["status"], "partial")
        self.assertIn("out of luck", done.result["reason"])
        for status in ["gave up", "unsupported", "infinite", "timed out", "interrupted"]:
            done = self.check_gives_up(self.prints(answer(RIGHT, status=status, reason="one thing")), status, "one thing")
            self.assertEqual(len(done.result["solutions"]), 1)

    def test_a_program_need_not_read_its_input(self):
        done = self.solve("exec:echo '{\"solutions\": []}'", instance="icosahedron")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.result["solutions"], [])

    # ---- wrong answers

    def test_wrong_points_fail_a_check(self):
        wrong = {"points": {"a": [0, 0], "b": [3, 0], "c": [3, 4.001]}}
        done = self.solve(self.prints(answer(RIGHT, wrong)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("residual", done.stderr)

    def test_huge_points_fail_a_check(self):
        for number in ["1e300", "-1e308", "123456789012345678901234567890"]:
            text = json.dumps(answer(RIGHT)).replace("[5, 4]", f"[{number}, 4]")
            done = self.solve(self.prints(text))
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertTrue(done.result["failed_checks"])

    def test_claims_are_held_against_bounds(self):
        done = self.solve(self.prints(answer(dict(RIGHT, multiplicity=3), claim="all complex")))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("exact number is 1", done.stderr)

    def test_a_path_that_meets_nothing_is_no_answer_on_the_path(self):
        done = self.solve(self.prints(answer(RIGHT, claim="on path")))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("on the path", done.stderr)

    # ---- no answer

    def test_output_that_is_no_result_names_the_place(self):
        good = json.dumps(answer(RIGHT))
        self.check_gives_up(self.prints("hello"), "not JSON")
        self.check_gives_up(self.prints(good[:-5]), "not JSON")
        self.check_gives_up(self.prints(""), "empty")
        self.check_gives_up(self.prints(b"\xff\xfe".decode("latin1") + good), "not JSON")
        self.check_gives_up(self.prints(good.replace("[5, 4]", "[NaN, 4]")), "NaN")
        self.check_gives_up(self.prints(good.replace("[5, 4]", "[1e999, 4]")), "too large")
        self.check_gives_up(self.prints(good.replace("[5, 4]", "[5, 4, 0]")), "/solutions/0/points/c")
        self.check_gives_up(self.prints(good.replace("[5, 4]", '"far"')), "/solutions/0/points/c")
        self.check_gives_up(self.prints(good.replace('"c"', '"C"')), "'c' is missing")
        self.check_gives_up(self.prints({"points": {}}), "'solutions' is missing")
        self.check_gives_up(self.prints("[]"), "an array")
        self.check_gives_up(self.prints("[" * 1000), "nested deeper")
        self.check_gives_up(self.prints(answer(RIGHT, claim="everything")), "/claim", "'everything'", "all real")
        self.check_gives_up(self.prints(answer(RIGHT, status="done")), "/status", "'done'", "complete")
        self.check_gives_up(self.prints(answer(RIGHT, format="gcsbench-result/9")), "/format")
        self.check_gives_up(self.prints(answer(dict(RIGHT, multiplicity=10 ** 30))), "/solutions/0/multiplicity")
        self.check_gives_up(self.prints(answer(dict(RIGHT, multiplicity=2 ** 32 + 1))), "/solutions/0/multiplicity")
        self.check_gives_up(self.prints(answer(RIGHT, claim="on path", path=[{"solution": 1, "direction": 1}])), "/path/0")

    def test_a_program_that_fails_is_named_with_what_it_said(self):
        self.check_gives_up("exec:echo first >&2; echo the second >&2; exit 7", "exit status 7", "(it said: the second)")
        self.check_gives_up("exec:no-such-program-here", "exit status 127", "not found")
        self.check_gives_up("exec:exit 5", "exit status 5")
        self.check_gives_up("exec:kill -SEGV $$", "signal 11")
        self.check_gives_up(r"exec:printf '\377\376 \033[31mred\n' >&2; exit 1", "red")
        done = self.check_gives_up("exec:head -c 100000 /dev/zero | tr '\\0' x >&2; exit 1", "xxx")
        self.assertLess(len(done.result["reason"]), 400)

    def test_endless_output_is_ended(self):
        start = time.monotonic()
        self.check_gives_up("exec:yes", "64 MiB")
        self.assertLess(time.monotonic() - start, 60)

    def test_a_command_is_needed(self):
        for strategy in ["exec:", "exec:  "]:
            done = self.solve(strategy)
            self.assertEqual(done.returncode, 2)
            self.assertIn("needs a command", done.stderr)
        done = self.solve("exec:echo \udcff")  # a byte that is no text
        self.assertEqual(done.returncode, 2)
        self.assertIn("UTF-8", done.stderr)
        self.assertEqual(self.solve(self.prints(answer(RIGHT)), "--set", "a=b").returncode, 2)
        self.assertEqual(self.solve(self.prints(answer(RIGHT)), "--resume", str(self.folder / "journal")).returncode, 2)

    # ---- stopping

    def sleeper(self, first=""):
        """A program with a child of its own; both write their numbers."""
        self.numbers = self.folder / "numbers"
        return f"exec:{first} echo $$ >> {self.numbers}; sleep 60 & echo $! >> {self.numbers}; wait; sleep 60"

    def check_gone(self):
        numbers = [int(line) for line in self.numbers.read_text().split()]
        self.assertEqual(len(numbers), 2)
        for number in numbers:
            with self.assertRaises(ProcessLookupError):
                # An orphan that was killed may still wait for the system to collect it.
                for _ in range(100):
                    os.kill(number, 0)
                    if self.state(number) == "Z":
                        raise ProcessLookupError
                    time.sleep(0.02)

    @staticmethod
    def state(number):
        try:
            return Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()[0]
        except FileNotFoundError:
            return "Z"

    def check_stops(self, strategy, most_s):
        start = time.monotonic()
        done = self.solve(strategy, "--time-limit", "0.5")
        self.assertLess(time.monotonic() - start, most_s)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertEqual(done.result["status"], "timed out")

    def test_the_time_limit_ends_all_that_was_started(self):
        self.check_stops(self.sleeper(), 20)
        self.check_gone()

    def test_a_program_that_will_not_end_is_killed(self):
        self.check_stops(self.sleeper("trap '' TERM;"), 20)
        self.check_gone()

    def test_a_program_that_has_closed_its_output_is_ended(self):
        self.check_stops("exec:exec >&- 2>&-; sleep 60", 20)

    def test_ctrl_c_ends_the_program(self):
        process = subprocess.Popen(self.command(self.sleeper()), stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=SOURCE)
        for _ in range(500):
            if self.numbers.exists() and len(self.numbers.read_text().split()) == 2:
                break
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(json.loads(self.out.read_text())["status"], "interrupted")
        self.check_gone()

    def test_what_a_program_leaves_behind_is_ended(self):
        self.numbers = self.folder / "numbers"
        leftover = f"(echo $$; exec sh -c 'echo $$ ; exec sleep 60 >/dev/null 2>&1') >> {self.numbers} 2>/dev/null &"
        done = self.solve(f"exec:{leftover} sleep 0.3; echo '{json.dumps(answer(RIGHT))}'")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check_gone()

    # ---- tables

    def run_program(self, *arguments):
        return run("--quiet", *arguments)

    def test_tables_show_a_program_in_short_beside_the_others_and_it_leaves_no_zombies(self):
        zombies = self.folder / "zombies"
        solver = self.script(f"""
            import os, pathlib, subprocess, sys
            for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
                try:
                    state, parent = stat.read_text().rsplit(")", 1)[1].split()[:2]
                except OSError:
                    continue
                if state == "Z" and parent == str(os.getppid()):
                    open({str(zombies)!r}, "a").write(str(stat))
            command = [{PROGRAM!r}, "--quiet", "solve", "-", "--strategy", "monodromy", "--out", "-"]
            sys.exit(subprocess.run(command).returncode)
            """)
        strategy = solver.replace("exec:exec /usr/bin/python3 ", "exec:/usr/bin/env python3 ")
        out = self.folder / "run"
        done = self.run_program("tables", "table1", "--instances", "octahedron", "--strategies", strategy + ",cayley-menger",
                                "--repetitions", "3", "--out", str(out))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("external: exec:env python3", done.stdout)
        self.assertNotIn(strategy, done.stdout)
        self.assertFalse(zombies.exists())
        files = {path: path.read_text() for path in out.iterdir() if path.is_file() and path.name != "run.json"}
        for path in files:
            path.unlink()
        self.assertEqual(self.run_program("report", str(out)).returncode, 0)
        self.assertEqual({path: path.read_text() for path in files}, files)
        self.assertTrue(any("external: exec:env python3" in text for text in files.values()))

    def test_a_program_that_fails_ends_no_table(self):
        done = self.run_program("tables", "table1", "--instances", "octahedron", "--strategies", "exec:exit 3,cayley-menger",
                                "--repetitions", "1")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("gave up", done.stdout)
        self.assertIn("8 up to reflection", done.stdout)

    def test_precision_and_stability_measure_a_program(self):
        inner = "exec:" + shlex.join(argv("--quiet", "solve", "-", "--strategy", "full-space", "--out", "-"))
        for arguments in [("precision", "k33"), ("stability", "near-miss")]:
            done = self.run_program(*arguments, "--strategies", inner, "--repetitions", "1")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("exec:gcsbench --quiet solve", done.stdout)


if __name__ == "__main__":
    command_line.main()
