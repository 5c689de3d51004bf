#!/usr/bin/python3
"""`gcsbench describe` from outside: scenes of more than distances, and equations for other solvers.

Usage: describe_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import re
from itertools import combinations

import command_line
from command_line import DONE, NOT_SOLVED, run
from general_scenes import PLATFORM, distances, planes

DISTANCES_ALONE = ["core to solve", "lengths >= 0", "placed after it"]


def leaves(node):
    """Of lists and objects, in order."""
    parts = node.values() if isinstance(node, dict) else node if isinstance(node, list) else None
    return [node] if parts is None else [leaf for part in parts for leaf in leaves(part)]


class Describe(command_line.CommandLine):
    def instance(self, scene):
        return self.write(scene, f"{scene['id']}.json")

    def solved(self, instance, strategy):
        """The real solutions that it finds."""
        done = run("--quiet", "solve", instance, "--strategy", strategy, "--solutions", "real", "--out", "-")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        return json.loads(done.stdout)["solutions"]

    def equations(self, instance):
        """The unit of length of the equations that are printed, and these."""
        done = run("describe", instance, "--equations", "text")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        remark, *lines = done.stdout.splitlines()
        return float(re.fullmatch(r"# .*units of (\S+?);.*", remark)[1]), lines

    def assert_hold(self, lines, values):
        for line in lines:
            left, right = (eval(side, dict(values)) for side in line.replace("^", "**").split(" = "))  # pylint: disable=eval-used
            self.assertAlmostEqual(left, right, delta=1e-12)

    def test_description(self):
        done = run("describe", self.instance(PLATFORM))
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        for words in ["6 points, 2 bodies in the plane", "4 unknowns, 4 equations: rigid", "body base", "up to motion",
                      "at most 6 up to motion", "b1, b2, b3"]:
            self.assertIn(words, done.stdout)
        for words in DISTANCES_ALONE + ["not rigid", "up to reflection"]:
            self.assertNotIn(words, done.stdout)
        text = run("describe", self.instance(planes())).stdout
        for words in ["3 points, 3 planes in space", "up to reflection", "origin e1, axis e2, plane e3"]:
            self.assertIn(words, text)

    def test_construction_plan(self):
        for instance, parameters, instruction in [
                ("octahedral-4p2h", 1, "e4 from e2 (a6), e3 (a8); 1 driving parameter"),
                ("two-lines", 0, "M from c1 (a5), c2 (a6), c3 (a7), c4 (a8)"),
                ("octahedron-line", 1, "L from p1 (a13), p2 (a14), p4 (a15), p6 (a16)")]:
            with self.subTest(instance):
                plan = json.loads(run("describe", instance, "--json").stdout)["construction"]
                self.assertEqual(plan["driving_parameters"], parameters)
                self.assertIn(instruction, plan["instructions"])
                self.assertIn(f"derived; driving parameters: {parameters}\n", run("describe", instance).stdout)
        instance = self.instance(PLATFORM)
        self.assertIsNone(json.loads(run("describe", instance, "--json").stdout)["construction"])
        self.assertIn("none: no instruction places the body 'platform'", run("describe", instance).stdout)

    def test_description_for_programs(self):
        described = json.loads(run("describe", self.instance(PLATFORM), "--json").stdout)
        self.assertEqual(described["bodies"], {"base": ["a1", "a2", "a3"], "platform": ["b1", "b2", "b3"]})
        self.assertEqual(described["degrees_of_freedom"],
                         {"unknowns": 4, "equations": 4, "rigid": True, "why_not_rigid": None})
        self.assertEqual((described["frame"], described["convention"]), ({"body": "base"}, "up to motion"))
        for name in ["core", "parts", "interpolation", "reference"]:
            self.assertIsNone(described[name])
        bound = described["theoretical_counts"]["bound"]
        self.assertEqual((bound["fixed_frame"], bound["up_to_reflection"]), (6, None))

    def test_equations_hold_at_a_solution(self):
        """By the names that --help says."""
        instance = self.instance(PLATFORM)
        unit, lines = self.equations(instance)
        self.assertEqual(len(lines), 4)
        for solution in self.solved(instance, "monodromy"):
            start, end = (complex(*solution["points"][name]) / unit for name in ["b1", "b2"])
            turn = (end - start) * unit / complex(*PLATFORM["bodies"]["platform"]["b2"])
            self.assert_hold(lines, {"platform_tx": start.real, "platform_ty": start.imag,
                                     "platform_ex": turn.real, "platform_ey": turn.imag})

    def test_equations_of_planes_hold_at_a_solution(self):
        instance = self.instance(planes())
        unit, lines = self.equations(instance)
        for solution in self.solved(instance, "monodromy"):
            values = {f"{name}_{axis}": x / unit for name, point in solution["points"].items() for axis, x in zip("xyz", point)}
            for name, plane in solution["planes"].items():
                values.update((f"{name}_n{axis}", x) for axis, x in zip("xyz", plane["normal"]))
                values[f"{name}_h"] = plane["offset"] / unit
            self.assert_hold(lines, values)

    def test_equations_of_distances_hold_at_a_solution(self):
        unit, lines = self.equations("k33")
        self.assertEqual(len(lines), 9)
        for solution in self.solved("k33", "monodromy"):
            self.assert_hold(lines, {f"{name}_{axis}": x / unit for name, point in solution["points"].items()
                                     for axis, x in zip("xyz", point)})

    def equations_and_positions(self, instance, form):
        """For PHCpack, and the positions in their unknowns."""
        done = run("describe", instance, "--equations", form)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        lines = done.stdout.splitlines()
        return [line.rstrip(";") for line in lines[1:int(lines[0]) + 1]], json.loads(lines[-1])

    def test_equations_hold_where_positions_are_a_solution(self):
        """Each unknown is a coordinate of one, times a number. Of the points of a frame, two in the plane and three in space,
        all coordinates are numbers in the end."""
        for instance, frame in [(self.instance(planes(0.1)), ["e1", "e2", "e3"]), ("k33", ["p1", "p2"])]:
            for form in ["phc", "reduced"]:
                equations, positions = self.equations_and_positions(instance, form)
                for solution in self.solved(instance, "monodromy"):
                    known = leaves({kind: solution.get(kind, {}) for kind in positions})
                    values = {}
                    for text, number in zip(leaves(positions), known):
                        factor, name = re.fullmatch(r"(?:(.*)\*)?(\w+)|.*", text).groups()
                        if name and not name[0].isdigit():
                            values[name] = number / float(factor or 1)
                    for text, number in zip(leaves(positions), known):
                        self.assertAlmostEqual(eval(text, dict(values)), number, delta=1e-12)  # pylint: disable=eval-used
                    self.assert_hold([f"{equation} = 0" for equation in equations], values)
            for name in frame:
                for coordinate in positions["points"][name]:
                    float(coordinate)

    def test_equations_alone_are_asked_for(self):
        self.assert_usage_error(run("describe", "k33", "--equations", "latex"), "--equations")
        self.assert_usage_error(run("describe", "k33", "--equations", "text", "--json"), "--json")

    def test_where_there_are_none_it_says_why(self):
        """Certificates and equations know one line at most beside free points."""
        points, lines = "abcd", "LM"
        scene = {"format": "gcsbench-instance/1", "id": "two-lines", "dimension": 3, "points": list(points),
                 "lines": list(lines), "constraints": distances(*((*pair, 1) for pair in combinations(points, 2)),
                                                                *((p, line, 0.6) for p in points for line in lines))}
        self.assert_one_message(run("describe", self.instance(scene), "--equations", "phc"), NOT_SOLVED, "one line at most")


if __name__ == "__main__":
    command_line.main()
