#!/usr/bin/python3
"""The program from outside: exit codes, what goes to which stream, and every kind of bad input.

Usage: command_line_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # the source folder stays clean
from bad_instances import BAD_FILES, TOY, changed, with_constraint

PROGRAM = ""
SOURCE = Path()

DONE, CHECK_FAILED, BAD_INPUT, NOT_SOLVED, INTERRUPTED = 0, 1, 2, 3, 130

# A solve that takes far longer than any test waits.
ENDLESS = ["solve", "icosahedron", "--strategy", "full-space", "--set", "step_max=1e-6"]


def run(*arguments, text_in="", cwd=None):
    """Runs the program; returns the completed process with text streams."""
    return subprocess.run([PROGRAM, *map(str, arguments)], input=text_in, capture_output=True, text=True,
                          timeout=120, cwd=cwd or SOURCE, check=False)


class CommandLine(unittest.TestCase):
    """Shared checks."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, content, name="toy.json"):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        elif isinstance(content, str):
            path.write_text(content)
        else:
            path.write_text(json.dumps(content))
        return path

    def assert_one_message(self, done, code, *mentioned):
        """One line for a person on standard error, nothing on standard output."""
        self.assertEqual(done.returncode, code, done.stderr[:2000])
        self.assertEqual(done.stdout, "")
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr[:2000])
        self.assertTrue(lines[0].startswith("gcsbench: "), lines[0][:2000])
        self.assertLess(len(lines[0]), 1000)
        for word in mentioned:
            self.assertIn(str(word), lines[0])

    def repeatable_part(self, done):
        """The result on standard output but for what may differ between two runs."""
        self.assertEqual(done.returncode, DONE, done.stderr)
        result = json.loads(done.stdout)
        del result["timing"], result["environment"]
        return result

    def assert_usage_error(self, done, *mentioned):
        """A message, then the usage, on standard error."""
        self.assertEqual(done.returncode, BAD_INPUT, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertTrue(done.stderr.startswith("gcsbench: "), done.stderr)
        self.assertIn("Usage: gcsbench", done.stderr)
        for word in mentioned:
            self.assertIn(word, done.stderr)


class BadFiles(CommandLine):
    def test_content(self):
        for name, (content, pointer) in BAD_FILES.items():
            with self.subTest(name):
                path = self.write(content)
                done = run("describe", path)
                self.assert_one_message(done, BAD_INPUT, path, pointer)

    def test_the_same_message_from_solve(self):
        path = self.write(with_constraint(2, length=-5))
        done = run("solve", path, "--strategy", "full-space", "--out", self.folder / "out.json")
        self.assert_one_message(done, BAD_INPUT, path, "/constraints/2/length")
        self.assertFalse((self.folder / "out.json").exists())

    def test_standard_input(self):
        self.assert_one_message(run("describe", "-", text_in="{"), BAD_INPUT)
        self.assertEqual(run("describe", "-", text_in=json.dumps(changed(id="other"))).returncode, DONE)

    def test_missing_file(self):
        self.assert_one_message(run("describe", self.folder / "none.json"), BAD_INPUT, "none.json")

    def test_directory(self):
        self.assert_one_message(run("describe", str(self.folder) + "/"), BAD_INPUT, self.folder)

    def test_unknown_id(self):
        self.assert_one_message(run("describe", "disulfid"), BAD_INPUT, "disulfide")


class Usage(CommandLine):
    def test_errors(self):
        solve = ["solve", "octahedron", "--strategy", "full-space"]
        cases = {
            "nothing": ([], ""),
            "unknown command": (["solv", "octahedron"], "did you mean 'solve'"),
            "flag without a command": (["--jsn"], "--jsn"),
            "unknown flag": (["list", "--jsn"], "--jsn"),
            "unknown thing to list": (["list", "problems"], "problems"),
            "no instance": (["solve", "--strategy", "full-space"], "INSTANCE"),
            "no strategy": (["solve", "octahedron"], "--strategy"),
            "two instances": (["describe", "octahedron", "k33"], "k33"),
            "unknown strategy": (["solve", "octahedron", "--strategy", "fullspace"], "did you mean 'full-space'"),
            "unknown option": (solve + ["--set", "ordr=8"], "did you mean 'order'"),
            "option without value": (solve + ["--set", "order"], "option=value"),
            "option without name": (solve + ["--set", "=8"], "option=value"),
            "option twice": (solve + ["--set", "order=8", "--set", "order=9"], "twice"),
            "negative seed": (solve + ["--seed", "-1"], "--seed"),
            "fractional seed": (solve + ["--seed", "1.5"], "--seed"),
            "seed beyond 64 bits": (solve + ["--seed", "18446744073709551616"], "--seed"),
            "no threads": (solve + ["--threads", "0"], "--threads"),
            "no time": (solve + ["--time-limit", "0"], "--time-limit"),
            "negative time": (solve + ["--time-limit", "-1"], "--time-limit"),
            "time that is no number": (solve + ["--time-limit", "nan"], "--time-limit"),
            "endless time": (solve + ["--time-limit", "inf"], "--time-limit"),
            "no solutions": (solve + ["--max-solutions", "0"], "--max-solutions"),
            "other solutions": (solve + ["--solutions", "some"], "--solutions"),
        }
        for name, (arguments, mentioned) in cases.items():
            with self.subTest(name):
                self.assert_usage_error(run(*arguments), mentioned)

    def test_option_value(self):
        for value in ["fast", "", "1e999", "-3", "nan"]:
            with self.subTest(value):
                done = run("solve", "octahedron", "--strategy", "full-space", "--set", "order=" + value)
                self.assert_one_message(done, BAD_INPUT, "order=" + value)

    def test_help_and_version(self):
        for arguments in [["--help"], ["--version"], ["list", "--help"], ["describe", "--help"], ["count", "--help"],
                          ["solve", "--help"]]:
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual(done.returncode, DONE)
                self.assertEqual(done.stderr, "")
                self.assertIn("gcsbench", done.stdout)
        self.assertIn("Examples:", run("solve", "--help").stdout)


class ListAndDescribe(CommandLine):
    def test_list(self):
        text = run("list").stdout
        data = json.loads(run("list", "--json").stdout)
        self.assertEqual(sorted(data), ["instances", "left_out", "strategies"])
        for one in data["instances"]:
            self.assertIn(one["id"], text)
        for one in data["strategies"]:
            self.assertIn(one["name"], text)
        ids = [path.stem for path in (SOURCE / "instances").glob("*.json") if path.stem != "schema"]
        self.assertEqual([one["id"] for one in data["instances"]], sorted(ids))

    def test_list_one_kind_one_line_each(self):
        for what in ["instances", "strategies"]:
            data = json.loads(run("list", what, "--json").stdout)
            self.assertEqual(list(data), [what])
            lines = run("list", what).stdout.splitlines()
            present = [line for line in lines if not line.startswith("off in this build: ")]
            self.assertEqual(len(present), len(data[what]))

    def test_every_shipped_instance_is_described(self):
        for one in json.loads(run("list", "instances", "--json").stdout)["instances"]:
            with self.subTest(one["id"]):
                done = run("describe", one["id"], "--json")
                self.assertEqual((done.returncode, done.stderr), (DONE, ""))
                data = json.loads(done.stdout)
                self.assertTrue(data["degrees_of_freedom"]["rigid"])
                self.assertEqual(data["degrees_of_freedom"]["unknowns"], one["constraints"])
                self.assertIn(one["title"], run("describe", one["id"]).stdout)

    def test_core(self):
        data = json.loads(run("describe", self.write(TOY), "--json").stdout)["core"]
        self.assertTrue(data["trivial"])
        self.assertEqual(data["entities"], ["p1", "p2"])
        self.assertEqual(sorted(one["place"] for one in data["placed"]), ["p3", "p4"])
        data = json.loads(run("describe", "octahedron", "--json").stdout)["core"]
        self.assertFalse(data["trivial"])
        self.assertEqual(data["placed"], [])

    def test_construction_plan(self):
        plan = json.loads(run("describe", "disulfide", "--json").stdout)["construction"]
        self.assertEqual(plan["driving_parameters"], 1)
        self.assertEqual(len(plan["removed"]), 1)
        self.assertEqual(len(plan["instructions"]), 8)
        self.assertIsNone(json.loads(run("describe", "prism", "--json").stdout)["construction"])

    def test_why_a_strategy_does_not_apply(self):
        data = json.loads(run("describe", self.write(changed(sketch=None)), "--json").stdout)
        verdict = {one["name"]: one for one in data["strategies"]}["full-space"]
        self.assertFalse(verdict["applies"])
        self.assertIn("sketch", verdict["why_not"])

    def test_ids_are_found_from_anywhere(self):
        self.assertEqual(run("describe", "octahedron", cwd=self.folder).returncode, DONE)


class Solve(CommandLine):
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

    def test_fewer_solutions_than_found_are_partial(self):
        done = run("solve", "octahedron", "--strategy", "full-space", "--max-solutions", 1, "--out", "-")
        result = json.loads(done.stdout)
        self.assertEqual((done.returncode, result["status"], len(result["solutions"])), (DONE, "partial", 1))
        self.assertIn("1 of the 4", result["reason"])

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
        result = json.loads(out.read_text())
        result["solutions"][0]["points"]["p4"][0] += 1e-9
        out.write_text(json.dumps(result))
        done = run("verify", out)
        self.assertEqual(done.returncode, CHECK_FAILED)
        self.assertIn("solution 0 is 1e-09 away", done.stderr)

    def test_what_is_not_proven_fails_a_check(self):
        done = run("solve", "tangents-fourfold", "--strategy", "sphere-tangents", "--certify")
        self.assertEqual(done.returncode, CHECK_FAILED)
        self.assertIn("singular", done.stderr)

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
        with subprocess.Popen([PROGRAM, *ENDLESS, "--out", out], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
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


class Particulars(CommandLine):
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


class Output(CommandLine):
    SOLVE = ["solve", "octahedron", "--strategy", "full-space", "--out"]

    def test_unwritable(self):
        for place in [self.folder / "none" / "result.json", self.folder, "/proc/result.json"]:
            with self.subTest(place):
                self.assert_one_message(run(*self.SOLVE, place), BAD_INPUT, place, "cannot be written")

    def test_a_failure_leaves_the_old_file(self):
        out = self.write("old", "result.json")
        run("solve", self.write("{"), "--strategy", "full-space", "--out", out)
        self.assertEqual(out.read_text(), "old")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["result.json", "toy.json"])

    def test_an_old_file_is_replaced_and_a_link_kept(self):
        out = self.write("old", "result.json")
        link = self.folder / "link.json"
        link.symlink_to(out)
        self.assertEqual(run(*self.SOLVE, link).returncode, DONE)
        self.assertTrue(link.is_symlink())
        self.assertEqual(json.loads(out.read_text())["status"], "complete")

    def test_a_device_stays_a_device(self):
        self.assertEqual(run(*self.SOLVE, "/dev/null").returncode, DONE)
        self.assertTrue(Path("/dev/null").is_char_device())

    def test_a_full_disk(self):
        self.assertEqual(run(*self.SOLVE, "/dev/full").returncode, BAD_INPUT)
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([PROGRAM, *self.SOLVE, "-"], stdout=full, stderr=subprocess.PIPE, text=True,
                                  cwd=SOURCE, check=False)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("standard output", done.stderr)


if __name__ == "__main__":
    PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), Path(sys.argv[2]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
