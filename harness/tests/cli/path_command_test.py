#!/usr/bin/python3
"""`gcsbench path`: the polyline against the distance equations and against what another tracker finds.

Usage: path_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import math

import command_line
from bad_instances import TOY, changed
from command_line import BAD_INPUT, DONE, NOT_SOLVED, SOURCE, run

# Imbach, Mathis, Schreck 2016, Table 1.
PUBLISHED = {"octahedron": 4, "disulfide": 8, "dodecagon": 2}

# A triangle that lies flat at the given lengths: its third point turns back there, and S touches t = 1.
FLAT = {"format": "gcsbench-instance/1", "id": "flat", "dimension": 2, "points": ["a", "b", "c"],
        "constraints": [{"type": "distance", "between": ["a", "b"], "length": 1},
                        {"type": "distance", "between": ["a", "c"], "length": 0.75},
                        {"type": "distance", "between": ["b", "c"], "length": 0.25}],
        "sketch": {"a": [0, 0], "b": [1, 0], "c": [0.5, 0.5]}}


def figure(path, numbers):
    """The points of a row, or of any numbers in its columns."""
    places = {**path["fixed"], **dict(zip(path["columns"], numbers))}
    axes = "xyz"[:path["instance"]["dimension"]]
    return {name: [places[f"{name}.{axis}"] for axis in axes] for name in path["instance"]["points"]}


def length_paths(instance):
    """[I] Definition 1: for every constraint its points and its length as a function of t."""
    ids = [one.get("id", f"a{i + 1}") for i, one in enumerate(instance["constraints"])]
    interpolation = {"bent": ids[-1], "bend": 2, **instance.get("interpolation", {})}
    paths = []
    for name, one in zip(ids, instance["constraints"]):
        a, b = one["between"]
        target = one["length"] if "length" in one else math.sqrt(one["squared"])
        sketch = math.dist(instance["sketch"][a], instance["sketch"][b])
        bend = interpolation["bend"] if name == interpolation["bent"] else 0
        paths.append((a, b, lambda t, sk=sketch, so=target, c=bend: -c * t * t + (so - sk + c) * t + sk))
    return paths


class Paths(command_line.CommandLine):
    def path(self, instance, *options):
        out = self.folder / "path.json"
        done = run("path", instance, "--out", out, *options)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (DONE, "", ""))
        return json.loads(out.read_text())

    def assert_keeps_to_the_equations(self, path):
        for row, after in zip(path["rows"], path["rows"][1:]):
            self.assert_near_equations(path, row, row[2])
            self.assert_near_equations(path, [(a + b) / 2 for a, b in zip(row, after)], row[2])

    def assert_near_equations(self, path, numbers, radius):
        """Two points together, and t, are at most so far from those of a point of S."""
        t, points, dt = numbers[0], figure(path, numbers), radius / path["unit"]
        for a, b, length in length_paths(path["instance"]):
            change = max(abs(length(t + way) - length(t)) for way in (-dt, dt))
            self.assertLessEqual(abs(math.dist(points[a], points[b]) - length(t)), math.sqrt(2) * radius + change)

    def assert_same_crossings(self, path):
        """As the tracker without proofs finds them, which shares no step with the proven one."""
        done = run("solve", path["instance"]["id"], "--strategy", "full-space", "--out", "-")
        found = json.loads(done.stdout)
        self.assertEqual([one["direction"] for one in path["crossings"]],
                         [one["direction"] for one in found["path"]])
        for crossing, met in zip(path["crossings"], found["path"]):
            row = path["rows"][crossing["row"]]
            self.assertEqual(row[0], 1)
            self.assert_figure(figure(path, row), found["solutions"][met["solution"]]["points"], row[2])

    def assert_figure(self, points, solution, radius):
        """The same up to the reflection that a result divides out."""
        def distance(sign):
            return math.sqrt(sum((x * (sign if axis == len(place) - 1 else 1) - y) ** 2
                                 for name, place in points.items()
                                 for axis, (x, y) in enumerate(zip(place, solution[name]))))
        self.assertLessEqual(min(distance(1), distance(-1)), radius)

    def test_describes_itself(self):
        path = self.path("disulfide")
        self.assertEqual(path["format"], "gcsbench-path/1")
        file = SOURCE / "instances" / "disulfide.json"
        self.assertEqual(path["instance"], json.loads(file.read_text()))
        self.assertEqual((path["proven"], path["closed"], path["within"]), (True, True, 1e-3))
        self.assertEqual(path["columns"][:3], ["t", "length", "radius"])
        names = [f"{name}.{axis}" for name in path["instance"]["points"] for axis in "xyz"]
        self.assertEqual(sorted([*path["columns"][3:], *path["fixed"]]), sorted(names))
        for row in path["rows"]:
            self.assertEqual(len(row), len(path["columns"]))

    def test_begins_and_ends_at_the_sketch(self):
        for instance in PUBLISHED:
            with self.subTest(instance):
                path = self.path(instance)
                first, last = path["rows"][0], path["rows"][-1]
                self.assertEqual((first[0], first[1], last[1], last[2]), (0, 0, path["length"], 0))
                self.assertEqual(first[3:], last[3:])
                sketch, points = path["instance"]["sketch"], figure(path, first)
                for one in sketch:
                    for other in sketch:
                        self.assertAlmostEqual(math.dist(points[one], points[other]),
                                               math.dist(sketch[one], sketch[other]), delta=2 * first[2])
                lengths = [row[1] for row in path["rows"]]
                self.assertEqual(lengths, sorted(lengths))

    def test_crossings_are_those_of_the_tracker_without_proofs(self):
        for instance, count in PUBLISHED.items():
            with self.subTest(instance):
                path = self.path(instance)
                self.assertEqual(len(path["crossings"]), count)
                self.assert_same_crossings(path)

    def test_keeps_to_the_equations(self):
        for instance in PUBLISHED:
            with self.subTest(instance):
                self.assert_keeps_to_the_equations(self.path(instance))

    def test_the_shipped_files(self):
        instances = {}
        for file in sorted((SOURCE / "results/reference/paths").iterdir()):
            with self.subTest(file.name):
                path = json.loads(file.read_text())
                instances[file.stem] = path["instance"]
                self.assert_same_crossings(path)
                self.assert_keeps_to_the_equations(path)
        shipped = SOURCE / "instances"
        self.assertEqual(instances, {one: json.loads((shipped / f"{one}.json").read_text())
                                     for one in [*PUBLISHED, "icosahedron"]})

    def test_a_smaller_radius_takes_more_rows(self):
        rows = [len(self.path("octahedron", "--within", within)["rows"]) for within in ("1e-1", "1e-3", "1e-5")]
        self.assertEqual(rows, sorted(set(rows)))

    def test_the_same_bytes_again(self):
        one, two = self.folder / "one.json", self.folder / "two.json"
        for out in (one, two):
            run("path", "dodecagon", "--out", out)
        self.assertEqual(one.read_bytes(), two.read_bytes())

    def test_radii_that_make_no_sense(self):
        out = self.folder / "path.json"
        for radius in ["0", "-1e-3", "1e-9", "nan", "inf", "wide", ""]:
            with self.subTest(radius):
                done = run("path", "octahedron", "--within", radius, "--out", out)
                self.assert_usage_error(done, "--within", "from 1e-5 to 0.1")
                self.assertFalse(out.exists())

    def test_where_there_is_no_path_to_prove(self):
        out = self.folder / "path.json"
        for instance, word in [(self.write(changed(sketch=None)), "sketch"), ("octahedron-line", "points with distances")]:
            self.assert_one_message(run("path", instance, "--out", out), NOT_SOLVED, word)
        done = run("path", self.write(FLAT, "flat.json"), "--out", out)
        self.assert_one_message(done, NOT_SOLVED, "gave up", "touches")
        self.assertFalse(out.exists())

    def test_bad_input(self):
        self.assert_one_message(run("path", self.write("{"), "--out", self.folder / "x"), BAD_INPUT, "toy.json")
        done = run("path", self.write(TOY), "--out", self.folder / "none" / "x")
        self.assert_one_message(done, BAD_INPUT, "cannot be written")
        self.assert_usage_error(run("path", "octahedron"), "--out")


if __name__ == "__main__":
    command_line.main()
