#!/usr/bin/python3
"""PHCpack as an external program: scripts/phcpack-solve and phcpack-three-lines write its systems and read its solutions.

The counts are those of the tables in the literature and of `gcsbench count`, which know nothing of PHCpack.

Usage: phcpack_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import command_line
from bad_instances import TOY
from command_line import PROGRAM, SOURCE, run
from general_scenes import PLATFORM, distances, planes

# A point on a cylinder about a given line and on two spheres, which meet in a circle: four by Bézout.
BESIDE_LINE = {
    "format": "gcsbench-instance/2", "id": "beside-line", "dimension": 3, "points": ["p", "q", "x"], "lines": ["L"],
    "fixed": {"p": [0, 0, 0], "q": [1, 0.2, -0.1], "L": {"point": [0.3, 0.4, 0.2], "direction": [0.2, 1, 0.4]}},
    "constraints": distances(("p", "x", 1.1), ("q", "x", 0.9), ("x", "L", 0.7)),
}

# A tetrahedron, or its mirror image, at four distances from a line that alone is given: for each the twelve common tangents
# of four spheres (Macdonald, Pach, Theobald 2001).
ABOUT_LINE = {
    "format": "gcsbench-instance/2", "id": "about-line", "dimension": 3, "points": list("abcd"), "lines": ["L"],
    "fixed": {"L": {"point": [0.3, -0.2, 0.5], "direction": [0.5, 0.1, 1]}},
    "constraints": distances(("a", "b", 2), ("a", "c", 2.1), ("a", "d", 2.3), ("b", "c", 1.9), ("b", "d", 2.2), ("c", "d", 1.8),
                             *((point, "L", length) for point, length in zip("abcd", (1, 0.9, 1.1, 0.8)))),
}

# How many solutions, and how many of them are real. Eight up to reflection, four of them real (octahedron) and two (K3,3):
# theory, and `cayley-menger` by another way; eight with planes and angles (Hoffmann, Yuan 2001); six of a 3-RPR platform
# (Hunt 1983).
KNOWN = {"k33": (8, 2), "octahedron": (8, 4), "octahedral-5p1h": (8, None), "planar-platform": (6, None),
         "three-planes": (8, None), "beside-line": (4, None), "about-line": (24, None)}
SCENES = {scene["id"]: scene for scene in (planes(), BESIDE_LINE, ABOUT_LINE)}


class Phcpack(unittest.TestCase):
    def solve(self, instance, *more):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "result.json"
            if instance in SCENES:
                scene, instance = SCENES[instance], Path(folder) / f"{instance}.json"
                instance.write_text(json.dumps(scene))
            done = run("--quiet", "solve", instance, "--strategy", "exec:scripts/phcpack-solve", "--out", out, *more)
            return done, json.loads(out.read_text())

    def test_all_complex_solutions_are_found_and_certified(self):
        if shutil.which("phc") is None:
            self.skipTest("phc is not installed (Debian: phcpack)")
        for instance, (classes, real) in KNOWN.items():
            with self.subTest(instance):
                done, result = self.solve(instance, "--certify")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual((result["status"], result["reason"]), ("complete", ""))
                counts = result["counts"]
                self.assertEqual(counts["complex"], classes)
                if real is not None:
                    self.assertEqual(counts["real"], real)
                self.assertEqual(counts["certified"], classes)

    def test_the_same_seed_gives_the_same_answer(self):
        if shutil.which("phc") is None:
            self.skipTest("phc is not installed (Debian: phcpack)")
        first, again = (self.solve("octahedron", "--seed", "5")[1] for _ in range(2))
        self.assertEqual(first["solutions"], again["solutions"])

    def test_the_frame_is_numbers_where_its_distances_are_given(self):
        """With the stub in place of phc, which shows its input and fails."""
        with tempfile.TemporaryDirectory() as folder:
            stub = Path(folder) / "phc"
            stub.write_text("#!/bin/sh\ntr '\\n' ' ' < system >&2\nexit 9\n")
            stub.chmod(0o755)
            text = (SOURCE / "instances" / "octahedron.json").read_text()
            done = subprocess.run([SOURCE / "scripts/phcpack-solve"], input=text, capture_output=True, text=True, timeout=60,
                                  check=True, env={"PATH": folder + ":/usr/bin:/bin", "GCSBENCH_PROGRAM": PROGRAM})
        answer = json.loads(done.stdout)
        self.assertEqual(answer["status"], "gave up")
        self.assertIn("status 9", answer["reason"])
        self.assertIn("p5_z", answer["reason"])
        self.assertNotIn("p2_x", answer["reason"])

    def test_without_phc_it_says_what_is_missing(self):
        text = (SOURCE / "instances" / "k33.json").read_text()
        done = subprocess.run(["/usr/bin/python3", SOURCE / "scripts/phcpack-solve"], input=text, capture_output=True,
                              text=True, timeout=60, check=True, env={"PATH": "/nowhere"})
        answer = json.loads(done.stdout)
        self.assertEqual(answer["status"], "gave up")
        self.assertIn("phcpack", answer["reason"])

    def test_what_has_no_equations_is_given_up_with_the_reason(self):
        """It needs no phc, but one to be there."""
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "phc").symlink_to("/bin/false")
            done = subprocess.run([SOURCE / "scripts/phcpack-solve"], input="{}", capture_output=True, text=True, timeout=60,
                                  check=True, env={"PATH": folder + ":/usr/bin:/bin", "GCSBENCH_PROGRAM": PROGRAM})
        answer = json.loads(done.stdout)
        self.assertEqual(answer["status"], "gave up")
        self.assertIn("format", answer["reason"])

    def test_the_equations_of_three_lines_hold_at_all_their_solutions(self):
        """Those that monodromy finds by equations of its own."""
        script = command_line.load_script("phcpack-three-lines")
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "result.json"
            instance = SOURCE / "instances" / "three-points-three-lines-angles.json"
            self.assertEqual(run("--quiet", "solve", instance, "--strategy", "monodromy", "--out", out).returncode, 0)
            solutions = json.loads(out.read_text())["solutions"]
        self.assertEqual(len(solutions), 960)
        scene = script.Scene(json.loads(instance.read_text()))
        names, text = scene.polynomials()
        system = script.phcpack.Polynomials(text)
        for solution in solutions:
            known = {}
            for line, of in names.items():
                position = {part: [complex(*c) if isinstance(c, list) else c for c in numbers]
                            for part, numbers in solution["lines"][line].items()}
                u = [c / position["direction"][0] for c in position["direction"]]
                f = position["point"]
                known |= dict(zip(of, u[1:] + [f[i] * u[j] - f[j] * u[i] for i, j in ((1, 2), (2, 0), (0, 1))]))
                placed = script.placed([1, *u[1:]], [known[name] for name in of[2:]])
                self.assertLess(max(abs(a - b) for a, b in zip(placed["point"], f)), 1e-8 * (1 + max(map(abs, f))))
            values = [known[name] for name in system.names]
            size = 1 + max(map(abs, values))
            for row in system.linearised(values):
                self.assertLess(abs(row[-1]), 1e-9 * size * (1 + max(map(abs, row[:-1]))))

    def test_three_lines_are_refused_where_there_are_none(self):
        text = (SOURCE / "instances" / "k33.json").read_text()
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "phc").symlink_to("/bin/false")
            done = subprocess.run([SOURCE / "scripts/phcpack-three-lines"], input=text, capture_output=True, text=True,
                                  timeout=60, check=True, env={"PATH": folder + ":/usr/bin:/bin"})
        answer = json.loads(done.stdout)
        self.assertEqual(answer["status"], "gave up")
        self.assertIn("three points and three lines", answer["reason"])

    def regular_ends(self, instance):
        """How many regular ends `phc -b` lists of the equations that `describe` prints."""
        with tempfile.TemporaryDirectory() as folder:
            scene, answer = Path(folder) / f"{instance['id']}.json", Path(folder) / "answer"
            scene.write_text(json.dumps(instance))
            done = run("describe", scene, "--equations", "phc")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            (Path(folder) / "system").write_text(done.stdout)
            subprocess.run(["phc", "-b", "-01", "system", "answer"], cwd=folder, capture_output=True, timeout=120, check=True)
            text = answer.read_text()
        return text[text.rindex("THE SOLUTIONS"):].count(" regular ==")

    def test_it_solves_the_equations_that_describe_prints(self):
        """Six postures of a planar platform (Hunt 1983); of four points placed one by one 2 classes with every choice of 2
        signs."""
        if shutil.which("phc") is None:
            self.skipTest("phc is not installed (Debian: phcpack)")
        self.assertEqual(self.regular_ends(PLATFORM), 6)
        self.assertEqual(self.regular_ends(TOY), 8)


if __name__ == "__main__":
    if shutil.which("phc") is None:
        print("phc is not installed (Debian: phcpack): what needs it is skipped")
    ended = command_line.main(exit=False)
    if not ended.result.wasSuccessful():
        sys.exit(1)
    sys.exit(77 if ended.result.skipped else 0)
