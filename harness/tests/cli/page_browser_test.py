#!/usr/bin/python3
"""The page of `gcsbench report` as a person meets it: in a browser, with mouse and keyboard.

Usage: page_browser_test.py PROGRAM SOURCE_DIR [unittest arguments]; exit code 77 where there is no Chromium.
"""

import itertools
import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

import command_line
import devtools
from command_line import DONE, NOT_SOLVED
from general_scenes import HELD, PLATFORM, planes

BROWSER = devtools.find_browser()

SKIPPED = 77
HOME, END, RIGHT = ("Home", 36), ("End", 35), ("ArrowRight", 39)

# Beside two shipped ones: every text that comes from the file tries to be more than text.
HOSTILE = {
    "format": "gcsbench-instance/1", "id": "hostile",
    "title": "</script><img src='http://localhost/x' onerror='spoiled=1'>",
    "dimension": 2, "points": ["<b>", "q\"'&", "p</g>"],
    "constraints": [{"id": "<i>", "type": "distance", "between": ["<b>", "q\"'&"], "length": 1},
                    {"id": "]]>", "type": "distance", "between": ["<b>", "p</g>"], "length": 0.7},
                    {"id": "<!--", "type": "distance", "between": ["q\"'&", "p</g>"], "length": 0.6}],
    "sketch": {"<b>": [0, 0], "q\"'&": [1, 0], "p</g>": [0.5, 0.4]},
    "notes": "<!-- <script>spoiled=1</script>",
}


# Its second triangle goes round.
PRISM = {
    "format": "gcsbench-instance/1", "id": "prism", "dimension": 2, "points": list("abcdef"),
    "constraints": [{"id": pair, "type": "distance", "between": list(pair), "length": 1}
                    for pair in ("ab", "bc", "ca", "de", "ef", "fd", "ad", "be", "cf")],
}


def run(*arguments, code=DONE):
    done = command_line.run("--quiet", *arguments)
    if done.returncode != code:
        raise RuntimeError(f"{done.returncode}: {done.stderr}")


def length(constraint):
    return constraint["length"] if "length" in constraint else math.sqrt(constraint["squared"])


class View:
    """What the page should show of a figure at first: the ball of the largest solution, turned and in perspective."""

    HALF, EYE, WIDTH = 160, 5, 0.86

    def __init__(self, scene):
        self.dimension = scene["instance"]["dimension"]
        self.distances = [constraint["between"] for constraint in scene["instance"]["constraints"]
                          if constraint["type"] == "distance"]
        figure = scene["solutions"][0]
        points = self.points(figure)
        self.centre = [sum(c) / len(points) for c in zip(*points)]
        self.radius = max(self.reach(solution) for solution in scene["solutions"])

    def points(self, figure):
        return [(*p, 0)[:3] for p in figure["points"].values()]

    def reach(self, figure):
        points = self.points(figure)
        centre = [sum(c) / len(points) for c in zip(*points)]
        feet = [foot_on_line(line, centre) for line in figure["lines"].values()]
        feet += [foot_on_plane(plane, centre) for plane in figure.get("planes", {}).values()]
        for point, other in self.distances:
            if other in figure["lines"]:
                feet.append(foot_on_line(figure["lines"][other], figure["points"][point]))
            if other in figure.get("planes", {}):
                feet.append(foot_on_plane(figure["planes"][other], figure["points"][point]))
        return max(math.dist(p, centre) for p in points + feet)

    def seen(self, vector):
        """A direction as the eye sees it: turned about the z-axis and then about the x-axis."""
        if self.dimension == 2:
            return vector
        x, y, z = vector
        (c, s), (d, t) = [(math.cos(a), math.sin(a)) for a in (-0.5, -1.2)]
        x, y = c * x - s * y, s * x + c * y
        return x, d * y - t * z, t * y + d * z

    def place(self, point):
        return self.seen([(p - c) / self.radius for p, c in zip(point, self.centre)])

    def on_page(self, point):
        x, y, z = self.place(point)
        scale = self.WIDTH * self.HALF * (1 if self.dimension == 2 else self.EYE / (self.EYE - z))
        return self.HALF + scale * x, self.HALF - scale * y

    def on_plane(self, plane, corner):
        """The place on the plane that is seen at that corner of the page."""
        normal = self.seen(plane["normal"])
        offset = (plane["offset"] - dot(plane["normal"], self.centre)) / self.radius
        x, y = (corner[0] - self.HALF) / self.WIDTH / self.HALF, (self.HALF - corner[1]) / self.WIDTH / self.HALF
        # (x·(1 − z/eye), y·(1 − z/eye), z) lies on it.
        flat = normal[0] * x + normal[1] * y
        z = (offset - flat) / (normal[2] - flat / self.EYE)
        return x * (1 - z / self.EYE), y * (1 - z / self.EYE), z


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def foot_on_line(line, point):
    along = dot([p - q for p, q in zip(point, line["point"])], line["direction"])
    return [p + along * d for p, d in zip((*line["point"], 0)[:3], (*line["direction"], 0)[:3])]


def foot_on_plane(plane, point):
    away = plane["offset"] - dot(plane["normal"], point)
    return [p + away * n for p, n in zip(point, plane["normal"])]


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        hostile = cls.folder / "hostile.json"
        hostile.write_text(json.dumps(HOSTILE))
        run("tables", "table1", "--instances", f"octahedron,k33,{hostile}", "--strategies", "full-space,rcp",
            "--repetitions", 3, "--out", cls.folder / "run")
        run("tables", "tangents", "--repetitions", 3, "--out", cls.folder / "lines")
        general = [cls.folder / f"{scene['id']}.json" for scene in (PLATFORM, HELD, planes())]
        for path, scene in zip(general, (PLATFORM, HELD, planes())):
            path.write_text(json.dumps(scene))
        run("tables", "general", "--instances", ",".join(map(str, general)), "--strategies", "newton-multistart",
            "--repetitions", 1, "--out", cls.folder / "general")
        prism = cls.folder / "prism.json"
        prism.write_text(json.dumps(PRISM))
        run("tables", "general", "--instances", f"disulfide,{prism}", "--strategies", "explore,monodromy",
            "--repetitions", 1, "--out", cls.folder / "moving", code=NOT_SOLVED)  # there is no end of its solutions
        run("report", *(cls.folder / name for name in ("run", "lines", "general", "moving")), "--format", "html")
        cls.page = cls.folder / "run" / "report.html"
        cls.browser = devtools.Browser(BROWSER)
        cls.addClassCleanup(cls.browser.close)
        cls.browser.open(cls.page.as_uri())
        cls.instances = {}
        for file in cls.folder.glob("*/scenes/*.json"):
            cls.instances[file.stem] = json.loads(file.read_text())

    def part(self, instance, name):
        return f"document.querySelector('#scene-{instance} [data-part={name}]')"

    def evaluate(self, expression):
        return self.browser.evaluate(expression)

    def drawn_points(self, instance):
        circles = f"[...{self.part(instance, 'view')}.querySelectorAll('circle')]"
        return self.evaluate(f"{circles}.map(c => [Number(c.getAttribute('cx')), Number(c.getAttribute('cy'))])")

    def middle(self, instance, name):
        element = self.part(instance, name)
        self.evaluate(f"{element}.scrollIntoView({{block: 'center'}})")
        return self.evaluate(f"(b => [b.x + b.width / 2, b.y + b.height / 2])({element}.getBoundingClientRect())")

    def choose(self, instance, name, value):
        self.evaluate(f"(e => {{ e.value = {json.dumps(value)}; e.dispatchEvent(new Event('change')); return 0; }})"
                      f"({self.part(instance, name)})")

    def move_slider(self, instance, key):
        self.evaluate(f"{self.part(instance, 'slider')}.focus()")
        self.browser.press(*key)

    def coordinates(self, instance):
        """{point: (shown, listed)}; listed is None where no solution is chosen."""
        rows = self.evaluate(f"[...{self.part(instance, 'coordinates')}.rows]"
                             ".map(row => [...row.cells].map(cell => cell.textContent.replace('−', '-')))")
        result = {}
        for name, *cells in rows:
            half = len(cells) // 2
            listed = None if "–" in cells[half:] else [float(text) for text in cells[half:]]
            result[name] = ([float(text) for text in cells[:half]], listed)
        return result

    def test_nothing_fails_and_nothing_is_fetched(self):
        self.evaluate("1")
        errors = [e for e in self.browser.events if e["method"] == "Runtime.exceptionThrown"
                  or (e["method"] == "Runtime.consoleAPICalled" and e["params"]["type"] in ("error", "warning"))
                  or (e["method"] == "Log.entryAdded" and e["params"]["entry"]["level"] == "error")]
        self.assertEqual(errors, [])
        requests = {e["params"]["request"]["url"] for e in self.browser.events
                    if e["method"] == "Network.requestWillBeSent"}
        self.assertEqual(requests, {self.page.as_uri()})

    def test_texts_of_files_are_only_texts(self):
        self.assertEqual(self.evaluate("typeof spoiled"), "undefined")
        self.assertEqual(self.evaluate("document.querySelectorAll('img').length"), 0)
        title = self.evaluate("document.querySelector('#scene-hostile h3').textContent")
        self.assertEqual(title, "hostile: " + HOSTILE["title"])
        labels = self.evaluate(f"[...{self.part('hostile', 'view')}.querySelectorAll('text')].map(t => t.textContent)")
        self.assertEqual(sorted(labels), sorted(HOSTILE["points"]))

    def test_every_instance_is_drawn(self):
        shown = self.evaluate("[...document.querySelectorAll('.scene')].map(s => s.id)")
        self.assertEqual(sorted(shown), sorted("scene-" + name for name in self.instances))
        for name, scene in self.instances.items():
            with self.subTest(name):
                instance = scene["instance"]
                figure = scene["solutions"][0]
                self.assertEqual(len(self.drawn_points(name)), len(figure["points"]))
                kinds = self.evaluate(f"[...{self.part(name, 'view')}.querySelectorAll('line, polygon')]"
                                      ".map(element => element.classList[0])")
                self.assertEqual(kinds.count("edge"),
                                 sum(constraint["type"] == "distance" for constraint in instance["constraints"]))
                self.assertEqual(kinds.count("line"), len(figure["lines"]))
                for kind in ("plane", "normal", "normal-head"):
                    self.assertEqual(kinds.count(kind), len(figure.get("planes", {})))
                self.assertEqual(kinds.count("body"), len(instance.get("bodies", {})))
                thumbnails = self.evaluate(f"{self.part(name, 'gallery')}.querySelectorAll('button').length")
                self.assertEqual(thumbnails, len(scene["solutions"]))

    def shapes(self, name, kind):
        """{title: corners} of what is drawn of that kind."""
        read = ("s => [s.querySelector('title').textContent, s.points ? [...s.points].map(p => [p.x, p.y])"
                " : ['1', '2'].map(i => [Number(s.getAttribute('x' + i)), Number(s.getAttribute('y' + i))])]")
        return dict(self.evaluate(f"[...{self.part(name, 'view')}.querySelectorAll('.{kind}')].map({read})"))

    def test_elements_are_drawn_where_the_solution_has_them(self):
        for name in ("planar-platform", "held-body", "three-planes"):
            with self.subTest(name):
                scene = self.opened(name)
                figure, view = scene["solutions"][0], View(scene)
                for a, b in zip(sorted(self.drawn_points(name)), sorted(map(view.on_page, view.points(figure)))):
                    self.assertLess(math.dist(a, b), 0.02)
                self.assert_lines_drawn(name, figure, view)
                self.assert_planes_drawn(name, figure, view)
                self.assert_bodies_drawn(name, scene, view)

    def opened(self, name):
        """The scene, with its first solution shown as it is seen first."""
        self.browser.open(self.page.as_uri())
        return self.instances[name]

    def assert_lines_drawn(self, name, figure, view):
        drawn = self.shapes(name, "line")
        self.assertEqual(set(drawn), set(figure["lines"]))
        for line, (a, b) in drawn.items():
            for along in (-0.5, 0, 0.5):
                position = figure["lines"][line]
                point = [p + along * d for p, d in zip(position["point"], position["direction"])]
                x, y = view.on_page(point)
                turn = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
                self.assertLess(abs(turn) / math.dist(a, b), 0.05)

    def assert_planes_drawn(self, name, figure, view):
        drawn, normals = self.shapes(name, "plane"), self.shapes(name, "normal")
        planes_there = figure.get("planes", {})
        self.assertEqual(set(drawn), set(planes_there))
        for plane, corners in drawn.items():
            position = planes_there[plane]
            foot = foot_on_plane(position, view.centre)
            distance = math.dist(foot, view.centre) / view.radius
            expected = math.sqrt(max(0.15, 1 - distance ** 2))
            for corner in corners:
                self.assertAlmostEqual(math.dist(view.on_plane(position, corner), view.place(foot)), expected, delta=0.01)
            tip = [p + 0.3 * view.radius * n for p, n in zip(foot, position["normal"])]
            start, end = normals[f"normal of {plane}"]
            self.assertLess(math.dist(start, view.on_page(foot)), 0.02)
            self.assertLess(math.dist(end, view.on_page(tip)), 0.02)

    def assert_bodies_drawn(self, name, scene, view):
        points = scene["solutions"][0]["points"]
        bodies = scene["instance"].get("bodies", {})
        drawn = self.shapes(name, "body")
        self.assertEqual(set(drawn), set(bodies))
        for body, corners in drawn.items():
            places = [view.on_page((*points[p], 0)[:3]) for p in bodies[body] if p in points]
            self.assertEqual(len(corners), 3, "of three points")
            for place in places:
                self.assertLess(min(math.dist(place, corner) for corner in corners), 0.02)

    def test_bodies_stay_rigid_from_solution_to_solution(self):
        for name in ("planar-platform", "held-body"):
            with self.subTest(name):
                scene = self.opened(name)
                bodies = [[p for p in body if p in scene["solutions"][0]["points"]]
                          for body in scene["instance"]["bodies"].values()]
                self.choose(name, "goal", 1)
                places = []
                for value in (1, 3000, 6000, 9999):
                    self.evaluate(f"(s => {{ s.value = {value}; s.dispatchEvent(new Event('input')); return 0; }})"
                                  f"({self.part(name, 'slider')})")
                    rows = self.evaluate(f"[...{self.part(name, 'coordinates')}.rows]"
                                         ".map(row => [...row.cells].map(cell => cell.textContent.replace('−', '-')))")
                    dimension = scene["instance"]["dimension"]
                    places.append({row[0]: [float(x) for x in row[1:1 + dimension]] for row in rows
                                   if row[0] in scene["solutions"][0]["points"]})
                for solution, there in ((0, places[0]), (1, places[-1])):
                    for point, listed in scene["solutions"][solution]["points"].items():
                        self.assertLess(math.dist(there[point], listed), 5e-3, "a ten thousandth of the way from it")
                for before, after in itertools.pairwise(places):
                    self.assertGreater(max(math.dist(before[p], after[p]) for p in before), 1e-2, "it moves")
                    for body in bodies:
                        for p, q in itertools.combinations(body, 2):
                            self.assertAlmostEqual(math.dist(before[p], before[q]), math.dist(after[p], after[q]), delta=1e-5)

    def test_dragging_and_arrow_keys_turn_the_figure(self):
        for name in self.instances:
            with self.subTest(name):
                before = self.drawn_points(name)
                x, y = self.middle(name, "view")
                self.browser.drag((x, y), (x + 80, y + 30))
                dragged = self.drawn_points(name)
                self.assertGreater(max(map(math.dist, before, dragged)), 10)
                self.evaluate(f"{self.part(name, 'view')}.focus()")
                self.browser.press(*RIGHT)
                self.assertGreater(max(map(math.dist, dragged, self.drawn_points(name))), 1)
                small = self.evaluate(f"{self.part(name, 'gallery')}.querySelector('circle').getAttribute('cx')")
                self.middle(name, "view")
                self.browser.press(*RIGHT)
                self.assertNotEqual(small, self.evaluate(
                    f"{self.part(name, 'gallery')}.querySelector('circle').getAttribute('cx')"), "thumbnails turn too")

    def test_the_slider_leads_from_the_sketch_to_each_solution(self):
        for name in ("octahedron", "k33", "hostile"):
            scene = self.instances[name]
            instance = scene["instance"]
            self.assertGreater(len(scene["crossings"]), 0)
            for number, crossing in enumerate(scene["crossings"]):
                with self.subTest(instance=name, crossing=number):
                    self.choose(name, "goal", number)
                    self.move_slider(name, HOME)
                    sketch = {point: shown for point, (shown, _) in self.coordinates(name).items()}
                    for a, b in itertools.combinations(instance["points"], 2):
                        expected = math.dist(instance["sketch"][a], instance["sketch"][b])
                        self.assertAlmostEqual(math.dist(sketch[a], sketch[b]), expected, delta=2e-3 * expected)
                    self.move_slider(name, END)
                    listed = scene["solutions"][crossing["solution"]]["points"]
                    for point, (shown, beside) in self.coordinates(name).items():
                        self.assertEqual(shown, beside)
                        for value, sign, exact in zip(shown, crossing["signs"], listed[point]):
                            self.assertAlmostEqual(value, sign * exact, delta=1e-5)
                    there = {point: shown for point, (shown, _) in self.coordinates(name).items()}
                    for constraint in instance["constraints"]:
                        a, b = constraint["between"]
                        self.assertAlmostEqual(math.dist(there[a], there[b]), length(constraint), delta=1e-5)

    def test_lengths_on_the_way_are_those_of_the_interpolation(self):
        instance = self.instances["k33"]["instance"]
        self.choose("k33", "goal", 0)
        self.evaluate("(s => { s.value = 5000; s.dispatchEvent(new Event('input')); return 0; })"
                      f"({self.part('k33', 'slider')})")
        words = self.evaluate(f"{self.part('k33', 'where')}.textContent")
        t = float(words.split("t = ")[1].split(",")[0].replace("−", "-"))
        points = {point: shown for point, (shown, _) in self.coordinates("k33").items()}
        for constraint in instance["constraints"][:-1]:  # the last one is bent
            a, b = constraint["between"]
            expected = (1 - t) * math.dist(instance["sketch"][a], instance["sketch"][b]) + t * length(constraint)
            self.assertAlmostEqual(math.dist(points[a], points[b]), expected, delta=2e-2)

    def test_the_plot_of_the_path(self):
        for name in ("octahedron", "k33", "hostile"):
            with self.subTest(name):
                scene = self.instances[name]
                points, constraints = len(scene["instance"]["points"]), len(scene["instance"]["constraints"])
                options = self.evaluate(f"[...{self.part(name, 'coordinate')}.options].map(o => o.text)")
                distances = [text for text in options if text.startswith("|")]
                self.assertEqual(len(distances), points * (points - 1) // 2 - constraints)
                self.assertIn("arc length", options)
                marks = self.evaluate(f"{self.part(name, 'plot')}.querySelectorAll('.solution').length")
                self.assertEqual(marks, len(scene["crossings"]))
                curve = f"{self.part(name, 'plot')}.querySelector('.curve').getAttribute('d')"
                before = self.evaluate(curve)
                self.choose(name, "coordinate", 0)
                self.assertNotEqual(self.evaluate(curve), before)

    def test_plan_changes_are_marked(self):
        for name in ("octahedron", "k33"):
            scene = self.instances[name]
            trails = [trail for trail in scene["trails"] if trail["places"]]
            self.assertGreater(len(trails), 0)
            for number, trail in enumerate(scene["trails"]):
                with self.subTest(instance=name, trail=trail["label"]):
                    self.choose(name, "trail", str(number))
                    marks = self.evaluate(f"{self.part(name, 'plot')}.querySelectorAll('.change').length")
                    self.assertEqual(marks, len(trail["places"]) - 1)

    def test_a_click_on_the_plot_moves_along_the_path(self):
        self.choose("k33", "goal", 2)  # all of S
        before = self.drawn_points("k33")
        x, y = self.middle("k33", "plot")
        self.browser.click((x + 40, y))
        self.assertGreater(max(map(math.dist, before, self.drawn_points("k33"))), 1)

    def slide(self, instance, part):
        """The coordinates shown at that part of the way."""
        self.evaluate(f"(s => {{ s.value = {part} * s.max; s.dispatchEvent(new Event('input')); return 0; }})"
                      f"({self.part(instance, 'slider')})")
        return {point: shown for point, (shown, _) in self.coordinates(instance).items()}

    def goal(self, instance, group):
        """The value of the first way of that group."""
        return self.evaluate(f"[...{self.part(instance, 'goal')}.querySelectorAll('optgroup')]"
                             f".find(g => g.label === {json.dumps(group)}).querySelector('option').value")

    def test_a_motion_keeps_all_distances(self):
        self.opened("prism")
        self.choose("prism", "goal", self.goal("prism", "motions"))
        places = [self.slide("prism", k / 8) for k in range(9)]
        for points in places:
            for constraint in PRISM["constraints"]:
                a, b = constraint["between"]
                self.assertAlmostEqual(math.dist(points[a], points[b]), 1, delta=1e-2)
        for before, after in itertools.pairwise(places):
            self.assertGreater(max(math.dist(before[p], after[p]) for p in before), 0.2, "an eighth of a turn")
        self.assertLess(max(math.dist(places[0][p], places[-1][p]) for p in places[0]), 1e-3, "it is closed")

    def test_the_graph_leads_from_solution_to_solution(self):
        scene = self.opened("disulfide")
        lengths = {c["id"]: (c["between"], length(c)) for c in scene["instance"]["constraints"]}
        graph = self.part("disulfide", "graph")
        self.assertEqual(self.evaluate(f"{graph}.querySelectorAll('.node').length"), len(scene["solutions"]))
        self.click(f"{graph}.querySelector('[data-solution=\"4\"] circle')")
        node, reached = scene["solutions"][4]["points"], self.coordinates("disulfide")
        self.assertTrue(all(shown == listed for shown, listed in reached.values()))
        for a, b in itertools.combinations(node, 2):  # S may come to its mirror image
            self.assertAlmostEqual(math.dist(reached[a][0], reached[b][0]), math.dist(node[a], node[b]), delta=1e-5)
        self.choose("disulfide", "edges", "all")
        self.assertEqual(self.evaluate(f"{graph}.querySelectorAll('.edge-of-graph').length"), len(scene["curves"]))
        number = int(self.evaluate(f"[...{graph}.querySelectorAll('.edge-of-graph')].at(-1).dataset.curve"))
        self.evaluate(f"{graph}.querySelector('[data-curve=\"{number}\"] .reach')"
                      ".dispatchEvent(new Event('click', {bubbles: true}))")
        curve = scene["curves"][number]
        self.assertEqual(self.evaluate(f"{self.part('disulfide', 'play')}.textContent"), "Stop", "it moves")
        self.evaluate(f"{self.part('disulfide', 'play')}.click()")
        for part, released in ((0, set()), (3 / 11, {curve["constraint"]}), (1, set())):
            points = self.slide("disulfide", part)
            for constraint, ((a, b), given) in lengths.items():
                if constraint not in released:
                    self.assertAlmostEqual(math.dist(points[a], points[b]), given, delta=1e-2)
        first, last = scene["solutions"][curve["from"]]["points"], scene["solutions"][curve["to"]]["points"]
        for part, solution in ((0, first), (1, last)):
            points = self.slide("disulfide", part)
            for a, b in itertools.combinations(points, 2):
                self.assertAlmostEqual(math.dist(points[a], points[b]), math.dist(solution[a], solution[b]), delta=1e-2)

    def click(self, element):
        self.evaluate(f"{element}.scrollIntoView({{block: 'center'}})")
        self.browser.click(self.evaluate(
            f"(b => [b.x + b.width / 2, b.y + b.height / 2])({element}.getBoundingClientRect())"))

    def test_narrow_screens_show_all_of_it(self):
        self.browser.send("Emulation.setDeviceMetricsOverride", width=380, height=800, deviceScaleFactor=1,
                          mobile=False)
        self.addCleanup(self.browser.send, "Emulation.clearDeviceMetricsOverride")
        self.assertLessEqual(self.evaluate("document.scrollingElement.scrollWidth"), 380)


if __name__ == "__main__":
    if BROWSER is None:
        print("skipped: there is no Chromium (Debian package chromium)")
        sys.exit(SKIPPED)
    command_line.main()
