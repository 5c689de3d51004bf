#!/usr/bin/python3
"""`gcsbench solve --certificate` and scripts/check-certificate beyond distances: incidences, angles, given lines and planes,
and bodies.

Usage: certificate_scenes_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import itertools
import json
import re

import command_line
from certificates import CertificateTest, at, checker, verdict, with_value
from command_line import CHECK_FAILED, DONE, SOURCE
from general_scenes import distances, osculating


def angle(a, b, degrees):
    return {"type": "angle", "between": [a, b], "degrees": degrees}


def stated(kind, *between):
    return {"type": kind, "between": list(between)}


def orientation(sign, points):
    return {"type": "orientation", "of": points, "sign": sign}


def scene(name, constraints, dimension=3, **elements):
    return {"format": "gcsbench-instance/2", "id": name, "dimension": dimension, **elements, "constraints": constraints}


def on_triangle(name, *constraints, points=(), **elements):
    return scene(name, [*distances(("p", "q", 3), ("q", "r", 2.5), ("r", "p", 2)), *constraints],
                 points=["p", "q", "r", *points], **elements)


# A plane by distances of three points, or of two and an angle, has two places, as n·n = 1 is all that is not linear.
E_ON_P = [stated("on", "p", "E"), *distances(("q", "E", 1.1), ("r", "E", -0.4))]
# A line through p at distances from q and r: on two cones, four.
K_ON_P = [stated("on", "p", "K"), *distances(("q", "K", 1.2), ("K", "r", 0.8))]
BASE = {"a1": [0, 0, 0], "a2": [1.7, 0.1, 0.2], "a3": [0.4, 1.5, -0.3]}
SIX = {**BASE, "a4": [1.2, -0.8, 0.1], "a5": [-0.4, 0.6, 0.5], "a6": [0.9, 0.7, -0.2]}
ARM = {"b1": [0.3, 0.7, 0.2], "b2": [0.2, -0.5, 0.6], "b3": [0.5, 1.1, 0.4]}

# With the number of complex solutions, by products, of which a mirror image halves all but those in a given frame.
COUNTED = [
    # 2 · 2 / 2
    (on_triangle("planes", *E_ON_P, *distances(("p", "F", 0.3), ("q", "F", -0.7)), angle("F", "E", 70), planes=["E", "F"]),
     2, " up to reflection"),
    # 4 · 4 / 2, the second line on two cones, too
    (on_triangle("lines", *K_ON_P, stated("on", "q", "L"), angle("K", "L", 50), *distances(("L", "r", 0.9)),
                 lines=["K", "L"]), 8, " up to reflection"),
    # 4 · 2 / 2, the second line in a plane with the first, as far from r
    (on_triangle("meeting", *K_ON_P, stated("on", "q", "L"), stated("meet", "L", "K"), *distances(("r", "L", 1.3)),
                 lines=["K", "L"]), 4, " up to reflection"),
    # 2 for E; 2 for L, where circles meet; 2 for F; 1 for G; 1 for N; 4 for M, a tangent of circles; / 2
    (on_triangle("at right angles", *E_ON_P, stated("perpendicular", "L", "E"), *distances(("p", "L", 1.4), ("L", "q", 1.9)),
                 stated("on", "r", "F"), stated("perpendicular", "F", "E"), *distances(("p", "F", 0.9)),
                 stated("parallel", "G", "E"), *distances(("E", "G", 0.5)), stated("parallel", "N", "L"),
                 stated("on", "r", "N"), stated("on", "M", "E"), *distances(("p", "M", 0.7), ("q", "M", 1.6)),
                 planes=["E", "F", "G"], lines=["L", "M", "N"]), 16, " up to reflection"),
    # 2 for E; 4 for O, on two cones; / 2
    (on_triangle("inclined", *E_ON_P, stated("on", "p", "O"), angle("E", "O", 40), *distances(("q", "O", 2.2)), planes=["E"],
                 lines=["O"]), 4, " up to reflection"),
    # 4 for K; 2 for L, where circles meet; / 2
    (on_triangle("parallel", *K_ON_P, stated("parallel", "K", "L"), *distances(("K", "L", 0.6), ("q", "L", 1.5)),
                 lines=["K", "L"]), 4, " up to reflection"),
    # 4 for K; 1 for M; 4 for L, where a circle meets lines on both sides of M; / 2
    (on_triangle("across", *K_ON_P, stated("on", "q", "M"), stated("on", "r", "M"), stated("parallel", "K", "L"),
                 *distances(("M", "L", 0.4), ("p", "L", 1.1)), lines=["K", "L", "M"]), 8, " up to reflection"),
    # Two points of a line through p and q, no mirror images: all is in a plane.
    (on_triangle("in a plane", stated("on", "p", "K"), stated("on", "q", "K"), stated("on", "t", "K"), *distances(("t", "r", 1.8)),
                 points=["t"], lines=["K"]), 2, " up to reflection"),
    # Three legs about a ball: quadrics of quaternions, which meet in 8 points of P³.
    (scene("three legs", distances(("a1", "b1", 1.1), ("a2", "b2", 1.7), ("a3", "b3", 1.3)), points=[],
           bodies={"base": {**BASE, "j": [1, 1, 1]}, "arm": {**ARM, "j": [0.2, -0.3, 0.1]}}), 8, " up to motion"),
    # A point on a circle and a sphere; a second body on the first one's hinge, in the same way: 2 · 2
    (scene("hinges", distances(("a3", "b3", 1.7), ("a1", "c3", 1.4)), points=[],
           bodies={"base": BASE, "arm": {"b3": [0.5, 1.1, 0.4], "a1": [0, 0, 0], "a2": [1.714642819948225, 0, 0]},
                   "hand": {"b3": [0, 0, 0], "a2": [1.686818656540108, 0, 0], "c3": [0.6, 0.9, 0.1]}}), 4, " up to motion"),
    # The same of points in the plane.
    (scene("arms", distances(("a2", "b2", 1.7), ("a2", "c2", 1.4)), 2, points=[],
           bodies={"base": {"a1": [0, 0], "a2": [1.7, 0.2]}, "arm": {"a1": [0, 0], "b1": [0.9, 0.4], "b2": [1.1, -0.7]},
                   "hand": {"b1": [0.1, 0.2], "c2": [-0.8, 0.5]}}), 4, " up to (motion|reflection)"),
    # t on a sphere, a plane and a cylinder: 4; w on a plane, a cylinder and a sphere: 4; F: 2
    (scene("given", [*distances(("t", "K", 1.3), ("E", "t", 0.4), ("t", "g", 1.9), ("K", "w", 0.8), ("w", "t", 1.1),
                                ("t", "F", 0.2)), stated("on", "w", "E"), stated("on", "w", "F"), angle("E", "F", 65)],
           points=["t", "w", "g"], lines=["K"], planes=["E", "F"],
           fixed={"K": {"point": [0.3, -1.2, 0.4], "direction": [1, 0.3, -0.2]},
                  "E": {"normal": [0.2, -0.1, 1], "offset": -0.6}, "g": [0.5, 0.25, 1.5]}), 32, ""),
    # 2 for E, which is parallel to both lines; 4 for K, on either side of each
    (scene("upright", [stated("parallel", "g", "E"), stated("parallel", "h", "E"), *distances(("p", "E", 0.5)),
                       stated("perpendicular", "K", "E"), *distances(("K", "g", 0.7), ("K", "h", 0.9))],
           points=["p"], lines=["K", "g", "h"], planes=["E"],
           fixed={"p": [0.4, 0.1, 0.3], "g": {"point": [0, 0, 0], "direction": [1, 0.2, 0.3]},
                  "h": {"point": [0.2, 0, 1], "direction": [-0.1, 1, 0.4]}}), 8, ""),
    # 2 for K, L and M each, 4 for N, 4 for t; / 2
    (scene("flat", [*distances(("p", "q", 2), ("q", "K", 0.9), ("p", "L", 0.4), ("q", "M", 0.7), ("p", "N", 0.5), ("t", "N", 0.8),
                               ("M", "t", 0.3)), stated("on", "p", "K"), stated("parallel", "L", "K"),
                    stated("perpendicular", "M", "K"), angle("K", "N", 35)],
           2, points=["p", "q", "t"], lines=["K", "L", "M", "N"]), 64, " up to reflection"),
    # 2 for E; L parallel to E on either side, 4 tangents of circles; / 2
    (on_triangle("beside", *E_ON_P, stated("parallel", "L", "E"), *distances(("L", "E", 0.5), ("p", "L", 0.9), ("q", "L", 1.8)),
                 planes=["E"], lines=["L"]), 8, " up to reflection"),
    # A body on a ball: b3 on a circle and a sphere, then b2, too. 2 · 2
    (scene("ball", distances(("a1", "b2", 1.5), ("a2", "b3", 1.1), ("a3", "b3", 1.3)), points=[],
           bodies={"base": {**BASE, "j": [1, 1, 1]}, "arm": {**ARM, "j": [0.2, -0.3, 0.1]}}), 4, " up to motion"),
    # A body on a cylinder: conics with s² − s'² in t and the angle, 4, for either direction of the line.
    (scene("cylinder", distances(("a3", "b3", 1.9), ("a2", "b1", 1.7)), points=[],
           bodies={"base": {**BASE, "K": {"point": [0.3, 0.2, 1.1], "direction": [1, 0.3, 0.2]}},
                   "arm": {**ARM, "K": {"point": [0, 0, 0], "direction": [1, 0, 0]}}}), 8, " up to motion"),
    # A body that slides on a plane, as in the plane (Hunt 1983).
    (scene("table", distances(("a1", "b1", 1.9), ("a2", "b2", 1.6), ("a3", "b3", 1.8)), points=[],
           bodies={"base": {**BASE, "E": {"normal": [0.1, -0.2, 1], "offset": 0.3}},
                   "arm": {**ARM, "E": {"normal": [1, 0.2, -0.3], "offset": 0.1}}}), 6, " up to motion"),
    # A body in the plane that slides on a line, in either direction: 2 · 2
    (scene("slide", distances(("a1", "b1", 1.9)), 2, points=[],
           bodies={"base": {"a1": [0, 0], "a2": [1.7, 0.2], "K": {"point": [0.3, 0.2], "direction": [1, 0.3]}},
                   "arm": {"b1": [0.3, 0.7], "b2": [0.2, -0.5], "K": {"point": [0, 0], "direction": [1, 0]}}}), 4, " up to motion"),
    # Legs of a platform that end in three points of one body, as three and two and one: 2 · 2 · 2, or as pairs: 2 · 2 · 2 for
    # either way round the triangle.
    *((scene(name, distances(*(ends[::turn] + (length,) for ends, length in zip(zip(SIX, corners), (1.2, 1.5, 1.4, 1.7, 1.1, 1.6)))),
             points=[], bodies=dict([("base", SIX), ("arm", ARM)][::turn])), count, " up to motion")
      for name, corners, turn, count in (("tripod", ("b1", "b1", "b1", "b2", "b2", "b3"), 1, 8),
                                         ("hung tripod", ("b1", "b1", "b1", "b2", "b2", "b3"), -1, 8),
                                         ("pairs", ("b1", "b1", "b2", "b2", "b3", "b3"), 1, 16))),
    # A point of a body in planes: three corners, each on two of them or on spheres.
    (scene("wedge", [*distances(("E", "b1", 0.4), ("F", "b1", 0.7), ("a1", "b1", 1.3), ("E", "b2", 0.9), ("a2", "b2", 1.2),
                                ("F", "b3", 0.2))], points=[],
           bodies={"base": {**BASE, "E": {"normal": [0.1, -0.2, 1], "offset": 0.3}, "F": {"normal": [1, 0.3, 0.2], "offset": -0.2}},
                   "arm": ARM}), 8, " up to motion")]

NAMED = {given["id"]: given for given, *_ in COUNTED}

# Where no bound is known: c where spheres about t and b meet the line; w where circles in the plane meet.
CARRIED = on_triangle("carried", *distances(("p", "t", 2.1), ("q", "t", 1.9), ("r", "t", 1.7)), stated("collinear", "p", "t", "c"),
                      *distances(("c", "q", 1.8)), stated("coplanar", "p", "q", "t", "w"),
                      *distances(("w", "p", 1.2), ("w", "q", 2.3)), points=["t", "c", "w"])

# General platforms (Raghavan 1993), one with real solutions only (Dietmaier 1998), one in the plane (Hunt 1983).
PLATFORMS = {"platform": 40, "dietmaier": 40, "planar-platform": 6}

# t on two cones about p and q, whose equations know no difference of an angle and its supplement, and a sphere; w on the
# normal of E through q.
SEGMENTS = on_triangle("segments", *E_ON_P, *distances(("p", "t", 1.8), ("w", "q", 0.9)), angle(["p", "t"], ["p", "q"], 50),
                       angle(["q", "t"], ["q", "r"], 65), stated("perpendicular", ["q", "w"], "E"), points=["t", "w"],
                       planes=["E"])


def scaled(given, exponent):
    """In units of 10^−exponent, and in the reverse order."""
    def length(number):
        return float(f"{number}e{exponent}")

    def place(at):
        if isinstance(at, list):
            return [length(number) for number in at]
        return {key: length(value) if key == "offset" else place(value) if key == "point" else value for key, value in at.items()}

    constraints = [{key: length(value) if key == "length" else value for key, value in constraint.items()}
                   for constraint in given["constraints"][::-1]]
    elements = {key: given[key][::-1] for key in ("points", "lines", "planes") if key in given}
    places = {"fixed": {name: place(at) for name, at in given["fixed"].items()}} if "fixed" in given else {}
    if "bodies" in given:
        places["bodies"] = {body: {name: place(at) for name, at in held.items()} for body, held in given["bodies"].items()}
    return {**given, **elements, **places, "constraints": constraints}


class CertifiedScenes(CertificateTest):
    def proven(self, given):
        return verdict(self.certificate(self.write(given, f"{given['id']}.json")))

    def test_complete_lists(self):
        for given, count, counted in COUNTED:
            with self.subTest(scene=given["id"]):
                self.assertRegex(self.proven(given), f"^{given['id']}: exactly {count} (isolated )?complex solutions{counted}, "
                                                     r"[0-9]+ of them real: proven\.$")

    def test_platforms(self):
        for name, count in PLATFORMS.items():
            self.assertRegex(verdict(self.certificate(name)),
                             f"^{name}: exactly {count} isolated complex solutions up to motion, [0-9]+ of them real: proven")
        self.assertIn("40 of them real", verdict(self.certificate("dietmaier")))

    def test_three_points_and_three_lines(self):
        certificate = self.certificate("three-points-three-lines-angles")
        self.assertEqual(verdict(certificate), "three-points-three-lines-angles: exactly 960 complex solutions up to reflection, "
                                               "78 of them real: proven.")
        self.assertIsNone(verdict(with_value(certificate, ["limit", 0, "at_most"], 1918)))

    def test_a_list_without_a_bound(self):
        self.assertRegex(self.proven(CARRIED), "^carried: at least 4 complex solutions up to reflection, ")

    def test_units_and_orders_change_nothing(self):
        for name, exponent in (("planes", -150), ("parallel", 150), ("given", -150), ("three legs", -150), ("hinges", 150),
                               ("ball", 150), ("cylinder", -150), ("beside", 150), ("wedge", -150)):
            with self.subTest(scene=name, exponent=exponent):
                given = NAMED[name]
                other = {**scaled(given, exponent), "id": f"{given['id']} in others"}
                self.assertEqual(self.proven(other), self.proven(given).replace(given["id"], other["id"], 1))

    def test_segments_are_real_as_stated_or_not(self):
        """Each real figure is as stated by one choice of the angles and their supplements."""
        certificate = self.certificate(self.write(SEGMENTS, "segments.json"))
        places = [["instance", "constraints", number, "degrees"] for number, constraint in enumerate(SEGMENTS["constraints"])
                  if "degrees" in constraint]
        found = []
        for turned in itertools.product((False, True), repeat=len(places)):
            other = certificate
            for place, turn in zip(places, turned):
                other = with_value(other, place, 180 - at(certificate, place)) if turn else other
            numbers = re.search(r"at least 8 complex .*, ([0-9]+) of them real, ([0-9]+) of these as stated: ", verdict(other))
            found.append(tuple(map(int, numbers.groups())))
        self.assertEqual({real for real, _ in found}, {sum(as_stated for _, as_stated in found)})

    def test_orientations_tell_mirror_images_apart(self):
        """Of two that are each other's image one is as stated; more orientations share them. Classes up to reflection and real
        ones among them as in certificate_test.py."""
        for name, classes, real in (("k33", 8, 2), ("prism", 12, 12), ("octahedron", 8, 4)):
            plain = json.loads((SOURCE / "instances" / f"{name}.json").read_text())
            corners = plain["dimension"] + 1
            given = {**plain, "format": "gcsbench-instance/2", "constraints": [
                *plain["constraints"], orientation(1, plain["points"][:corners]), orientation(-1, plain["points"][-corners:])]}
            certificate = self.certificate(self.write(given, f"{name}.json"))
            as_stated = {}
            for signs in itertools.product((1, -1), repeat=2):
                other = with_value(certificate, ["instance", "constraints", -2, "sign"], signs[0])
                other = with_value(other, ["instance", "constraints", -1, "sign"], signs[1])
                sentence = (f"{name}: exactly {2 * classes} complex solutions up to motion, {2 * real} of them real, "
                            r"([0-9]+) of these as stated: proven\.")
                as_stated[signs] = int(re.fullmatch(sentence, verdict(other))[1])
            self.assertEqual(as_stated[1, 1] + as_stated[1, -1], real)
            self.assertEqual(as_stated, {(a, b): as_stated[-a, -b] for a, b in as_stated})
            self.assert_changes_are_harmless(name, certificate, but=", [0-9]+ of these as stated")

    def test_half_turns_are_motions(self):
        """A listed solution cannot stand for another one once more, turned about an axis of the frame; its mirror image can."""
        plain = json.loads((SOURCE / "instances" / "octahedron.json").read_text())
        given = {**plain, "format": "gcsbench-instance/2",
                 "constraints": [*plain["constraints"], orientation(1, plain["points"][:4])]}
        certificate = self.certificate(self.write(given, "octahedron.json"))
        number = next(k for k, solution in enumerate(certificate["solutions"]) if solution["real"])
        del certificate["solutions"][number + 1:], certificate["solutions"][:number]
        certificate.update(complex=2, real=2)
        for signs, are_two in (((1, -1, -1), False), ((-1, -1, 1), False), ((1, 1, -1), True), ((-1, -1, -1), True)):
            solution = certificate["solutions"][0]
            turned = [str(signs[place % 3] * int(value)) for place, value in enumerate(solution["numbers"])]
            both = {**certificate, "solutions": [solution, {**solution, "numbers": turned}]}
            self.assertEqual(verdict(both) is not None, are_two, signs)

    def test_orientations_beside_bodies(self):
        """No figure is another one for an orientation there. In the plane each real one has one of the two."""
        given = {**NAMED["slide"], "constraints": [*NAMED["slide"]["constraints"], orientation(1, ["a1", "b1", "b2"])]}
        certificate = self.certificate(self.write(given, "slide.json"))
        found = [re.fullmatch(r"slide: exactly 4 isolated complex solutions up to motion, ([0-9]) of them real, ([0-9]) of these as "
                              r"stated: proven\.", verdict(with_value(certificate, ["instance", "constraints", -1, "sign"], sign)))
                 for sign in (1, -1)]
        self.assertEqual(int(found[0][1]), sum(int(one[2]) for one in found))

    def test_touching_is_a_distance_of_0(self):
        """With that of a line from four points it has as many places as with others (Macdonald, Pach, Theobald 2001)."""
        tangents = json.loads((SOURCE / "instances" / "tangents-durand.json").read_text())
        tangents["constraints"][0]["length"] = 0
        self.assertEqual(self.proven({**tangents, "id": "touching"}), "touching: exactly 12 complex solutions, 0 of them real: proven.")

    def test_clusters(self):
        """Four spheres of one radius at the corners of a regular tetrahedron touch three lines, each of multiplicity four, where
        it is half of an edge over √2 (Macdonald, Pach, Theobald 2001). Circles that touch meet twice in a point, several pairs of
        them 2^k times; a coupler point meets a circle three times where that has its path's curvature, four times where this is stationary
        (`osculating`). With roots for coordinates it is not shown that these are one solution."""
        def circles(*points):
            edges = [edge for k, c in enumerate(points) for edge in (("a", c, 2 + k / 2), ("b", c, 3 - k / 2))]
            return {**scene(f"circles-{len(points)}", distances(*edges), 2, points=["a", "b", *points]),
                    "fixed": {"a": [0, 0], "b": [3, 4]}}
        beside_axis = {**scene("beside-axis", distances(("a", "c", 3.141593), ("c", "b", 1.858407)), 2, points=["a", "b", "c"]),
                       "fixed": {"a": [0, 0], "b": [0, 5]}}
        for given, different, count, in_clusters in (
                ("tangents-fourfold", 3, 12, 0), (beside_axis, 1, 2, 0), (circles("c"), 1, 2, 0), (circles("c", "d"), 1, 4, 0),
                (circles("c", "d", "e"), 1, 8, 0), (osculating(3), 10, 12, 0), (osculating(4), 9, 12, 0), (osculating(3, scale=3), 12, 12, 3)):
            if isinstance(given, dict):
                given = self.write(given, f"{given['id']}.json")
            certificate = self.certificate(given, strategy="monodromy", codes=(DONE, CHECK_FAILED))
            name = certificate["instance"]["id"]
            real, up_to = sum(solution["real"] for solution in certificate["solutions"]), " up to reflection" * name.startswith("osculating")
            counted = f", {in_clusters} of them, with multiplicities, in clusters" if in_clusters else f", {count} with multiplicities"
            self.assertEqual(verdict(certificate), f"{name}: exactly {different} isolated complex solution{'s' * (different > 1)}{up_to}"
                                                   f"{counted}, {real} of {'the others' if in_clusters else 'them'} real: proven.")
            number, multiplicity = max(((k, solution.get("multiplicity", 1)) for k, solution in enumerate(certificate["solutions"])),
                                       key=lambda pair: pair[1])
            for wrong in {1, 2, 3, 4, 5} - {multiplicity}:
                other = with_value(certificate, ["solutions", number, "multiplicity"], wrong)
                other["complex"] += wrong - multiplicity
                self.assertIsNone(verdict(other))
            if in_clusters:
                self.assertIsNone(verdict(with_value(certificate, ["solutions", number, "real"], True)))
            if name in ("circles-1", "osculating-3-1", "osculating-3-3"):
                self.assert_changes_are_harmless(name, certificate)

    def test_zeros_of_high_multiplicity(self):
        """(4x − 1)^d = 0, with the powers in between as unknowns, is one solution of multiplicity d, as fractions show, and only so."""
        for degree in range(2, 9):
            powers = [{0: 4, None: -1}, *({k: 1} for k in range(1, degree - 1))]
            equations = [([(powers[0], powers[k - 1]), ({k: -1}, {None: 1})], 0) for k in range(1, degree - 1)]
            equations.append(([(powers[0], powers[-1])], 0))
            for multiplicity in {degree - 1, degree, degree + 1} & set(range(2, 9)):
                box = object.__new__(checker.FiniteBox)
                box.exponent, box.radius, box.multiplicity = -120, 1 << 100, multiplicity
                box.centre = [(1 << 118, 0)] + [(0, 0)] * (degree - 2)
                box.point = box.zero_in_fractions(equations)
                is_one = box.point is not None and checker.holds_cluster(box, equations)
                self.assertEqual(is_one, multiplicity == degree, (degree, multiplicity))

    def test_changes_are_refused_or_change_nothing(self):
        for given in (*map(NAMED.get, ("planes", "meeting", "inclined", "parallel", "beside", "cylinder", "table", "tripod")), CARRIED,
                      SEGMENTS):
            self.assert_changes_are_harmless(given["id"], self.certificate(self.write(given, f"{given['id']}.json")))
        self.assert_changes_are_harmless("planar-platform", self.certificate("planar-platform"))

    def test_other_values_are_refused(self):
        for given in map(NAMED.get, ("planes", "meeting", "parallel", "ball", "cylinder", "hung tripod")):
            certificate = self.certificate(self.write(given, f"{given['id']}.json"))
            for number, constraint in enumerate(given["constraints"]):
                for key in {"length", "degrees"} & constraint.keys():
                    with self.subTest(scene=given["id"], constraint=constraint):
                        place = ["instance", "constraints", number, key]
                        self.assertIsNone(verdict(with_value(certificate, place, constraint[key] * (1 + 1e-11))))
                if constraint["type"] in ("on", "meet", "parallel", "perpendicular"):
                    for kind in {"on", "meet", "parallel", "perpendicular"} - {constraint["type"]}:
                        self.assertIsNone(verdict(with_value(certificate, ["instance", "constraints", number, "type"], kind)))

    def test_a_body_is_not_mirrored(self):
        """The image of one posture in a mirror is no other posture."""
        certificate = self.certificate("platform")
        number = next(k for k, solution in enumerate(certificate["solutions"]) if solution["real"])
        solution = certificate["solutions"][number]
        mirrored = [str(-int(value)) if place % 3 == 2 else value for place, value in enumerate(solution["numbers"])]
        self.assertIsNone(verdict(with_value(certificate, ["solutions", number, "numbers"], mirrored)))

    def test_a_list_that_lacks_one_is_not_complete(self):
        for given, count, counted in COUNTED:
            certificate = self.certificate(self.write(given, f"{given['id']}.json"))
            real = at(certificate, ["solutions", 0, "real"])
            del certificate["solutions"][0]
            self.assertIsNone(verdict(certificate))
            certificate["complex"] -= 1
            certificate["real"] -= real
            self.assertRegex(verdict(certificate), f"^{given['id']}: at least {count - 1} complex solutions?{counted}, .*"
                                                   "; isolated are at most [0-9]+[.]$")


if __name__ == "__main__":
    command_line.main()
