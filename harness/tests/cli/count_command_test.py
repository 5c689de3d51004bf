#!/usr/bin/python3
"""`gcsbench count` from outside: numbers of the literature, conventions, reasons, and bad input.

Usage: count_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import unittest

import command_line
from command_line import BAD_INPUT, DONE, SOURCE, run


class Count(unittest.TestCase):
    def counts(self, instance, text_in=""):
        done = run("count", instance, "--json", text_in=text_in)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        return json.loads(done.stdout)

    # Exact: Capco et al. 2018; the most of three to fourteen points OEIS A306420. Bounds: Bartzos, Emiris, Schicho 2020; for the disulfide bond, a ring of two
    # tetrahedra and four triangles, 2·2·16 by the bound 16 of a closed chain of six hinges.
    def test_literature(self):
        most = (2, 4, 8, 24, 56, 136, 344, 880, 2288, 6180, 15536, 42780)
        exact = {"k33": 16, "prism": 24, "dodecagon": 6180, **{f"laman-most@{n}": count for n, count in enumerate(most, 3)}}
        bound = {"octahedron": 16, "icosahedron": 54272, "dodecagon": 15360, "disulfide": 64}
        for instance, number in exact.items():
            self.assertEqual(self.counts(instance)["exact"]["fixed_frame"], number)
        for instance, number in bound.items():
            self.assertEqual(self.counts(instance)["bound"]["fixed_frame"], number)
        # With planes as of points alone: Hoffmann, Yuan 2000.
        for instance in ["octahedral-5p1h", "octahedral-4p2h", "octahedral-3p3h"]:
            self.assertEqual(self.counts(instance)["bound"]["up_to_reflection"], 8)

    # Gallet, Grasegger, Schicho 2020.
    def test_on_the_sphere(self):
        for instance, number in {"k33": 16, "prism": 32}.items():
            data = json.loads(run("count", instance, "--on", "sphere", "--json").stdout)
            self.assertEqual(data, {"id": instance, "on": "sphere", "why_no_exact": None,
                                    "exact": {"fixed_frame": number, "up_to_reflection": number // 2}})
            self.assertIn(f"exactly {number} in the fixed frame", run("count", instance, "--on", "sphere").stdout)
        data = json.loads(run("count", "octahedron", "--on", "sphere", "--json").stdout)
        self.assertIsNone(data["exact"])
        self.assertIn("plane", data["why_no_exact"])
        self.assertEqual(run("count", "prism", "--on", "torus").returncode, BAD_INPUT)

    def test_conventions(self):
        self.assertEqual(self.counts("dodecagon")["exact"],
                         {"fixed_frame": 6180, "up_to_reflection": 3090, "all_signs": 12360})
        conventions = ["fixed_frame", "up_to_reflection", "all_signs"]
        bound = self.counts("hoffmann-yuan")["bound"]
        self.assertEqual([bound[name] for name in conventions], [288, 72, 576])
        self.assertIn("wheel", bound["theorem"])
        # A triangle in the place of the wheel, on which the fourth point hangs.
        scene = json.loads((SOURCE / "instances" / "hoffmann-yuan.json").read_text())
        next(c for c in scene["constraints"] if c["id"] == "a10").update(between=["p1", "p3"])
        bound = self.counts("-", json.dumps(scene))["bound"]
        self.assertEqual([bound[name] for name in conventions], [512, 128, 1024])
        self.assertEqual(bound["reference"], ["L", "p1"])  # the first of those that serve as well

    def test_a_bound_says_what_it_is_of(self):
        bodies = ["p1 p2 p3", "p1 p2 p7 p8", "p2 p3 p4", "p3 p4 p5 p6", "p5 p6 p7", "p6 p7 p8"]
        self.assertIn("cubic and a quartic", run("count", "tangents-durand").stdout)
        ring = self.counts("disulfide")["bound"]["ring"]
        self.assertEqual(sorted(" ".join(body) for body in ring), bodies)
        text = run("count", "disulfide").stdout
        for body in bodies:
            self.assertIn(body, text)
        self.assertEqual(self.counts("octahedron")["bound"]["ring"], [])
        self.assertIn("m-Bézout bound with p1, p2, p3 held fixed\n", run("count", "octahedron").stdout)
        self.assertNotIn("at_infinity", self.counts("octahedron")["bound"])
        bound = self.counts("g16b")["bound"]
        self.assertEqual((bound["fixed_frame"], bound["at_infinity"]), (16, [["p6", "p7"]]))
        self.assertIn("held fixed, less solutions with p6 p7 at infinity at all lengths\n", run("count", "g16b").stdout)

    def test_a_number_or_the_reason_why_there_is_none(self):
        for one in json.loads(run("list", "instances", "--json").stdout)["instances"]:
            with self.subTest(one["id"]):
                data = self.counts(one["id"])
                text = run("count", one["id"]).stdout
                instance = json.loads((SOURCE / "instances" / f"{one['id']}.json").read_text(encoding="utf-8"))
                # Scenes beyond points, a line and distances are counted in their own convention.
                is_general = instance["format"] == "gcsbench-instance/2"
                for what in ["exact", "bound"]:
                    self.assertEqual(data[what] is None, data["why_no_" + what] is not None)
                    count = data[what] or {}
                    number = (is_general and count.get("up_to_reflection")) or count.get("fixed_frame")
                    shown = data["why_no_" + what] or str(number)
                    self.assertIn(shown, text)
                described = json.loads(run("describe", one["id"], "--json").stdout)["theoretical_counts"]
                self.assertEqual({"id": one["id"], **described}, data)
                self.assertIn(text, run("describe", one["id"]).stdout)

    def test_large_numbers_are_exact(self):
        points = [f"p{i}" for i in range(80)]
        chain = [{"type": "distance", "between": [points[i], points[j]], "length": 1}
                 for i in range(80) for j in range(max(0, i - 2), i)]
        instance = {"format": "gcsbench-instance/1", "id": "chain", "dimension": 2, "points": points,
                    "constraints": chain}
        data = self.counts("-", json.dumps(instance))
        self.assertEqual(data["exact"]["fixed_frame"], str(2**78))
        self.assertEqual(data["bound"]["all_signs"], str(2**79))

    def test_bad_input(self):
        cases = {"no JSON": (["count", "-"], "standard input"), "no such instance": (["count", "dodecagn"], "dodecagon"),
                 "no instance": (["count"], "INSTANCE")}
        for name, (arguments, mentioned) in cases.items():
            with self.subTest(name):
                done = run(*arguments, text_in="{")
                self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
                self.assertTrue(done.stderr.startswith("gcsbench: "), done.stderr)
                self.assertIn(mentioned, done.stderr)


if __name__ == "__main__":
    command_line.main()
