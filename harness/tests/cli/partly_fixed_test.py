#!/usr/bin/python3
"""Scenes whose fixed elements leave motions, against the same scenes with nothing fixed, counted up to motion.

Usage: partly_fixed_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import math

import command_line
from command_line import BAD_INPUT, DONE, SOURCE, run
from general_scenes import HELD, PLATFORM, distances
from partly_fixed import PartlyFixedScenes, combined


def shipped(name):
    scene = json.loads((SOURCE / "instances" / f"{name}.json").read_text())
    constraints = [{key: value for key, value in c.items() if key != "id"} for c in scene["constraints"]]
    return {"format": "gcsbench-instance/2", "constraints": constraints} | {
        key: scene[key] for key in ["id", "dimension", "points", "planes", "bodies"] if key in scene}


def without(scene, a, b):
    return scene | {"constraints": [c for c in scene["constraints"] if c.get("between") != [a, b]]}


def length(scene, a, b):
    return next(c["length"] for c in scene["constraints"] if c.get("between") == [a, b])


# Lines at given distances from four points, 12 (Macdonald, Pach, Theobald 2001), beside a tetrahedron and its mirror
# image.
SIDES = distances(("p", "q", 2.1), ("p", "r", 2.3), ("p", "s", 1.9), ("q", "r", 2.2), ("q", "s", 2.4), ("r", "s", 2.0))
TANGENT = {"format": "gcsbench-instance/2", "id": "tangent", "dimension": 3, "points": ["p", "q", "r", "s"],
           "lines": ["L"],
           "constraints": SIDES + distances(("p", "L", 1.1), ("q", "L", 1.15), ("r", "L", 1.12), ("s", "L", 1.1))}
# Lines through a point at given distances from two others: two on each of the four pairs of half cones, which are
# opposite to each other by twos.
THROUGH = TANGENT | {"id": "through", "constraints": SIDES + distances(("q", "L", 1.3), ("r", "L", 1.2))}
# The four tangents of two circles, beside a triangle and its mirror image.
FLAT = {"format": "gcsbench-instance/2", "id": "flat", "dimension": 2, "points": ["p", "q", "r"], "lines": ["L"],
        "constraints": distances(("p", "q", 2.1), ("p", "r", 2.3), ("q", "r", 1.9), ("p", "L", 0.4), ("q", "L", 0.7))}


class PartlyFixed(PartlyFixedScenes):
    def assert_twice(self, result, free, a, b):
        """A solution and its mirror image in place of one class of the scene without positions."""
        once, found = self.apart(free, a, b), self.apart(result, a, b)
        self.assertEqual(len(found), 2 * len(once))
        for twice, one in zip(found, sorted(2 * once)):
            self.assertAlmostEqual(twice, one, delta=1e-9)

    def test_a_point_of_an_octahedron(self):
        """16 in a fixed frame (Hoffmann and Yuan), wherever the point is; far from the origin, too."""
        scene, free = shipped("octahedron"), self.result(shipped("octahedron"))
        for name, size in [("p3", 3), ("p6", 1000)]:
            place = [round(x, 3) for x in self.position(size)]
            result = self.result(scene | {"fixed": {name: place}}, "polyhedral")
            self.assertEqual(result["counts"]["complex"], 16)
            self.assert_twice(result, free, "p1", "p4")
        result = self.assert_solved(scene, {"p2": self.position()}, 16)
        self.assert_twice(result, free, "p1", "p4")
        self.assertEqual(result["proofs"]["limit"], 16)

    def test_two_points_of_an_octahedron(self):
        """In place of the distance between them; and a third on their line in place of two."""
        scene, start = shipped("octahedron"), self.position()
        free = self.result(scene)
        along = combined(length(scene, "p1", "p2") / 3, [2, -1, 2])
        fixed = {"p1": start, "p2": combined(1, start, 1, along)}
        result = self.assert_solved(without(scene, "p1", "p2"), fixed, 16)
        self.assert_twice(result, free, "p1", "p4")
        to_m = math.sqrt(0.6 * length(scene, "p1", "p3") ** 2 + 0.4 * length(scene, "p2", "p3") ** 2
                         - 0.24 * length(scene, "p1", "p2") ** 2)  # Stewart's theorem
        rail = without(without(scene, "p1", "p2"), "p1", "p3") | {"points": [*scene["points"], "m"]}
        rail["constraints"] += distances(("m", "p3", to_m))
        self.assert_solved(rail, fixed | {"m": combined(1, start, 0.4, along)}, 16, ["monodromy"])

    def test_planes_of_an_octahedron(self):
        """With four points and two planes 16 in a fixed frame likewise. The normals are not of length 1."""
        scene = shipped("octahedral-4p2h")
        free = self.result(scene)
        result = self.assert_solved(scene, {"e5": self.plane()}, 16)
        self.assert_twice(result, free, "e1", "e4")
        plane = {"normal": [2, -1, 2], "offset": 2.1}
        point = combined((0.7 + length(scene, "e1", "e5")) / 3, plane["normal"], 1, [0.3, 0.8, 0.1])
        result = self.assert_solved(without(scene, "e1", "e5"), {"e1": point, "e5": plane}, 16)
        self.assert_twice(result, free, "e1", "e4")

    def test_a_line_and_a_point(self):
        for fixed in [{"L": self.line()}, {"q": self.position()}]:
            self.assert_solved(TANGENT, fixed, 24, ["monodromy"])
        line = self.line()
        on_it = combined(1, line["point"], 0.7, line["direction"])
        self.assert_solved(THROUGH, {"p": on_it, "L": line}, 8)
        through = THROUGH | {"constraints": THROUGH["constraints"] + [{"type": "on", "between": ["p", "L"]}]}
        for fixed in [{"L": line}, {"s": on_it}, {"p": on_it}]:
            self.assert_solved(through, fixed, 8)

    def test_other_strategies(self):
        """Real solutions from starts, sketches and scans: those of homotopies; plans have frames of their own."""
        place = self.position()
        octahedron = shipped("octahedron") | {"fixed": {"p4": place}}
        sketch = json.loads((SOURCE / "instances" / "octahedron.json").read_text())["sketch"]
        sketched = octahedron | {"sketch": {p: combined(1, x, 1, combined(1, place, -1, sketch["p4"]))
                                            for p, x in sketch.items()} | {"p4": place}}
        planes = shipped("octahedral-4p2h") | {"fixed": {"e6": self.plane()}}
        flat = FLAT | {"fixed": {"L": self.line(dimension=2)}}
        for scene, strategies in [(sketched, ["newton-multistart", "plan-scan", "explore"]), (planes, ["plan-scan"]),
                                  (flat, ["newton-multistart", "plan-scan"])]:
            known = [s for s in self.certified(scene)["solutions"] if s["real"]]
            self.assertGreater(len(known), 0)
            for strategy in strategies:
                found = self.found_by(scene, strategy)
                self.assertEqual(len(found), len(known))
                for one in found:
                    self.assertLess(min(self.off(one, other) for other in known), 1e-9)
        for strategy in ["full-space", "rcp"]:
            known = [s for s in self.certified(sketched)["solutions"] if s["real"]]
            for one in self.found_by(sketched, strategy):
                self.assertLess(min(self.off(one, other) for other in known), 1e-9)

    def found_by(self, scene, strategy):
        solutions = self.result(scene, strategy)["solutions"]
        self.assertGreater(len(solutions), 0)
        for solution in solutions:
            self.assert_in_place(solution, scene["fixed"])
        return solutions

    def off(self, one, other):
        """How much distances between points differ."""
        here, there = one["points"], other["points"]
        return max(abs(math.dist(here[a], here[b]) - math.dist(there[a], there[b])) for a in here for b in here)

    def test_parts_and_references(self):
        """A point that hangs on three others has two places for each of the 16 figures; decimals as in the result."""
        scene = shipped("octahedron")
        scene |= {"points": [*scene["points"], "h"],
                  "constraints": scene["constraints"] + distances(("h", "p1", 1.5), ("h", "p2", 1.4), ("h", "p3", 1.6))}
        for fixed in ["p5", "h"]:
            result = self.assert_solved(scene, {fixed: self.position()}, 32, ["monodromy"])
            done = run("--quiet", "reference", self.folder / "result.json", "--out", "-")
            self.assertEqual((done.returncode, done.stderr), (DONE, ""))
            for exact, found in zip(json.loads(done.stdout)["solutions"], result["solutions"], strict=True):
                self.assertEqual(exact["real"], found["real"])
                for point, place in found["points"].items() if found["real"] else []:
                    self.assertLess(math.dist([float(x) for x in exact["points"][point]], place), 1e-9)

    def test_lines_and_planes_without_points(self):
        """Planes at given angles are three unit vectors with their products, or their mirror image; a line passes another
        one on either hand; a line across a plane is its own mirror image."""
        turned = {"format": "gcsbench-instance/2", "id": "turned", "dimension": 3, "points": []}

        def angle(a, b, degrees):
            return {"type": "angle", "between": [a, b], "degrees": degrees}

        three = turned | {"planes": ["A", "B", "C"],
                          "constraints": [angle("A", "B", 70), angle("A", "C", 65), angle("B", "C", 80)]}
        lines = turned | {"lines": ["K", "L"], "constraints": [angle("K", "L", 40), *distances(("K", "L", 0.7))]}
        across = turned | {"lines": ["K"], "planes": ["A"], "constraints": [angle("K", "A", 40)]}
        for scene, fixed, count in [(three, {"B": self.plane()}, 2), (lines, {"L": self.line()}, 2),
                                    (across, {"A": self.plane()}, 1), (across, {"K": self.line()}, 1)]:
            self.assert_solved(scene, fixed, count, ["monodromy"])

    def test_a_plane_across_a_line(self):
        """Its normal is the line's direction, whichever of the two is fixed; mirror images are two."""
        scene = {"format": "gcsbench-instance/2", "id": "across", "dimension": 3, "points": ["p", "q", "r"],
                 "lines": ["K"], "planes": ["A"], "constraints": [
                     {"type": "perpendicular", "between": ["K", "A"]},
                     *distances(("p", "A", 0.5), ("p", "K", 1), ("q", "A", 0.2), ("q", "K", 1.1), ("p", "q", 1.3),
                                ("r", "p", 1), ("r", "q", 1.2), ("r", "K", 0.8))]}
        free = self.certified(scene)
        for fixed in [{"K": self.line()}, {"A": self.plane()}, {"r": self.position()}]:
            result = self.assert_solved(scene, fixed, 2 * free["counts"]["complex"], ["monodromy"])
            self.assertEqual(result["counts"]["real"], 2 * free["counts"]["real"])

    def test_in_the_plane(self):
        for fixed in [{"p": self.position(dimension=2)}, {"r": self.position(dimension=2)},
                      {"L": self.line(dimension=2)}]:
            self.assert_solved(FLAT, fixed, 8)

    def test_elements_of_a_body(self):
        """Six postures of the planar platform (Hunt 1983), 40 of the one in space; four points on a sphere, a circular
        cylinder and a plane (Bézout) that are the body's."""
        self.assertEqual(self.assert_solved(PLATFORM, {"a2": [1.5, -0.25]}, 6)["frame"]["body"], "base")
        self.assert_solved(PLATFORM, {"b1": self.position(dimension=2)}, 6, ["monodromy"])
        platform = shipped("platform")
        name, points = next(iter(platform["bodies"].items()))
        first, second = sorted(points)[:2]
        shift = self.position()
        moved = {one: combined(1, points[one], 1, shift) for one in [first, second]}
        self.assertEqual(self.assert_solved(platform, moved, 40, ["polyhedral"])["frame"]["body"], name)
        base = HELD["bodies"]["base"]
        beside = HELD | {"id": "beside", "points": ["q"], "bodies": {"base": base},
                         "constraints": distances(("q", "a1", 2), ("q", "K", 1.2), ("q", "E", 0.5))}
        free = self.certified(beside)
        self.assertGreater(free["counts"]["real"], 0)
        for fixed in [{"a2": self.position()}, {"K": self.line()}, {"E": self.plane()},
                      {one: combined(1, base[one], 1, shift) for one in ["a1", "a3"]}]:
            result = self.assert_solved(beside, fixed, 4)
            for known, found in zip(self.apart(free, "a2", "q"), self.apart(result, "a2", "q"), strict=True):
                self.assertAlmostEqual(known, found, delta=1e-9)

    def assert_refused(self, scene, fixed, *words):
        done = run("describe", self.write(scene | {"fixed": fixed}, f"{scene['id']}.json"))
        self.assertEqual(done.returncode, BAD_INPUT, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_refusals(self):
        scene = shipped("octahedron")
        place = self.position()
        self.assert_refused(without(scene, "p5", "p6"), {"p1": place}, "under-constrained", "1 degree of freedom")
        more = scene | {"constraints": scene["constraints"] + distances(("p1", "p4", 2))}
        self.assert_refused(more, {"p1": place}, "over-constrained")
        self.assert_refused(scene, {"p1": place, "p4": place}, "the same place")
        self.assert_refused(PLATFORM | {"points": ["c"]}, {"c": [1, 2]}, "too few elements that are in no body")
        self.assert_refused(HELD | {"points": ["c"]}, {"c": place, "a1": place[::-1]}, "too few elements")


if __name__ == "__main__":
    command_line.main()
