"""What tests of scenes whose fixed elements leave motions check, and scenes made of a figure."""

import json
import math
import random

import command_line
from command_line import DONE, run
from general_scenes import distances


def combined(a, p, b=0, q=(0, 0, 0)):
    return [a * x + b * y for x, y in zip(p, q)]


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


def unit(p):
    return [x / math.hypot(*p) for x in p]


def cross(p, q):
    return [p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2] for i in range(3)]


def foot(point, line):
    along = unit(line["direction"])
    return combined(1, line["point"], dot(combined(1, point, -1, line["point"]), along), along)


def distance_of(a, b):
    """Of two elements as a file has them, where none is parallel to the other; of a plane as seen from its side."""
    if isinstance(b, list):
        return math.dist(a, b)
    if "normal" in b:
        return (dot(a, b["normal"]) - b["offset"]) / math.hypot(*b["normal"])
    if isinstance(a, list):
        return math.dist(a, foot(a, b))
    return abs(dot(combined(1, a["point"], -1, b["point"]), unit(cross(a["direction"], b["direction"]))))


def angle_of(a, b):
    cosine = dot(*(unit(place.get("direction") or place["normal"]) for place in [a, b]))
    if "normal" in a and "normal" in b:
        return math.degrees(math.acos(cosine))
    between = math.degrees(math.acos(abs(cosine)))
    return between if "direction" in a and "direction" in b else 90 - between


def measured(dimension, places, joined, angles=(), on=()):
    """The scene of the elements of a figure, with these distances, angles and incidences of it."""
    def names(is_kind):
        return [name for name, place in places.items() if is_kind(place)]

    return {"format": "gcsbench-instance/2", "id": "measured", "dimension": dimension,
            "points": names(lambda place: isinstance(place, list)),
            "lines": names(lambda place: "direction" in place), "planes": names(lambda place: "normal" in place),
            "constraints": distances(*((a, b, distance_of(places[a], places[b])) for a, b in joined)) +
                           [{"type": "angle", "between": [a, b], "degrees": angle_of(places[a], places[b])}
                            for a, b in angles] + [{"type": "on", "between": [a, b]} for a, b in on]}


def in_another_unit(place, unit_of_length):
    if isinstance(place, list):
        return [unit_of_length * x for x in place]
    return {key: value if key in ["direction", "normal"] else in_another_unit([value], unit_of_length)[0]
            if key == "offset" else in_another_unit(value, unit_of_length) for key, value in place.items()}


def renumbered(scene, fixed, unit_of_length=2.0 ** -30):
    """The same with all in the opposite order, in another unit."""
    turned = scene | {kind: scene[kind][::-1] for kind in ["points", "lines", "planes"]}
    turned["constraints"] = [c | {key: unit_of_length * c[key] for key in ["length"] if key in c}
                             for c in scene["constraints"][::-1]]
    return turned, {name: in_another_unit(place, unit_of_length) for name, place in reversed(fixed.items())}


class PartlyFixedScenes(command_line.CommandLine):
    def setUp(self):
        super().setUp()
        self.random = random.Random(7)

    def position(self, size=3, dimension=3):
        return [self.random.uniform(-size, size) for _ in range(dimension)]

    def line(self, dimension=3):
        return {"point": self.position(dimension=dimension), "direction": self.position(dimension=dimension)}

    def plane(self):
        return {"normal": self.position(), "offset": self.random.uniform(-3, 3)}

    def result(self, scene, strategy="monodromy", *options):
        file, out = self.write(scene, f"{scene['id']}.json"), self.folder / "result.json"
        done = run("--quiet", "solve", file, "--strategy", strategy, *options, "--out", out)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        return json.loads(out.read_text())

    def certified(self, scene, strategy="monodromy"):
        result = self.result(scene, strategy, "--certify")
        self.assertEqual(result["counts"]["certified"], result["counts"]["complex"])
        done = run("--quiet", "verify", self.folder / "result.json")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        return result

    def assert_solved(self, scene, fixed, count, strategies=("monodromy", "polyhedral")):
        """As many complex solutions, each with the fixed elements in their places and the distances of points."""
        for strategy in strategies:
            result = self.certified(scene | {"fixed": fixed}, strategy)
            counts = result["counts"]
            self.assertEqual((counts["convention"], counts["complex"]), ("in the given frame", count))
            self.assertCountEqual(result["frame"]["fixed"], fixed)
            for solution in result["solutions"]:
                if solution["real"]:
                    self.assert_in_place(solution, fixed)
                    self.assert_distances(solution, scene)
        return result

    def assert_in_place(self, solution, fixed):
        for name, place in fixed.items():
            if isinstance(place, list):
                self.assertLess(math.dist(solution["points"][name], place), 1e-12)
            elif "normal" in place:
                norm, plane = math.hypot(*place["normal"]), solution["planes"][name]
                self.assertLess(math.dist(plane["normal"], unit(place["normal"])), 1e-12)
                self.assertAlmostEqual(plane["offset"], place["offset"] / norm, delta=1e-12)
            else:
                line, along = solution["lines"][name], unit(place["direction"])
                self.assertAlmostEqual(abs(dot(line["direction"], along)), 1, delta=1e-12)
                foot = combined(1, place["point"], -dot(place["point"], along), along)
                self.assertLess(math.dist(line["point"], foot), 1e-12)

    def assert_distances(self, solution, scene):
        points = solution["points"]
        for constraint in scene["constraints"]:
            a, b = constraint["between"]
            if a in points and b in points:
                self.assertAlmostEqual(math.dist(points[a], points[b]), constraint["length"], delta=1e-9)

    def apart(self, result, a, b):
        """The distances that two points have in real solutions, in order."""
        return sorted(math.dist(s["points"][a], s["points"][b]) for s in result["solutions"] if s["real"])
