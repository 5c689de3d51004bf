#!/usr/bin/python3
"""Scenes of planes, bodies and angles from outside: solved, stored, verified.

Usage: general_scenes_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json

import command_line
from command_line import BAD_INPUT, CHECK_FAILED, DONE, NOT_SOLVED, run
from general_scenes import PLATFORM, TRIANGLE, planes


class GeneralScenes(command_line.CommandLine):
    def instance(self, scene):
        return self.write(scene, f"{scene['id']}.json")

    def solved(self, scene):
        """The path of a certified result of that scene."""
        out = self.folder / "result.json"
        done = run("--quiet", "solve", self.instance(scene), "--strategy", "monodromy", "--certify", "--out", out)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        return out

    def verified(self, result):
        return run("--quiet", "verify", self.write(result, "changed.json"))

    def assert_mismatch(self, result, *words):
        done = self.verified(result)
        self.assertEqual(done.returncode, CHECK_FAILED, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_counts_say_their_convention(self):
        result = json.loads(self.solved(PLATFORM).read_text())
        counts = result["counts"]
        self.assertEqual((counts["convention"], counts["complex"], counts["certified"]), ("up to motion", 6, 6))
        self.assertEqual(counts["real"], sum(solution["real"] for solution in result["solutions"]))
        self.assertIsNone(counts["real_up_to_reflection"])
        self.assertIsNone(counts["complex_up_to_reflection"])
        self.assertEqual(result["frame"], {"body": "base"})
        counts = json.loads(self.solved(planes()).read_text())["counts"]
        self.assertEqual([counts[name] for name in ["convention", "complex", "complex_up_to_reflection"]],
                         ["up to reflection", 8, 8])

    def test_results_verify_and_make_references(self):
        for scene, count in [(PLATFORM, 6), (planes(), 8)]:
            out = self.solved(scene)
            done = run("--quiet", "verify", out)
            self.assertEqual((done.returncode, done.stderr), (DONE, ""))
            done = run("--quiet", "reference", out, "--out", "-")
            self.assertEqual((done.returncode, done.stderr), (DONE, ""))
            reference, result = json.loads(done.stdout), json.loads(out.read_text())
            self.assertEqual(len(reference["solutions"]), count)
            for exact, found in zip(reference["solutions"], result["solutions"]):
                self.assert_same(exact, found)

    def assert_same(self, exact, found):
        """Decimals as text against the numbers of the result."""
        self.assertEqual(exact["real"], found["real"])
        for kind in ["points", "lines", "planes"]:
            self.assertEqual(kind in exact, kind in found)
            pairs = zip(self.numbers(exact.get(kind, {})), self.numbers(found.get(kind, {})), strict=True)
            for a, b in pairs:
                self.assertAlmostEqual(a, b, delta=1e-9)

    def numbers(self, value):
        if isinstance(value, dict):
            return [n for key in sorted(value) for n in self.numbers(value[key])]
        if isinstance(value, list):
            return [n for one in value for n in self.numbers(one)]
        return [float(value)]

    def test_offsets_are_in_the_unit_of_the_file(self):
        """As all lengths; and normals are not."""
        unit = 1024
        one, scaled = (json.loads(self.solved(planes(u)).read_text())["solutions"][0]["planes"]["e5"] for u in [1, unit])
        self.assertEqual(scaled["offset"], unit * one["offset"])
        self.assertEqual(scaled["normal"], one["normal"])

    def test_what_is_no_solution_is_caught(self):
        result = json.loads(self.solved(planes()).read_text())
        self.assertTrue(result["solutions"][0]["real"])

        def change(spoil):
            spoiled = json.loads(json.dumps(result))
            spoil(spoiled["solutions"])
            return spoiled

        def move(solutions):
            solutions[0]["points"]["e3"][1] += 1e-9

        def shift(solutions):
            solutions[0]["planes"]["e4"]["offset"] += 1e-9

        def turn(solutions):
            plane = solutions[0]["planes"]["e4"]
            plane.update(normal=[-x for x in plane["normal"]], offset=-plane["offset"])

        self.assertEqual(self.verified(change(lambda solutions: None)).returncode, DONE)
        for spoil in [move, shift, turn]:
            self.assert_mismatch(change(spoil), "solution 0")
        self.assert_mismatch(change(lambda solutions: solutions.append(solutions[0])), "the same class as solution 0")
        self.assert_mismatch({**result, "counts": {**result["counts"], "convention": "up to motion"}}, "up to motion")

        def drop(solutions):
            del solutions[0]["planes"]["e4"]

        self.assert_one_message(self.verified(change(drop)), BAD_INPUT, "/solutions/0/planes", "e4")

    def test_an_orientation_selects_and_loses_nothing(self):
        out = self.solved(TRIANGLE)
        result = json.loads(out.read_text())
        counts = {name: result["counts"][name] for name in ["convention", "real", "complex", "not_as_stated", "undecided"]}
        self.assertEqual(counts, {"convention": "up to motion", "real": 1, "complex": 2, "not_as_stated": 1, "undecided": 0})
        self.assertEqual(result["proofs"]["real"], 1)
        solutions = [(s["standing"], s["against"], round(s["points"]["c"][1], 9)) for s in result["solutions"]]
        self.assertEqual(solutions, [("as stated", [], -4), ("not as stated", ["side"], 4)])

        summary = run("solve", self.instance(TRIANGLE), "--strategy", "monodromy").stdout
        verified = run("--quiet", "verify", out)
        self.assertEqual((verified.returncode, verified.stderr), (DONE, ""))
        for text in [summary, verified.stdout]:
            self.assertRegex(text, "not as stated +1 more real solution of the equations: 1 against 'side'")
        self.assertRegex(summary, "real +1 solution, up to motion")

        listed = result["solutions"]
        for standing, word in [("as stated", "proven to be 'not as stated'"), ("undecided", "not_as_stated")]:
            self.assert_mismatch({**result, "solutions": [listed[0], {**listed[1], "standing": standing}]}, word)
        self.assert_mismatch({**result, "counts": {**result["counts"], "real": 2}}, "the count real is 2")
        self.assert_one_message(self.verified({**result, "solutions": [{**listed[0], "against": ["edge"]}, listed[1]]}),
                                BAD_INPUT, "/solutions/0/against/0", "edge")

    def test_without_an_orientation_nothing_is_said_of_it(self):
        result = json.loads(self.solved(PLATFORM).read_text())
        self.assertEqual({"not_as_stated", "undecided"} & set(result["counts"]), set())
        self.assertEqual({"standing", "against"} & set(result["solutions"][0]), set())

    def test_a_body_that_is_bent_or_moved_is_caught(self):
        result = json.loads(self.solved(PLATFORM).read_text())
        for point in ["a2", "b3"]:
            spoiled = json.loads(json.dumps(result))
            spoiled["solutions"][0]["points"][point][0] += 1e-9
            self.assert_mismatch(spoiled, "solution 0")

    def test_what_does_not_know_them_says_so(self):
        instance = self.instance(PLATFORM)
        self.assert_one_message(run("path", instance, "--out", self.folder / "path.json"), NOT_SOLVED, "distances")
        done = run("tables", "table1", "--instances", instance)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("does not know", done.stderr)

    def test_a_reference_has_as_many_digits_as_are_asked_for(self):
        for scene, count in [(PLATFORM, 6), (planes(), 8)]:
            result = self.solved(scene)
            out = self.folder / "reference.json"
            self.assertEqual(run("--quiet", "reference", result, "--digits", "40", "--out", out).returncode, DONE)
            solutions = json.loads(out.read_text())["solutions"]
            self.assertEqual(len(solutions), count)
            for solution in solutions:
                self.assertLessEqual(solution["error_bound"], 1e-38)


if __name__ == "__main__":
    command_line.main()
