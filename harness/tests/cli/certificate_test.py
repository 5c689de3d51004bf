#!/usr/bin/python3
"""`gcsbench solve --certificate` and scripts/check-certificate: what is a theorem, and that nothing false becomes one.

Usage: certificate_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import copy
import itertools
import json
import math
import random
import re
import subprocess

import command_line
from certificates import SCRIPT, CertificateTest, at, checker, sentence, some_of, verdict, with_value, without
from command_line import BAD_INPUT, CHECK_FAILED, DONE, SOURCE, run
from general_scenes import distances

# Complex and real solutions up to reflection. K3,3: 16 in the fixed frame (Capco et al. 2018). Prism: two triangles on
# three legs have 6 postures for each orientation (Hunt 1983), all of them real here by box subdivision. Octahedron: at
# most 16 in the frame, four real ones (Imbach, Mathis, Schreck 2016), whose table has 32 · 8 and 18 of the disulfide.
KNOWN = {"k33": (8, 2), "prism": (12, 12), "octahedron": (8, 4), "disulfide": (32, 18)}

# Graphs with most realisations among those of 6, 7 and 8 points, by the bits of their adjacency matrices, and these
# numbers (Capco et al. 2018, table 1).
RECORDS = {7916: 24, 1269995: 56, 170989214: 136}


# A line at distances from four given points has 12 places (Macdonald, Pach, Theobald 2001), here 4 (Durand 1998) and 12
# (Sottile, Theobald 2002) real ones.
TANGENTS = {"tangents-durand": (12, 4), "tangents-12-real": (12, 12)}

# An octahedron of points and planes has at most 16 figures in its frame (Hoffmann, Yuan 2001).
OCTAHEDRAL = ("octahedral-5p1h", "octahedral-4p2h", "octahedral-3p3h")


# A triangle on three legs from given points: 6 postures of each orientation (Hunt 1983).
PLANAR_PLATFORM = {
    "format": "gcsbench-instance/1", "id": "planar", "dimension": 2, "points": ["a1", "b3", "a2", "b1", "b2", "a3"],
    "fixed": {"a1": [0, 0], "a2": [5, 0.25], "a3": [3.1, 4.7]},
    "constraints": distances(("b1", "b2", 3), ("b2", "b3", 2.5), ("b3", "b1", 2), ("a1", "b1", 2.9), ("a2", "b2", 3.3),
                             ("b3", "a3", 3.1))}

# One on six legs that meet in pairs: 16 postures (Griffis, Duffy 1989).
PLATFORM = {
    "format": "gcsbench-instance/1", "id": "spatial", "dimension": 3, "points": ["b1", "a1", "b2", "a2", "a3", "b3"],
    "fixed": {"a1": [0, 0, 0.1], "a2": [5, 0.25, 0], "a3": [3.1, 4.7, -1]},
    "constraints": distances(("b1", "b2", 3), ("b2", "b3", 2.5), ("b3", "b1", 2), ("a1", "b1", 4.9), ("a2", "b2", 4.3),
                             ("a3", "b3", 4.1), ("a1", "b2", 4.8), ("b3", "a2", 4.9), ("a3", "b1", 4.3))}

# A tetrahedron, a plane that hangs on three of its points, two ways as n·n = 1 is all that is not linear, and a line at four
# distances, 12 ways: 24. Rounded from p = 0, q = (3, 0, 0), r = (5/4, 5/2, 0), s = (1, 1, 5/2), n = (2, 1, 2)/3, h = 1/2 and
# a line through (1/2, 1/4, 3/4) along (2, 3, 6)/7, so that there are real ones.
HUNG = {
    "format": "gcsbench-instance/2", "id": "hung", "dimension": 3, "points": ["p", "q", "r", "s"], "lines": ["m"],
    "planes": ["h"],
    "constraints": distances(("p", "q", 3), ("r", "q", 3.052), ("p", "r", 2.795), ("s", "p", 2.872), ("q", "s", 3.354),
                             ("r", "s", 2.926), ("h", "p", -0.5), ("q", "h", 1.5), ("s", "h", 2.167), ("m", "p", 0.279),
                             ("m", "q", 2.622), ("s", "m", 0.129), ("m", "r", 2.429))}

# Nothing but lines in space.
SKEW = {"format": "gcsbench-instance/2", "id": "skew", "dimension": 3, "points": [], "lines": ["K", "L", "M"],
        "constraints": [*distances(("K", "L", 1), ("L", "M", 1.2), ("M", "K", 0.8)),
                        *({"type": "angle", "between": pair, "degrees": 60} for pair in (["K", "L"], ["L", "M"], ["M", "K"]))]}


def restated(scene, name, names, exponent, draw):
    """By another name, other names, in other orders, and in units of 2^−exponent."""
    def scaled(numbers):
        return [number * 2.0 ** exponent for number in numbers]

    def turned(constraint):
        return {**constraint, "between": [names[element] for element in constraint["between"]][::-1],
                **{key: scaled([constraint[key]])[0] for key in constraint if key == "length"}}

    elements = {kind: draw.sample([names[name] for name in scene[kind]], len(scene[kind]))
                for kind in ("points", "lines", "planes") if kind in scene}
    fixed = {"fixed": {names[name]: scaled(place) for name, place in scene["fixed"].items()}} if "fixed" in scene else {}
    constraints = [turned(constraint) for constraint in draw.sample(scene["constraints"], len(scene["constraints"]))]
    return {"format": scene["format"], "id": name, "dimension": scene["dimension"], **elements, **fixed,
            "constraints": constraints}


class Certificates(CertificateTest):
    def checked(self, text):
        return subprocess.run([SCRIPT, "-"], input=text, capture_output=True, text=True, timeout=60, check=False)

    def test_known_numbers_are_theorems(self):
        for name, (found, real) in KNOWN.items():
            self.assertEqual(verdict(self.certificate(name)), sentence(name, found, real))

    def real_in(self, certificate):
        return int(re.search(r"([0-9]+) of them real", verdict(certificate))[1])

    def test_given_positions(self):
        """Real ones are those that subdivision of a plan's angle finds."""
        for scene, found in ((PLANAR_PLATFORM, 12), (PLATFORM, 16)):
            path = self.write(scene, f"{scene['id']}.json")
            real = self.real_in(self.certificate(path, strategy="plan-scan"))
            self.assertEqual(verdict(self.certificate(path)), sentence(scene["id"], found, real, counted=""))

    def test_lines_at_distances_from_points(self):
        for name, (found, real) in TANGENTS.items():
            self.assertEqual(verdict(self.certificate(name)), sentence(name, found, real, counted=""))
        self.assertRegex(verdict(self.certificate("two-lines")), "^two-lines: exactly 144 complex solutions, .* proven[.]$")
        self.assertRegex(verdict(self.certificate("octahedron-line")), "^octahedron-line: exactly 96 complex .* proven[.]$")
        # A pyramid of five points and a line in its frame; real ones by subdivision of an angle.
        pyramid = self.certificate("hoffmann-yuan", strategy="theta-scan")
        self.assertEqual(verdict(pyramid), some_of("hoffmann-yuan", 6, 6, 72))
        # Which point is beside the line in the frame does not matter.
        scene = pyramid["instance"]
        for point in scene["points"][:2]:
            scene.update(id=f"with-{point}", reference={"line": "L", "height": point})
            other = self.certificate(self.write(scene, f"with-{point}.json"), strategy="theta-scan")
            self.assertEqual(verdict(other), some_of(f"with-{point}", 6, 6, 72))

    def test_wheels_beside_a_line(self):
        """As many as there can be by the theorem are found, which knows nothing of paths. The real ones of 5p1L are those of
        theta-scan."""
        self.assertEqual(verdict(self.certificate("hoffmann-yuan")), sentence("hoffmann-yuan", 72, 6))
        dice = random.Random(5)
        places = {f"p{k}": [dice.uniform(-3, 3) for _ in range(3)] for k in range(6)}
        hub, *rim = places
        edges = [(hub, point) for point in rim] + [*zip(rim, rim[1:] + rim[:1])]
        scene = {"format": "gcsbench-instance/1", "id": "wheel", "dimension": 3, "points": list(places), "lines": ["L"],
                 "constraints": distances(*((point, "L", math.hypot(*places[point][1:])) for point in places),
                                          *((a, b, math.dist(places[a], places[b])) for a, b in edges))}
        certificate = self.certificate(self.write(scene, "wheel.json"))
        self.assertRegex(verdict(certificate), "^wheel: exactly 360 complex solutions up to reflection, .* proven[.]$")
        # Of a triangle on which the fourth point hangs they are 128 at most.
        other = self.certificate("hoffmann-yuan")["instance"]
        next(c for c in other["constraints"] if c["id"] == "a10").update(between=["p1", "p3"])
        other.update(id="hung", published=[])
        hung = self.certificate(self.write(other, "hung.json"))
        self.assertRegex(verdict(hung), "isolated are at most 128[.]$")
        part = {"argument": "wheel beside a line", "points": [*other["points"], "L"]}
        self.assertIsNone(verdict(with_value(hung, ["limit"], [part])))

    def test_planes(self):
        for name in OCTAHEDRAL:
            real = self.real_in(self.certificate(name, strategy="plan-scan"))
            self.assertEqual(verdict(self.certificate(name)), sentence(name, 8, real))
        # Nor whether the distances of the frame's points are given.
        scene = self.certificate("octahedral-5p1h")["instance"]
        opposite = next([a, b] for a in scene["points"] for b in scene["points"] if a < b and not any(
            {a, b} == set(constraint["between"]) for constraint in scene["constraints"]))
        third = next(point for point in scene["points"] if point not in opposite)
        scene.update(id="across", reference=dict(zip(("origin", "axis", "plane"), [*opposite, third])))
        self.assertRegex(verdict(self.certificate(self.write(scene, "across.json"))), "^across: exactly 8 complex ")

    def test_of_parts_and_hung_points_too(self):
        # Two octahedra with a triangle in common: 16 · 16 in the frame.
        tower = verdict(self.certificate("octahedra@2"))
        self.assertRegex(tower, r"^octahedra@2: exactly 128 complex .*: proven\.$")
        k33 = json.loads((SOURCE / "instances" / "k33.json").read_text())
        hung = {**{key: k33[key] for key in ("format", "dimension")}, "id": "hung",
                "points": k33["points"] + ["hung"],
                "constraints": k33["constraints"] + [
                    {"type": "distance", "between": ["hung", point], "squared": square}
                    for point, square in zip(k33["points"], (7.3, 5.1))]}
        self.assertRegex(verdict(self.certificate(self.write(hung, "hung.json"))), "^hung: exactly 16 complex")

    def test_other_names_orders_and_units_change_nothing(self):
        draw = random.Random(5)
        octahedron = json.loads((SOURCE / "instances" / "octahedron.json").read_text())
        names = dict(zip(octahedron["points"], draw.sample(["a", "b b", "ö", "3", "p1", "p-"], 6)))
        for exponent in (-500, 70):
            path = self.write(restated(octahedron, f"in{exponent}", names, exponent, draw), f"in{exponent}.json")
            self.assertEqual(verdict(self.certificate(path)), sentence(f"in{exponent}", *KNOWN["octahedron"]))

    def test_lines_planes_and_positions_may_be_restated_too(self):
        draw = random.Random(6)
        found = {"planar": 12, "spatial": 16, "hung": 24}
        for scene in (PLANAR_PLATFORM, PLATFORM, HUNG):
            elements = [name for kind in ("points", "lines", "planes") for name in scene.get(kind, [])]
            names = dict(zip(elements, draw.sample([f"e{k}" for k in range(9)], len(elements))))
            name = f"restated-{scene['id']}"
            path = self.write(restated(scene, name, names, draw.choice((-500, 70)), draw), f"{name}.json")
            counted = "" if "fixed" in scene else " up to reflection"
            self.assertRegex(verdict(self.certificate(path)),
                             f"^{name}: exactly {found[scene['id']]} complex solutions{counted}, .* real: proven[.]$")

    def test_stiff_scenes_are_within_reach(self):
        """An octahedron with a solution 1e10 away, whose inverse matrix doubles do not hold; K3,3 with two hung points."""
        for name, found in (("escaping@1e-10", 8), ("mixed-lengths@1e-8", 16 * 2 * 2 // 2)):
            self.assertRegex(verdict(self.certificate(name)), rf"^{name}: exactly {found} complex .*: proven\.$")

    def test_solutions_at_infinity_make_a_list_complete(self):
        """Six points have at most 8 solutions up to reflection; of this octahedron one point escapes, as two ways around an
        equator are equally long. In another unit and by other names, too."""
        octahedron = self.certificate("escaping@0")["instance"]
        for name, exponent in (("same", 0), ("tiny", -120), ("huge", 18)):
            names = dict(zip(octahedron["points"], ["f", "e", "d", "c", "b", "a"]))
            constraints = [{"type": "distance", "between": [names[point] for point in constraint["between"]][::-1],
                            "length": float(f"{constraint['length']}e{exponent}")}
                           for constraint in octahedron["constraints"]]
            scene = {"format": octahedron["format"], "id": name, "dimension": 3, "points": sorted(names.values()),
                     "constraints": constraints[::-1]}
            certificate = self.certificate(self.write(scene, f"{name}.json"))
            self.assertRegex(verdict(certificate), rf"^{name}: exactly 7 complex .* real: proven; 1 is at infinity\.$")
        way = ["at_infinity", "ways", 0, 0]
        corners, signs = (at(certificate, [*way, name]) for name in ("walk", "signs"))
        for member, other in (("walk", corners[::-1]), ("signs", [*signs[:-1], -signs[-1]]), ("points", corners[:1]),
                              ("across", 0)):
            with self.subTest(other=member):
                self.assertIsNone(verdict(with_value(certificate, [*way, member], other)))
        twice = copy.deepcopy(certificate)
        twice["at_infinity"]["solutions"] *= 2
        self.assertIsNone(verdict(twice))
        place = ["instance", "constraints", 0, "length"]
        self.assertIsNone(verdict(with_value(certificate, place, at(certificate, place) * (1 + 1e-12))))

    def test_realisations_are_those_of_the_literature(self):
        for code, known in RECORDS.items():
            bits = f"{code:b}"
            points = next(n for n in range(2, 20) if n * (n - 1) // 2 >= len(bits))
            pairs = [(i, j) for i in range(points) for j in range(i + 1, points)]
            edges = [pair for pair, bit in zip(pairs, bits.zfill(len(pairs))) if bit == "1"]
            self.assertEqual(checker.Realisations().count([(edge, edge) for edge in edges]), known)

    def test_a_change_is_refused_or_changes_nothing(self):
        scenes = {name: name for name in ("k33", "octahedron", "escaping@0", "tangents-durand", "octahedral-4p2h")}
        scenes.update((scene["id"], self.write(scene, f"{scene['id']}.json")) for scene in (PLANAR_PLATFORM, HUNG))
        for name, scene in scenes.items():
            counts = (2, 9) if name == "k33" else (1, 2)
            self.assert_changes_are_harmless(name, self.certificate(scene), *counts)

    def test_what_says_something_else_is_refused(self):
        certificate = self.certificate("k33")
        solutions = certificate["solutions"]
        wrong = {"a count": with_value(certificate, ["complex"], 9),
                 "the number of real ones": with_value(certificate, ["real"], 3),
                 "a bound": with_value(certificate, ["limit", 0, "at_most"], 18),
                 "a pair": with_value(certificate, ["solutions", 5], solutions[4]),
                 "a format": with_value(certificate, ["format"], "gcsbench-certificate/1")}
        for number, constraint in enumerate(certificate["instance"]["constraints"]):
            name = "length" if "length" in constraint else "squared"
            place = ["instance", "constraints", number, name]
            wrong[f"length {number}"] = with_value(certificate, place, constraint[name] * (1 + 1e-12))
            wrong[f"ends {number}"] = with_value(certificate, [*place[:3], "between"], constraint["between"][:1] * 2)
        mirrored = copy.deepcopy(solutions[4])
        mirrored["numbers"][2::2] = map(self.negative, mirrored["numbers"][2::2])  # y of the four beside the frame
        wrong["a mirror image"] = with_value(certificate, ["solutions", 5], mirrored)
        for number, solution in enumerate(solutions):
            wrong[f"realness {number}"] = with_value(certificate, ["solutions", number, "real"], not solution["real"])
            for unknown in range(len(solution["numbers"])):
                wrong[f"place {number} {unknown}"] = with_value(
                    certificate, ["solutions", number, "numbers", unknown], str(2 ** 90))
        for what, changed in wrong.items():
            with self.subTest(what=what):
                self.assertIsNone(verdict(changed))

    @staticmethod
    def negative(number):
        return [str(-int(part)) for part in number] if isinstance(number, list) else str(-int(number))

    def test_a_list_that_lacks_one_is_not_complete(self):
        certificate = self.certificate("prism")
        found, real = KNOWN["prism"]
        del certificate["solutions"][3]
        self.assertIsNone(verdict(certificate))
        certificate["complex"], certificate["real"] = found - 1, real - 1
        self.assertEqual(verdict(certificate), some_of("prism", found - 1, real - 1, found))
        certificate["limit"] = None
        self.assertEqual(verdict(certificate), sentence("prism", found - 1, real - 1, "at least"))
        found, real = KNOWN["disulfide"]
        self.assertEqual(verdict(self.certificate("disulfide", "--solutions", "real")),
                         some_of("disulfide", real, real, found))

    def test_other_groups_prove_the_same_or_nothing(self):
        certificate = self.certificate("octahedron")
        self.assertEqual(certificate["limit"][0]["argument"], "m-Bézout bound")
        points = certificate["instance"]["points"]
        for held in ([points[0]], points[:2], points[:4], [points[0], points[0], points[1]], ["nobody"], "p1"):
            self.assertIsNone(verdict(with_value(certificate, ["limit", 0, "held"], held)))
        for name in ("tangents-durand", "hoffmann-yuan", "octahedral-3p3h"):
            strategy = {"strategy": "theta-scan"} if name == "hoffmann-yuan" else {}
            certificate = self.certificate(name, **strategy)
            part = certificate["limit"][0]
            wrong = [{**part, "points": part["points"][1:]}, {**part, "points": part["points"] * 2},
                     *({**part, "held": held} for held in (part.get("held", [])[::-1], ["nobody"]) if "held" in part),
                     *({**part, "argument": argument} for argument in ("hung point", "realisation count", "ring of bodies",
                                                                        "m-Bézout bound") if argument != part["argument"])]
            for other in wrong:
                with self.subTest(name=name, other=other):
                    self.assertIn(verdict(with_value(certificate, ["limit", 0], other)),
                                  (None, verdict(certificate) if name == "octahedral-3p3h" else None))
        ring = self.certificate("disulfide")
        bodies = ring["limit"][0]["bodies"]
        self.assertEqual(verdict(with_value(ring, ["limit", 0, "bodies"], bodies[2:] + bodies[:2])),
                         sentence("disulfide", *KNOWN["disulfide"]))

    def test_points_at_infinity_at_all_lengths(self):
        """As many real ones as Bartzos, Emiris, Legerský and Tsigaridas have, and no more: 16 and 24 in the frame."""
        for name, found in (("g16b", 8), ("g24", 12)):
            certificate = self.certificate(name)
            self.assertEqual(verdict(certificate), sentence(name, found, found))
            [part] = certificate["limit"]
            [gone] = part["at_infinity"]
            held, others = part["held"], [point for point in part["points"] if point not in part["held"]]
            wrong = [[gone, gone], [[]], [gone[:1]], [held[:1]], [[*gone, held[0]]], [["nobody"]], gone, None,
                     *([list(some)] for count in range(1, 5) for some in itertools.combinations(others, count)
                       if set(some) != set(gone))]
            for other in wrong:
                with self.subTest(name=name, other=other):
                    self.assertIsNone(verdict(with_value(certificate, ["limit", 0, "at_infinity"], other)))
            without_them = without(part, ["at_infinity"])
            self.assertIsNone(verdict(with_value(certificate, ["limit", 0], without_them)))
            self.assertEqual(verdict(with_value(certificate, ["limit", 0], without(without_them, ["at_most"]))),
                             some_of(name, found, found, 16))
        # A part that stands on nothing may be anywhere, and all of it held says nothing.
        certificate = self.certificate("g16b")
        certificate.update(complex=1, real=1, solutions=certificate["solutions"][:1])
        held = [["p1", "p2", "p3"], ["p4", "p6", "p7"], ["p1", "p2", "p3", "p4", "p6", "p7"], ["p5", "p4"]]
        parts = [{"argument": "m-Bézout bound", "points": points, "held": points} for points in held]
        parts.insert(3, {"argument": "hung point", "points": ["p5", "p1", "p2", "p3"]})
        self.assertIsNone(verdict({**certificate, "limit": parts}))
        # Of planes nothing of the kind is known.
        planes = self.certificate("octahedral-5p1h")
        self.assertIsNone(verdict(with_value(planes, ["limit", 0, "at_infinity"], [planes["instance"]["points"][3:4]])))

    def test_codes_and_messages(self):
        certificate = self.certificate("k33")
        good = self.checked(json.dumps(certificate))
        self.assertEqual((good.returncode, good.stdout, good.stderr), (DONE, sentence("k33", *KNOWN["k33"]) + "\n", ""))
        text = json.dumps(certificate)
        for bad, code in ((json.dumps(with_value(certificate, ["complex"], 7)), CHECK_FAILED), (text[:-1], BAD_INPUT),
                          (text.replace('"real": ', '"real": 2, "real": ', 1), BAD_INPUT), ("[" * 100000, BAD_INPUT),
                          (text.replace('"dimension": 2', '"dimension": 1e999999999'), BAD_INPUT), ("NaN", BAD_INPUT),
                          (json.dumps(without(certificate, ["frame"])), BAD_INPUT), ("", BAD_INPUT)):
            done = self.checked(bad)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (code, "", 1), done.stderr)

    def test_scenes_and_lists_without_a_certificate(self):
        out = self.folder / "none.json"
        turning = {**PLANAR_PLATFORM, "format": "gcsbench-instance/2", "fixed": {"a1": [1, 2]}, "constraints": PLANAR_PLATFORM["constraints"] + distances(
            ("a1", "a2", 5), ("a1", "a3", 5.5), ("a2", "a3", 4.6))}
        for scene, place in ((turning, "/fixed"), (SKEW, "/reference")):
            path = self.write(scene, f"{scene['id']}.json")
            done = run("solve", path, "--strategy", "monodromy", "--certificate", out)
            self.assert_one_message(done, BAD_INPUT, "--certificate", place)
        nothing = run("--quiet", "solve", "inconsistent@0", "--strategy", "monodromy", "--certificate", out)
        self.assertIn("no certificate is written", nothing.stderr)
        self.assertFalse(out.exists())
        used = self.write(json.loads((SOURCE / "instances" / "k33.json").read_text()), "k33.json")
        self.assert_usage_error(run("solve", used, "--strategy", "monodromy", "--certificate", used), "--certificate")


if __name__ == "__main__":
    command_line.main()
