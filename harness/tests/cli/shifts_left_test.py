#!/usr/bin/python3
"""Scenes whose fixed elements leave a shift or a turn alone, or are partly in a body, against counts by geometry and the
same scenes with all held.

Usage: shifts_left_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import command_line
from general_scenes import HELD, distances
from partly_fixed import PartlyFixedScenes, combined, cross, distance_of, dot, measured, renumbered, unit

# At right angles, and of one length.
ALONG, SIDE = [1, 2, 2], [2, -2, 1]


class ShiftsLeft(PartlyFixedScenes):
    def assert_known(self, places, fixed, count, joined, *, held, times, angles=(), on=()):
        """As many solutions up to the motions that are left, in any order and unit, and so many times as many where a
        further element that is fixed, and held at that distance, leaves no motion."""
        dimension = len(next(place for place in places.values() if isinstance(place, list)))
        scene = measured(dimension, places, joined, angles, on)
        given = {name: places[name] for name in fixed}
        self.assert_solved(scene, given, count)
        again, moved = renumbered(scene, given)
        result = self.result(again | {"fixed": moved})
        self.assertEqual(result["counts"]["complex"], count)
        found = self.result(again | {"fixed": moved}, "newton-multistart")["solutions"]
        self.assertEqual(len(found), result["counts"]["real"])
        name, place, what = held
        anchored = measured(dimension, places | {name: place}, [*joined, (what, name)], angles, on)
        self.assertEqual(self.certified(anchored | {"fixed": given | {name: place}})["counts"]["complex"],
                         times * count)

    def line_along(self, factor=1):
        return {"point": self.position(), "direction": [factor * x for x in ALONG]}

    def test_lines_that_leave_a_shift(self):
        """A point at distances from two lines is on one of two parallels to them, and one at a distance from such a point on
        two places of its own: 2 · 2 · 2, of which a half-turn that leaves two lines makes four. With a third line, or in the
        plane with two, there is none. A line at an angle to two parallels touches two circles, and eight such pairs are
        four by that half-turn."""
        places = {"K": self.line_along(), "L": self.line_along(-2), "M": self.line_along(0.5), "p": self.position(),
                  "q": self.position()}
        across = {"normal": ALONG, "offset": 0.7}
        two = {name: places[name] for name in "KLpq"}
        self.assert_known(two, "KL", 4, ["pK", "pL", "qK", "qL", "pq"], held=("F", across, "p"), times=2)
        self.assert_known(places, "KLM", 8, ["pK", "pL", "qL", "qM", "pq"], held=("F", across, "q"), times=1)
        flat = {"K": {"point": [0.3, 0.2], "direction": [3, 1]}, "L": {"point": [-0.4, 2.1], "direction": [-6, -2]},
                "p": [1.1, 1.6], "q": [-0.4, 0.5]}
        beside = {"point": [3, 0], "direction": [-1, 3]}
        self.assert_known(flat, "KL", 8, ["pK", "qL", "pq"], held=("F", beside, "p"), times=2)

    def test_planes_that_leave_a_shift(self):
        """Points are on parallels to the line in which two planes meet, one each; a plane that leans against both has two
        ways to lean. A plane and a line along it leave a shift and a half-turn."""
        places = {"A": {"normal": [2, -1, 2], "offset": 0.4}, "B": {"normal": [1, 3, -1], "offset": -0.3},
                  "p": self.position(), "q": self.position(), "r": self.position(), "C": self.plane()}
        across = {"normal": cross(places["A"]["normal"], places["B"]["normal"]), "offset": 0.5}
        three = {name: places[name] for name in "ABpqr"}
        self.assert_known(three, "AB", 4, ["pA", "pB", "qA", "qB", "pq", "rA", "rp", "rq"], held=("F", across, "q"),
                          times=1)
        leaning = {name: places[name] for name in "ABCp"}
        self.assert_known(leaning, "AB", 2, ["pA", "pB", "pC"], angles=["CA", "CB"], held=("F", across, "p"), times=1)
        rail = {"A": {"normal": SIDE, "offset": 0.8}, "K": self.line_along(), "p": places["p"], "q": places["q"]}
        self.assert_known(rail, "KA", 4, ["pA", "pK", "qA", "qK", "pq"], times=2,
                          held=("F", {"normal": ALONG, "offset": -0.2}, "q"))

    def test_a_line_and_planes_across_it(self):
        """They leave a turn alone: of two points at distances from all of them, one may be on either hand of the other."""
        places = {"K": self.line_along(3), "A": {"normal": ALONG, "offset": 0.4},
                  "B": {"normal": [-x for x in ALONG], "offset": 0.9}, "p": self.position(), "q": self.position()}
        beside = {"normal": SIDE, "offset": dot(SIDE, places["K"]["point"])}
        for planes in ["A", "AB"]:
            scene = {name: place for name, place in places.items() if name in "Kpq" + planes}
            self.assert_known(scene, "K" + planes, 2, ["pA", "pK", "q" + planes[-1], "qK", "pq"],
                              held=("F", beside, "p"), times=2)

    def test_lines_and_planes_that_use_up_a_motion(self):
        """A plane leans against two others in two ways. A line at distances from two parallels, at an angle to them: eight,
        four up to a half-turn. One at a distance from an axis, and from a point of that, passes on either hand, before or
        behind."""
        places = {"K": self.line_along(), "L": self.line_along(-1), "N": self.line()}
        scene = measured(3, places, ["KN", "LN"], angles=["KN"])
        self.assert_solved(scene, {name: places[name] for name in "KL"}, 4)
        leaning = {"A": self.plane(), "B": self.plane(), "C": self.plane()}
        scene = measured(3, leaning, [], angles=["CA", "CB"])
        self.assert_solved(scene, {name: leaning[name] for name in "AB"}, 2)
        axis = {"K": self.line_along(), "A": {"normal": ALONG, "offset": 0.4}, "N": self.line()}
        axis["p"] = combined(1, axis["K"]["point"], 0.2, ALONG)
        scene = measured(3, axis, ["pA", "pN", "KN"], angles=["KN"], on=["pK"])
        self.assert_solved(scene, {name: axis[name] for name in "KA"}, 4)

    def test_partly_in_a_body(self):
        """A body of which one point is given, and beside it another one: as without positions, the distance of the two given
        instead."""
        base = HELD["bodies"]["base"]
        c, q = [2.1, -0.8, 0.9], [1.2, 1.9, 1.4]
        scene = HELD | {"id": "partly", "points": ["q", "c"], "bodies": {"base": base},
                        "constraints": distances(*((a, b, distance_of(x, y)) for a, b, x, y in [
                            ("c", "a2", c, base["a2"]), ("c", "a3", c, base["a3"]), ("q", "c", q, c),
                            ("q", "a2", q, base["a2"]), ("q", "a3", q, base["a3"])]))}
        free = scene | {"constraints": scene["constraints"] + distances(("c", "a1", distance_of(c, base["a1"])))}
        start = self.position()
        fixed = {"a1": start, "c": combined(1, start, distance_of(c, base["a1"]) / 3, [2, -2, 1])}
        known = self.certified(free)
        self.assertEqual(known["counts"]["complex"], 4)
        result = self.assert_solved(scene, fixed, 4)
        for one, other in zip(self.apart(known, "q", "c"), self.apart(result, "q", "c"), strict=True):
            self.assertAlmostEqual(one, other, delta=1e-9)

    def test_parallels_of_a_body(self):
        """Two lines, or three, of one body, whichever way a file has them: four points on a sphere, a cylinder and a plane
        that are the body's (Bézout), wherever it is given."""
        body = {"a1": [0, 0, 0], "a2": [1.7, 0.1, 0.2], "a3": [0.4, 1.5, -0.3],
                "K": {"point": [0.3, 0.2, 1.1], "direction": ALONG},
                "L": {"point": [-0.5, 0.9, 0.4], "direction": [-x for x in ALONG]},
                "M": {"point": [1.2, -0.6, 0.3], "direction": ALONG}, "E": {"normal": SIDE, "offset": 0.6}}
        q = [1.2, 0.9, 0.4]
        beside = {"format": "gcsbench-instance/2", "id": "parallels", "dimension": 3, "points": ["q"],
                  "bodies": {"base": body},
                  "constraints": distances(*(("q", name, distance_of(q, body[name])) for name in ["a1", "K", "E"]))}
        free = self.certified(beside)
        # x ↦ T x + s with the rotation T by a half-turn about ALONG − SIDE, which exchanges these.
        axis = unit(combined(1, ALONG, 1, SIDE))

        def moved(point):
            return combined(1, turned(point), 1, [0.3, -1.1, 0.7])

        def turned(vector):
            return combined(2 * dot(axis, vector), axis, -1, vector)

        lines = {name: {"point": moved(body[name]["point"]), "direction": [f * x for x in turned(ALONG)]}
                 for name, f in [("K", -2), ("L", -1), ("M", 0.5)]}
        plane = {"E": {"normal": turned(SIDE), "offset": dot(turned(SIDE), moved([0.6 / 9 * x for x in SIDE]))}}
        for fixed in [{name: lines[name] for name in "KL"}, lines, {"K": lines["K"]} | plane, lines | plane]:
            result = self.assert_solved(beside, fixed, 4)
            for known, found in zip(self.apart(free, "a2", "q"), self.apart(result, "a2", "q"), strict=True):
                self.assertAlmostEqual(known, found, delta=1e-9)


if __name__ == "__main__":
    command_line.main()
