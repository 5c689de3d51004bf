#!/usr/bin/python3
"""`solve` and its results from outside: options, particulars, interruption.

Usage: solve_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import os
import signal
import subprocess
import time
from fractions import Fraction
from pathlib import Path

import command_line
from bad_instances import TOY, changed
from command_line import BAD_INPUT, CHECK_FAILED, DONE, ENDLESS, INTERRUPTED, NOT_SOLVED, SOURCE, argv, run
from general_scenes import osculating


class Solve(command_line.CommandLine):
    def test_done(self):
        out = self.folder / "result.json"
        done = run("solve", "octahedron", "--strategy", "full-space", "--out", out)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertIn("4 solutions", done.stdout)
        result = json.loads(out.read_text())
        self.assertEqual(result["format"], "gcsbench-result/1")
        self.assertEqual(result["status"], "complete")
        self.assertEqual(result["counts"]["on_path"], 4)
        self.assertEqual(len(result["solutions"]), 4)
        self.assertEqual({crossing["solution"] for crossing in result["path"]}, {0, 1, 2, 3})
        self.assertEqual(result["instance"], json.loads((SOURCE / "instances/octahedron.json").read_text()))
        self.assertEqual([path.name for path in self.folder.iterdir()], ["result.json"])

    def test_standard_output_holds_the_json_alone(self):
        done = run("solve", self.write(TOY), "--strategy", "full-space", "--out", "-")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertEqual(json.loads(done.stdout)["instance"], TOY)

    def test_only_timing_and_environment_differ_between_runs(self):
        one, two = (self.repeatable_part(run("solve", "octahedron", "--strategy", "rcp", "--threads", threads,
                                            "--out", "-")) for threads in [1, 2])
        self.assertEqual(one, two)

    def test_all_cores_that_the_process_may_use_are_used(self):
        one_core = {min(os.sched_getaffinity(0))}
        for cores, prefix in [(os.sched_getaffinity(0), []), (one_core, ["taskset", "-c", str(*one_core)])]:
            done = subprocess.run([*prefix, *argv("solve", "octahedron", "--strategy", "rcp", "--out", "-")],
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(json.loads(done.stdout)["environment"]["threads"], len(cores))

    def test_fewer_solutions_than_found_are_partial(self):
        done = run("solve", "octahedron", "--strategy", "full-space", "--max-solutions", 1, "--out", "-")
        result = json.loads(done.stdout)
        self.assertEqual((done.returncode, result["status"], len(result["solutions"])), (DONE, "partial", 1))
        self.assertIn("1 of the 4", result["reason"])

    def test_what_is_found_is_counted_where_no_claim_says_how_many_there_are(self):
        out = self.folder / "result.json"
        done = run("solve", "disulfide", "--strategy", "explore", "--out", out)
        found = len(json.loads(out.read_text())["solutions"])
        self.assertGreater(found, 1)
        self.assertIn(f"{found} real solutions, up to reflection; there may be more\n", done.stdout)
        self.assertNotIn("may be more", run("solve", "disulfide", "--strategy", "monodromy").stdout)
        walked = run("solve", "octahedron", "--strategy", "explore", "--set", "mode=certified").stdout
        self.assertIn("; proven: no other is joined to them by curves with one value released\n", walked)

    def test_a_failed_check_is_exit_code_1(self):
        codes = set()
        for largest_step in [0.1, 0.4, 0.8]:
            done = run("solve", "disulfide", "--strategy", "rcp", "--set", "mode=paper",
                       "--set", f"step_max={largest_step}", "--out", "-")
            result = json.loads(done.stdout)
            if result["status"] != "complete":
                continue
            self.assertEqual(done.returncode, CHECK_FAILED if result["failed_checks"] else DONE)
            self.assertEqual(len(done.stderr.splitlines()), len(result["failed_checks"]))
            codes.add(done.returncode)
        self.assertEqual(codes, {DONE, CHECK_FAILED}, "find settings that are sloppy enough to jump")

    def test_no_sketch(self):
        out = self.folder / "result.json"
        done = run("solve", self.write(changed(sketch=None)), "--strategy", "full-space", "--out", out)
        self.assert_one_message(done, NOT_SOLVED, "sketch")
        result = json.loads(out.read_text())
        self.assertEqual((result["status"], result["solutions"]), ("unsupported", []))
        self.assertIsNone(result["counts"]["on_path"])

    def test_not_applicable(self):
        done = run("solve", "tangents-durand", "--strategy", "full-space")
        self.assert_one_message(done, NOT_SOLVED, "unsupported")

    def tangents(self, points, distances, given="length"):
        """A line at the given distances from the given points, or at given "squared" ones."""
        names = [f"c{i + 1}" for i in range(4)]
        distances = [{"type": "distance", "between": [name, "L"], given: length}
                     for name, length in zip(names, distances)]
        return self.write({"format": "gcsbench-instance/1", "id": "tangents", "dimension": 3, "points": names,
                           "lines": ["L"], "fixed": dict(zip(names, points)), "constraints": distances},
                          "tangents.json")

    def assert_infinite(self, instance, *mentioned):
        for method in ["direct", "homotopy"]:
            done = run("solve", instance, "--strategy", "sphere-tangents", "--set", f"method={method}", "--out", "-")
            result = json.loads(done.stdout)
            self.assertEqual((done.returncode, result["status"]), (NOT_SOLVED, "infinite"))
            for words in mentioned:
                self.assertIn(words, result["reason"])
                self.assertIn(words, done.stderr)

    def test_lines_at_distances_from_collinear_points(self):
        axis = [[0, 0, z] for z in (0, 1, 2, 4)]
        with self.subTest("one distance too large for the line that the others leave"):
            done = run("solve", self.tangents(axis, [1, 1, 1, 2]), "--strategy", "sphere-tangents", "--out", "-")
            result = json.loads(done.stdout)
            self.assertEqual((done.returncode, result["status"], result["solutions"]), (DONE, "complete", []))
        with self.subTest("the rulings of a cylinder"):
            self.assert_infinite(self.tangents(axis, [1, 1, 1, 1]), "collinear", "turned about")
        with self.subTest("the rulings of a hyperboloid"):  # squared distances 1 + z²/4
            squares = [1 + z * z / 4 for _, _, z in axis]
            self.assert_infinite(self.tangents(axis, squares, "squared"), "collinear", "turned about")
        with self.subTest("the axis itself"):
            self.assert_infinite(self.tangents(axis, [0, 0, 0, 0]), "distance 0")

    def test_lines_at_distances_from_coinciding_points(self):
        points = [[0, 0, 0], [3, 0, 0], [0, 3, 1], [0, 0, 0]]
        self.assert_infinite(self.tangents(points, [1, 1, 1, 1]), "two centres coincide")
        done = run("solve", self.tangents(points, [1, 1, 1, 2]), "--strategy", "sphere-tangents")
        self.assert_one_message(done, BAD_INPUT, "no figure has these lengths")

    def test_degenerate_tangents_are_described(self):
        done = run("describe", self.tangents([[0, 0, z] for z in (0, 1, 2, 4)], [1, 1, 1, 1]), "--json")
        self.assertEqual(done.returncode, DONE)
        self.assertTrue(json.loads(done.stdout))

    def test_only_real_solutions(self):
        solve = ["solve", "octahedron", "--strategy", "cayley-menger", "--certify", "--out", "-"]
        result = {kind: json.loads(run(*solve, "--solutions", kind).stdout) for kind in ("real", "all")}
        real = [one for one in result["all"]["solutions"] if one["real"]]
        self.assertEqual(result["real"]["solutions"], real)
        self.assertEqual(result["real"]["counts"]["certified"], len(real))
        self.assertIsNone(result["real"]["counts"]["complex_up_to_reflection"])

    def test_certificates(self):
        out = self.folder / "result.json"
        done = run("solve", "octahedron", "--strategy", "cayley-menger", "--certify", "--out", out)
        self.assertEqual(done.returncode, DONE)
        # Bartzos, Emiris, Schicho 2020: at most 16 in the fixed frame, 8 up to reflection.
        self.assertIn("proven: the upper bound of 8 is met", done.stdout)
        self.assertEqual(run("verify", out).returncode, DONE)
        real = run("solve", "octahedron", "--strategy", "cayley-menger", "--certify", "--solutions", "real")
        self.assertRegex(real.stdout, "certified +8 solutions exist")
        result = json.loads(out.read_text())
        result["solutions"][0]["points"]["p4"][0] += 1e-9
        out.write_text(json.dumps(result))
        done = run("verify", out)
        self.assertEqual(done.returncode, CHECK_FAILED)
        self.assertIn("solution 0 is 1e-09 away", done.stderr)

    def test_coordinates_beyond_doubles_come_with_their_digits(self):
        """The list is complete, by the bound of 8 for six points (16 in a frame)."""
        out = self.folder / "result.json"
        for scene in ["escaping@1e-8", "escaping@1e-10", "short-edge@1e-8", "short-edge@1e-10"]:
            done = run("solve", scene, "--strategy", "monodromy", "--certify", "--out", out)
            self.assertEqual((done.returncode, done.stderr), (DONE, ""))
            self.assertRegex(done.stdout, r"far +\d solutions? with coordinates so large")
            result = json.loads(out.read_text(), parse_float=Fraction)
            self.assertEqual((result["status"], result["reason"], len(result["solutions"])), ("complete", "", 8))
            far = [one for one in result["solutions"] if "decimals" in one]
            self.assertGreater(len(far), 0)
            for solution in far:
                for constraint in result["instance"]["constraints"]:
                    square = Fraction(constraint["squared"] if "squared" in constraint else constraint["length"] ** 2)
                    self.assertLess(abs(self.exact_square(solution, constraint["between"]) / square - 1), 1e-14)
            self.assertEqual(run("verify", out).returncode, DONE)

    def test_solutions_of_a_product_that_doubles_take_for_the_same_are_told_apart_by_proofs(self):
        out = self.folder / "result.json"
        for scene in ["mixed-lengths@1e-10", "mixed-lengths@1e-12"]:
            done = run("solve", scene, "--strategy", "monodromy", "--certify", "--out", out)
            self.assertEqual((done.returncode, done.stderr), (DONE, ""))
            result = json.loads(out.read_text())
            self.assertEqual((result["status"], result["counts"]["certified"]), ("complete", 32))
            self.assertTrue(result["proofs"]["complete"])

    @staticmethod
    def exact_square(solution, between):
        """Of the distance in decimals; where it is complex, how far it is from the real axis added."""
        ends = [solution["decimals"]["points"][point] for point in between]
        if solution["real"]:
            return sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(*ends))
        apart = [[Fraction(a[part]) - Fraction(b[part]) for part in (0, 1)] for a, b in zip(*ends)]
        return sum(re * re - im * im for re, im in apart) + abs(sum(2 * re * im for re, im in apart))

    def test_multiple_solutions_in_fractions_are_certified(self):
        done = run("solve", "tangents-fourfold", "--strategy", "sphere-tangents", "--certify")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertIn("3 of 3 solutions exist, each in a class of its own, 3 of them real", done.stdout)
        self.assertIn("3 solutions stand for 12, counted with multiplicities, as multiple ones", done.stdout)

    def test_what_is_not_proven_fails_a_check(self):
        done = run("solve", self.write(osculating(3, scale=3), "osculating-3-3.json"), "--strategy", "monodromy", "--certify")
        self.assertEqual(done.returncode, CHECK_FAILED)
        self.assertIn("singular", done.stderr)
        self.assertIn("1 solution stands for 3, counted with multiplicities, that are not told apart", done.stdout)

    def test_references(self):
        result, reference = self.folder / "result.json", self.folder / "reference.json"
        run("solve", "octahedron", "--strategy", "cayley-menger", "--out", result)
        self.assertEqual(run("reference", result, "--out", reference).returncode, DONE)
        found = json.loads(result.read_text())["solutions"]
        exact = json.loads(reference.read_text())["solutions"]
        self.assertEqual(len(exact), len(found))
        for one, other in zip(found, exact):
            self.assertLess(other["error_bound"], 1e-28)
            if one["real"]:
                for name, place in one["points"].items():
                    for number, text in zip(place, other["points"][name]):
                        self.assertAlmostEqual(number, float(text), delta=1e-13)

    def test_a_result_that_does_not_verify_makes_no_reference(self):
        result, reference = self.folder / "result.json", self.folder / "reference.json"
        done = run("solve", "octahedron", "--strategy", "cayley-menger", "--out", "-")
        content = json.loads(done.stdout)
        content["solutions"][0]["points"]["p4"][0] += 1e-9
        result.write_text(json.dumps(content))
        self.assert_one_message(run("reference", result, "--out", reference), BAD_INPUT, result, "does not verify")
        self.assertFalse(reference.exists())

    def test_time_limit(self):
        out = self.folder / "result.json"
        done = run(*ENDLESS, "--time-limit", "0.2", "--out", out)
        self.assertEqual(done.returncode, NOT_SOLVED)
        self.assertIn("timed out", done.stderr)
        self.assertEqual(json.loads(out.read_text())["status"], "timed out")

    def test_interrupt(self):
        out = self.folder / "result.json"
        with subprocess.Popen(argv(*ENDLESS, "--out", out), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, cwd=SOURCE) as process:
            self.wait_until_solving(process)
            process.send_signal(signal.SIGINT)
            _, messages = process.communicate(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED, messages)
        self.assertIn("interrupted", messages)
        self.assertEqual(json.loads(out.read_text())["status"], "interrupted")

    def wait_until_solving(self, process):
        """Until the program catches SIGINT, which it does right before it starts."""
        caught = 1 << (signal.SIGINT - 1)
        for _ in range(1000):
            status = Path(f"/proc/{process.pid}/status").read_text()
            mask = next(line for line in status.splitlines() if line.startswith("SigCgt"))
            if int(mask.split()[1], 16) & caught:
                return
            time.sleep(0.01)
        self.fail("the program never started to solve")


class Particulars(command_line.CommandLine):
    def test_are_in_the_summary_and_in_the_result(self):
        result = self.folder / "result.json"
        published = ["--strategy", "theta-scan", "--set", "method=published"]
        done = run("solve", "hoffmann-yuan", *published, "--out", result)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertIn("coarse solutions 224", done.stdout)
        self.assertIn("refined solutions 24", done.stdout)
        statistics = json.loads(result.read_text())["statistics"]
        self.assertEqual(statistics["coarse_solutions"], 224)
        self.assertEqual(statistics["evaluations"], 360)


if __name__ == "__main__":
    command_line.main()
