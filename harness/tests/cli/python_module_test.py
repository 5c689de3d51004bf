#!/usr/bin/python3
"""The Python module solves, answers in arrays, stops, and is installed where Python finds it.

Usage: python_module_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import importlib.util
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from decimal import Decimal
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE

BUILD = Path(PROGRAM).parent.parent
sys.path.insert(0, str(BUILD / "python"))

import gcsbench  # noqa: E402
import numpy as np  # noqa: E402

# Has more solutions than can be found in the time of a test.
ENDLESS = {"strategy": "full-space", "step_max": 1e-6}

INTERRUPTED = """
import gcsbench
print("ready", flush=True)
answer = gcsbench.solve(gcsbench.Problem.read("icosahedron"), "newton-multistart", starts=1000000)
print(answer.status, len(answer) > 0, answer.is_real.all())
"""


def triangle():
    problem = gcsbench.Problem(dimension=2).points("a", "b", "c")
    return problem.distance("a", "b", "3.1").distance("b", "c", 4).distance("c", "a", 5)


def icosahedron():
    return gcsbench.Problem.read("icosahedron")


class Solving(unittest.TestCase):
    def test_a_triangle_is_where_the_law_of_cosines_says(self):
        answer = gcsbench.solve(triangle(), "monodromy", certify=True)
        self.assertEqual((answer.status, answer.claim, len(answer)), ("complete", "all complex", 1))
        along = (3.1**2 + 5**2 - 4**2) / (2 * 3.1)
        self.assertEqual(answer.solutions.dtype, np.float64)
        np.testing.assert_allclose(answer.point("c"), [[along, math.sqrt(25 - along**2)]], rtol=1e-14)
        self.assertTrue(answer.certified.all() and answer.proofs["complete"])
        self.assertLess(answer.error_bound[0], 1e-13)
        self.assertIs(answer.solutions, answer.solutions)
        self.assertRaises(KeyError, answer.point, "d")

    def test_a_motion_is_an_array_of_figures_along_it(self):
        # Two regular triangles joined by three bars, all of length 1: the second one goes round.
        prism = gcsbench.Problem(dimension=2).points(*"abcdef")
        for a, b in ("ab", "bc", "ca", "de", "ef", "fd", "ad", "be", "cf"):
            prism.distance(a, b, 1)
        answer = gcsbench.solve(prism, "monodromy")
        self.assertEqual(answer.status, "infinite")
        curve = answer.motions[0]["curve"]
        self.assertEqual((curve["end"], curve["figures"].shape[1:]), ("closed", (6, 2)))
        crank = curve["figures"][:, 3] - curve["figures"][:, 0]
        np.testing.assert_allclose(np.linalg.norm(crank, axis=1), 1, rtol=1e-12)
        self.assertAlmostEqual(abs(np.unwrap(np.arctan2(crank[:, 1], crank[:, 0]))[[0, -1]] @ [1, -1]), 2 * math.pi)

    def test_exploring_gives_the_curves_between_solutions(self):
        problem = gcsbench.Problem.read(SOURCE / "instances" / "disulfide.json")
        answer = gcsbench.solve(problem, "explore", samples=1)
        self.assertEqual(answer.solutions.shape, (18, 8, 3))
        met = {crossing["solution"] for curve in answer.graph for crossing in curve["crossings"]}
        self.assertEqual(met, set(range(18)))
        curve = answer.graph[0]
        self.assertEqual((curve["end"], curve["figures"].shape[1:]), ("closed", (8, 3)))
        here = curve["figures"][curve["places"][0]]
        there = answer.solutions[curve["crossings"][0]["solution"]]
        spans = [np.linalg.norm(place[:, None] - place[None, :], axis=2) for place in (here, there)]
        np.testing.assert_allclose(*spans, rtol=1e-8)
        self.assertIsNone(gcsbench.solve(problem, "monodromy").graph)

    def test_complex_solutions_have_the_given_lengths_and_are_as_many_as_there_are(self):
        problem = gcsbench.Problem.read(SOURCE / "instances" / "disulfide.json")
        answer = gcsbench.solve(problem, "monodromy")
        self.assertEqual(answer.solutions.shape, (32, 8, 3))  # the bound of the ring, which is met
        self.assertEqual(problem.count()["bound"]["up_to_reflection"], 32)
        self.assertEqual(answer.is_real.sum(), answer.counts["real"])
        real = answer.solutions[answer.is_real]
        self.assertFalse(np.any(real.imag))
        self.assertTrue(np.any(answer.solutions[~answer.is_real].imag))
        for constraint in problem._document["constraints"]:
            a, b = (answer.points.index(name) for name in constraint["between"])
            difference = answer.solutions[:, a] - answer.solutions[:, b]
            square = float(constraint.get("squared") or float(constraint["length"]) ** 2)
            np.testing.assert_allclose((difference**2).sum(axis=1), square, rtol=1e-9)

    def test_lines_and_planes_have_arrays_too(self):
        problem = gcsbench.Problem.read("octahedral-5p1h")
        answer = gcsbench.solve(problem, certify=True)
        self.assertEqual((len(answer), answer.counts["convention"]), (8, "up to reflection"))  # known truth
        normals, offsets = answer.solution_planes["normal"], answer.solution_planes["offset"]
        for constraint in problem._document["constraints"]:
            point, plane = sorted(constraint["between"], key=answer.planes.count)
            if plane in answer.planes:
                there = answer.planes.index(plane)
                height = (normals[:, there] * answer.point(point)).sum(axis=1) - offsets[:, there]
                np.testing.assert_allclose(height, float(constraint["length"]), rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose((normals**2).sum(axis=-1), 1)
        lines = gcsbench.solve(gcsbench.Problem.read("two-lines"), time_limit=60).solution_lines
        self.assertEqual(lines["point"].shape, (144, 2, 3))  # known truth
        np.testing.assert_allclose((lines["direction"] ** 2).sum(axis=-1), 1)
        np.testing.assert_allclose((lines["point"] * lines["direction"]).sum(axis=-1), 0, atol=1e-6)

    def test_the_seed_decides_and_threads_do_not(self):
        problem = gcsbench.Problem.read("k33")
        one = gcsbench.solve(problem, seed=3, threads=1)
        np.testing.assert_array_equal(one.solutions, gcsbench.solve(problem, seed=3, threads=3).solutions)

    def test_a_start_system_serves_other_lengths(self):
        def prism(*lengths):
            problem = gcsbench.Problem(dimension=2).points(*"abcdef")
            for (a, b), length in zip(("ab", "bc", "ca", "de", "ef", "fd", "ad", "be", "cf"), lengths):
                problem.distance(a, b, length)
            return problem

        other = prism(6, 5, 4, 6, 5, 7, 3, 4, 5)
        searched = gcsbench.solve(other, "monodromy")
        self.assertEqual(len(searched), 12)  # 24 realisations, two mirror images each
        self.assertGreater(searched.particulars["loop_paths"], 0)
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/prism.json"
            gcsbench.solve(prism(5, 6, 4, 5, 6, 7, 4, 3, 5), "monodromy", save_start=file)
            answer = gcsbench.solve(other, "monodromy", start=file, certify=True)
            self.assertRaisesRegex(gcsbench.Error, "prism.json", gcsbench.solve,
                                   gcsbench.Problem.read(SOURCE / "instances" / "k33.json"), "monodromy", start=file)
            self.assertRaisesRegex(gcsbench.Error, "none.json", gcsbench.solve, other, "monodromy",
                                   start=f"{folder}/none.json")
        self.assertEqual(answer.status, "complete")
        self.assertTrue(answer.certified.all())
        np.testing.assert_allclose(answer.solutions, searched.solutions, rtol=0, atol=1e-8)

    def test_a_certificate_is_written_and_checked_by_another_program(self):
        octahedron = gcsbench.Problem.read(SOURCE / "instances" / "octahedron.json")
        answer = gcsbench.solve(octahedron, "monodromy", certify=True)
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/proof.json"
            self.assertEqual(answer.write_certificate(file), 8)  # half of the bound of 16 for six points
            checked = subprocess.run([SOURCE / "scripts" / "check-certificate", file], capture_output=True, text=True, check=True)
            self.assertRegex(checked.stdout, "^octahedron: exactly 8 complex solutions .*: proven")
            unproven = gcsbench.solve(octahedron, "monodromy")
            self.assertRaisesRegex(gcsbench.Error, "certify=True", unproven.write_certificate, file)
            self.assertRaisesRegex(gcsbench.Error, "none", answer.write_certificate, f"{folder}/none/proof.json")

    def test_options_are_keywords_and_listed(self):
        answer = gcsbench.solve(gcsbench.Problem.read("octahedron"), "rcp", mode="paper", reduce=False)
        self.assertEqual((answer.options["mode"], answer.options["reduce"]), ("paper", "off"))
        default, allowed, meaning = gcsbench.strategies()["rcp"]["options"]["mode"]
        self.assertIn(default, allowed)
        self.assertTrue(meaning)


def corner(length):
    """c above a–b of length 3 where ca is that long and bc is 4, by the law of cosines."""
    along = (9 + length**2 - 16) / 6
    return [along, math.sqrt(length**2 - along**2)]


class Following(unittest.TestCase):
    def setUp(self):
        self.problem = gcsbench.Problem(dimension=2).points("a", "b", "c")
        self.problem.distance("a", "b", 3).distance("b", "c", 4).distance("c", "a", 5)
        self.at = {"a": [0, 0], "b": [3, 0], "c": [3, 4]}

    def test_a_triangle_follows_its_side_from_any_kind_of_figure(self):
        answer = gcsbench.solve(self.problem)
        moved = gcsbench.follow(self.problem, self.at, {"a3": 6})
        for start in (self.at, np.array(list(self.at.values()), dtype=float), answer, moved):
            for prove in (True, False):
                leg = gcsbench.follow(self.problem, start, to={"a3": "6.5"}, prove=prove)
                self.assertEqual((leg.end, leg.reason, leg.proven, leg.fold), ("reached", "", prove, None))
                np.testing.assert_allclose(leg.figure[2], corner(6.5), rtol=1e-13)
                self.assertEqual(leg.error_bound is not None and leg.error_bound < 1e-13, prove)
        for element, position in self.at.items():
            self.problem.sketch(element, position)
        np.testing.assert_allclose(gcsbench.follow(self.problem).figure[2], corner(5), rtol=1e-13)

    def test_a_fold_is_enclosed_and_ends_a_polyline(self):
        legs = gcsbench.follow_polyline(self.problem, self.at, [{"a3": 6}, {"a3": 8}, {"a3": 5}])
        self.assertEqual([leg.end for leg in legs], ["reached", "folds"])
        low, high = legs[1].values["a3"]
        self.assertTrue(low <= 7 <= high < low + 1e-8)
        low, high = legs[1].fold
        self.assertTrue(low <= 0.5 <= high < low + 1e-8)
        self.assertEqual((legs[1].beyond.status, len(legs[1].beyond)), ("complete", 0))
        self.assertIsNone(gcsbench.follow(self.problem, self.at, {"a3": 8}, beyond=False).beyond)

    def test_planes_move_too_there_and_back(self):
        problem = gcsbench.Problem.read("octahedral-5p1h")
        answer = gcsbench.solve(problem)
        start = int(np.flatnonzero(answer.is_real)[0])
        name = "a1"
        length = Decimal(problem._document["constraints"][0]["length"])
        there, back = gcsbench.follow_polyline(problem, answer, [{name: length * Decimal("1.0001")}, {name: length}],
                                               solution=start)
        self.assertTrue(there.proven and back.proven)
        np.testing.assert_allclose(back.figure, answer.solutions[start].real, atol=1e-9)
        self.assertGreater(abs(there.figure - back.figure).max(), 1e-6)
        np.testing.assert_allclose((back.figure_planes["normal"] ** 2).sum(axis=-1), 1)
        self.assertEqual(back.figure_planes["offset"].shape, (1,))

    def test_what_is_wrong_is_said(self):
        disulfide = gcsbench.Problem.read("disulfide")
        answer = gcsbench.solve(disulfide)
        imaginary = int(np.flatnonzero(~answer.is_real)[0])
        said = {"no sketch": lambda: gcsbench.follow(self.problem),
                "no constraint with a value has the id 'cd'": lambda: gcsbench.follow(self.problem, self.at, {"cd": 1}),
                "> 0": lambda: gcsbench.follow(self.problem, self.at, {"a3": -1}),
                "2 positions for 3 points": lambda: gcsbench.follow(self.problem, np.zeros((2, 2))),
                "is not real": lambda: gcsbench.follow(disulfide, answer, solution=imaginary),
                "there is no solution 99": lambda: gcsbench.follow(disulfide, answer, solution=99)}
        for words, call in said.items():
            with self.assertRaises(gcsbench.Error) as raised:
                call()
            self.assertIn(words, str(raised.exception))
        flat = gcsbench.follow(self.problem, self.at, {"a3": 7})
        self.assertEqual((flat.end, flat.figure, flat.fold), ("undecided", None, None))
        self.assertIn(flat.reason, repr(flat))
        with self.assertRaisesRegex(gcsbench.Error, "no figure to begin at"):
            gcsbench.follow(self.problem, flat)

    def test_the_time_limit_ends_it(self):
        moved = gcsbench.follow(gcsbench.Problem.read("icosahedron"), time_limit=0.05)
        self.assertEqual((moved.end, moved.beyond.status), ("folds", "stopped"))


class Stating(unittest.TestCase):
    def test_texts_decimals_and_whole_numbers_are_exact_and_floats_binary(self):
        def given(number):
            return re.search(r'"length": (.+?)}', gcsbench.Problem(2).distance("a", "b", number).to_json())[1]
        self.assertEqual([given("0.1"), given(Decimal("0.1")), given(3)], ["0.1", "0.1", "3"])
        self.assertEqual(Decimal(given(0.1)), Decimal(0.1))
        self.assertEqual(Decimal(given(np.float64(1e-300))), Decimal(1e-300))

    def test_a_file_keeps_its_decimals(self):
        file = SOURCE / "instances" / "octahedron.json"
        text = gcsbench.Problem.read(file).to_json()
        self.assertEqual(re.findall(r'"length": ([\d.]+)', text),
                         re.findall(r'"length": ([\d.]+)', file.read_text(encoding="utf-8")))

    def test_what_is_wrong_is_said(self):
        loose = gcsbench.Problem(2).points("a", "b", "c").distance("a", "b", 1)
        said = {"under-constrained": lambda: gcsbench.solve(loose),
                "is no decimal number": lambda: loose.distance("a", "b", "long"),
                "no number that can be given": lambda: loose.distance("a", "b", math.inf),
                "there is no strategy 'mono'": lambda: gcsbench.solve(triangle(), "mono"),
                "has no option 'foo'": lambda: gcsbench.solve(triangle(), "rcp", foo=1),
                "no shipped instance": lambda: gcsbench.Problem.read("none"),
                "threads=-1": lambda: gcsbench.solve(triangle(), threads=-1)}
        for words, call in said.items():
            with self.assertRaises(gcsbench.Error) as raised:
                call()
            self.assertIn(words, str(raised.exception))
            self.assertIsInstance(raised.exception, ValueError)

    def test_a_scene_that_a_strategy_cannot_do_is_an_answer(self):
        answer = gcsbench.solve(triangle(), "theta-scan")
        self.assertEqual(answer.status, "unsupported")
        self.assertTrue(answer.reason)
        self.assertEqual(answer.solutions.shape, (0, 3, 2))


class Stopping(unittest.TestCase):
    def test_the_time_limit_ends_a_solve_and_other_threads_run_meanwhile(self):
        turns, ended = [0], threading.Event()

        def count():
            while not ended.wait(0.001):
                turns[0] += 1
        counter = threading.Thread(target=count)
        counter.start()
        answer = gcsbench.solve(icosahedron(), time_limit=0.5, threads=1, **ENDLESS)
        ended.set()
        counter.join()
        self.assertEqual(answer.status, "timed out")
        self.assertIn("0.5 s", answer.reason)
        self.assertGreater(turns[0], 50)

    def test_progress_is_told_and_what_it_raises_ends_the_solve(self):
        said = []

        def hear(stage, fraction):
            said.append((stage, fraction))
            if len(said) == 3:
                raise RuntimeError("enough")
        with self.assertRaisesRegex(RuntimeError, "enough"):
            gcsbench.solve(icosahedron(), progress=hear, **ENDLESS)
        self.assertTrue(all(stage and fraction <= 1 for stage, fraction in said))

    def test_ctrl_c_keeps_what_is_there(self):
        child = subprocess.Popen([sys.executable, "-c", INTERRUPTED], env=os.environ | {"PYTHONPATH": sys.path[0]},
                                 cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "ready\n")
        time.sleep(1)
        child.send_signal(signal.SIGINT)
        out, errors = child.communicate(timeout=60)
        self.assertEqual((out, errors), ("interrupted True True\n", ""))


class Shown(command_line.WithFolder):
    @unittest.skipUnless(importlib.util.find_spec("matplotlib") and importlib.util.find_spec("networkx"),
                         "needs python3-matplotlib and python3-networkx")
    def test_the_example_of_the_front_page_draws_all_realisations(self):
        example = re.search(r"```python\n(.*?)```", (SOURCE / "README.md").read_text(encoding="utf-8"), re.DOTALL)[1]
        self.assertLessEqual(len([line for line in example.splitlines() if line and "import" not in line]), 10)
        checks = "assert answer.proofs['complete'] and len(answer) == 12\n"  # of the prism, a theorem
        done = subprocess.run([sys.executable, "-c", example + checks], cwd=self.folder, capture_output=True, text=True,
                              env=os.environ | {"PYTHONPATH": sys.path[0], "MPLBACKEND": "Agg"}, timeout=120, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertGreater((self.folder / "realisations.svg").stat().st_size, 5000)

    def test_everything_public_is_documented(self):
        for name in gcsbench.__all__:
            public = getattr(gcsbench, name)
            self.assertTrue(public.__doc__, name)
            for member, value in vars(public).items() if isinstance(public, type) else ():
                if not member.startswith("_") and member not in ("strategy", "seed"):
                    self.assertTrue(value.__doc__, f"{name}.{member}")

    @unittest.skipUnless(Path("/usr/bin/mypy").exists(), "needs mypy")
    def test_the_stubs_say_what_is_there(self):
        compiled = self.folder / "compiled"  # their metaclass has no stub, and nobody makes an answer
        compiled.write_text("gcsbench._core.Answer\ngcsbench._core.Answer.__init__\ngcsbench._core.Followed\n"
                            "gcsbench._core.Followed.__init__\ngcsbench._core.Instance\n")
        for module, arguments in [("mypy.stubtest", ["gcsbench._core", "--allowlist", compiled]),
                                  ("mypy", ["--strict", "-p", "gcsbench"])]:
            done = subprocess.run([sys.executable, "-m", module, *arguments], cwd=self.folder, capture_output=True,
                                  text=True, env=os.environ | {"PYTHONPATH": sys.path[0], "MYPYPATH": sys.path[0]},
                                  timeout=200, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_it_is_installed_where_python_finds_it(self):
        version = f"python{sys.version_info.major}.{sys.version_info.minor}"
        own = Path.home() / ".local"
        places = {"/usr": "/usr/lib/python3/dist-packages", "/usr/local": f"/usr/local/lib/{version}/dist-packages",
                  str(own): f"{own}/lib/{version}/site-packages", "/opt/it": f"/opt/it/lib/{version}/site-packages"}
        for prefix, place in places.items():
            stage = self.folder / prefix.replace("/", "_")
            said = subprocess.run(["cmake", "--install", BUILD, "--prefix", prefix], capture_output=True, text=True,
                                  env=os.environ | {"DESTDIR": str(stage)}, timeout=200, check=True).stdout
            package = Path(f"{stage}{place}") / "gcsbench"
            self.assertTrue((package / "__init__.py").is_file(), package)
            self.assertEqual(f"export PYTHONPATH={place}" in said, prefix == "/opt/it")
        # What was installed solves what came with it, away from the source.
        solve = "import gcsbench; print(len(gcsbench.solve(gcsbench.Problem.read('k33'))), gcsbench.__file__)"
        done = subprocess.run([sys.executable, "-c", solve], cwd=self.folder, capture_output=True, text=True,
                              env=os.environ | {"PYTHONPATH": str(package.parent)}, timeout=60, check=True)
        self.assertEqual(done.stdout.split(), ["8", str(package / "__init__.py")])


if __name__ == "__main__":
    command_line.main()
