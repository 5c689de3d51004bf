#!/usr/bin/python3
"""`gcsbench tables` and `gcsbench report` from outside: what they print, store, rebuild and refuse.

Usage: tables_command_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import csv
import json
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree

import command_line
from command_line import BAD_INPUT, DONE, INTERRUPTED, NOT_SOLVED, SOURCE, argv, run

SCENE_FOLDERS = {"scenes", "paths"}
TABLE_FILES = {f"{name}.{ext}" for name in ("table1", "measurements") for ext in ("md", "csv", "tex")}


def contents(folder, names):
    return {name: (folder / name).read_bytes() for name in names}


class WithFolder(command_line.WithFolder):
    def measure(self, *more):
        return run("tables", "table1", "--instances", "octahedron", "--strategies", "full-space", "--repetitions", 3,
                   "--out", self.folder, *more)


class Tables(WithFolder):
    def test_prints_and_stores(self):
        done = self.measure()
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertEqual(done.stderr, "")
        self.assertTrue(done.stdout.startswith("### Table 1"))
        self.assertIn("72 [1]", done.stdout)
        self.assertRegex(done.stdout, r"complex, at most +\| +– \| +64 \[2\]")
        self.assertIn("not measured", done.stdout, "the strategy that was not selected")
        self.assertEqual({path.name for path in self.folder.iterdir()}, TABLE_FILES | {"run.json", "report.html"} | SCENE_FOLDERS)
        for folder in SCENE_FOLDERS:
            self.assertEqual([path.name for path in (self.folder / folder).iterdir()], ["octahedron.json"])
        record = json.loads((self.folder / "run.json").read_text())
        self.assertEqual(record["format"], "gcsbench-run/1")
        default = next(cell for cell in record["cells"] if not cell["given"])
        self.assertEqual(default["counts"]["on_path"], 4)
        self.assertEqual(len(default["repetitions"]), 3)

    def test_resume_measures_nothing_again(self):
        self.measure()
        before = json.loads((self.folder / "run.json").read_text())["cells"]
        done = self.measure("--resume")
        self.assertEqual(done.returncode, DONE, done.stderr)
        after = json.loads((self.folder / "run.json").read_text())["cells"]
        finished = [cell for cell in before if cell["status"] == "complete"]
        self.assertTrue(finished)
        for cell in finished:
            self.assertIn(cell, after)

    def test_resume_refuses_the_run_of_another_build(self):
        self.measure()
        file = self.folder / "run.json"
        record = json.loads(file.read_text())
        record["environment"]["compiler"] = "another"
        file.write_text(json.dumps(record))
        done = self.measure("--resume")
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn(str(file), done.stderr)

    def test_interrupt_keeps_what_was_measured(self):
        process = subprocess.Popen(argv("tables", "table1", "--instances", "octahedron,icosahedron", "--out",
                                           self.folder, "--repetitions", 100000),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=SOURCE)
        file = self.folder / "run.json"
        while not file.exists() and process.poll() is None:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate()
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertTrue(output.startswith("### Table 1"))
        self.assertEqual(run("report", self.folder).returncode, DONE)

    def test_tables_without_a_strategy(self):
        """A table says in one line which strategy is missing, or is there."""
        done = run("tables", "tangents", "--repetitions", 3)
        if "no strategy 'sphere-tangents'" in done.stdout:
            self.assertEqual(done.returncode, NOT_SOLVED)
            self.assertEqual(len(done.stdout.splitlines()), 1)
        else:
            self.assertEqual(done.returncode, DONE, done.stderr)
            self.assertTrue(done.stdout.startswith("### 4p1L"))

    def test_tables_with_their_own_instances(self):
        done = run("tables", "hoffmann-yuan", "--repetitions", 3, "--out", self.folder)
        self.assertEqual(done.returncode, DONE, done.stderr)
        tables = ("lengths", "solutions", "scans", "6p")
        files = {f"hoffmann-yuan-{name}.{ext}" for name in tables for ext in ("md", "csv", "tex")}
        files |= {"hoffmann-yuan-curve.svg", "run.json", "report.html"} | SCENE_FOLDERS | {f"measurements.{ext}" for ext in ("md", "csv", "tex")}
        self.assertEqual({path.name for path in self.folder.iterdir()}, files)
        scans = (self.folder / "hoffmann-yuan-scans.csv").read_text()
        self.assertIn("108,108,20,20", scans)
        self.assertIn("224,224,24,24", scans)
        with open(self.folder / "hoffmann-yuan-solutions.csv", newline="") as file:
            solutions = list(csv.DictReader(file))
        self.assertEqual(len(solutions), 24)
        misprinted = [row["number"] for row in solutions if float(row["ours: largest difference"]) > 0.005]
        self.assertEqual(misprinted, ["13"])
        xml.etree.ElementTree.parse(self.folder / "hoffmann-yuan-curve.svg")

    def test_tables_with_their_own_instances_show_no_others(self):
        done = run("tables", "hoffmann-yuan", "--instances", "k33")
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
        self.assertIn("nothing to measure", done.stderr)

    def test_the_plan_is_exchanged_at_every_turn_of_a_chain_of_rockers(self):
        done = run("tables", "plan-changes", "--instances", "rocker-chain@2,rocker-chain@3", "--out", self.folder)
        self.assertEqual(done.returncode, DONE, done.stderr)
        with open(self.folder / "plan-changes.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        # With n rockers 2^n solutions and 2^(n+1) - 2 turns.
        for row, solutions, turns in zip(rows, ("4", "8"), ("6", "14"), strict=True):
            self.assertEqual(row["full-space, mode=certified: on S, proven"], solutions)
            self.assertEqual(row[": turns of S"], turns)
            self.assertEqual(row["rcp, mode=paper, δmax = 0.025: exchanges"], turns)
        growth = [row["rcp: growth"] for row in rows]
        self.assertEqual(growth[0], "–")
        self.assertAlmostEqual(float(growth[1]), int(rows[1]["rcp: changes"]) / int(rows[0]["rcp: changes"]), delta=0.01)
        xml.etree.ElementTree.parse(self.folder / "plan-changes.svg")

    def test_as_many_realisations_are_found_as_counted(self):
        """Published: Capco et al. 2018, on the sphere Gallet, Grasegger, Schicho 2020; K3,3 has 16 on both."""
        some = ["laman-most@6", "sphere-most@6", *(f"{on}-6@{number}" for on in ("laman", "sphere") for number in range(1, 14))]
        done = run("tables", "realisations", "--instances", ",".join(some), "--out", self.folder)
        self.assertEqual(done.returncode, DONE, done.stderr)
        with open(self.folder / "realisations.csv", newline="") as file:
            rows = [list(row.values())[2:6] for row in csv.DictReader(file)]
        self.assertEqual(rows, [["24"] * 4, ["32"] * 4])
        with open(self.folder / "realisations-all.csv", newline="") as file:
            rows = [list(row.values())[2:7] for row in csv.DictReader(file)]
        self.assertEqual(rows, [["13", "16", "24", "13", "13"], ["13", "16", "32", "13", "13"]])

    def test_as_many_realisations_are_real_as_published(self):
        """In space Bartzos et al. 2021; all of the prism: Capco et al. 2018."""
        done = run("tables", "records", "--instances", "g48,record@laman-most-6", "--out", self.folder)
        self.assertEqual(done.returncode, DONE, done.stderr)
        with open(self.folder / "records.csv", newline="") as file:
            rows = [list(row.values())[2:8] for row in csv.DictReader(file)]
        self.assertEqual(rows, [["48"] * 6, ["24"] * 6])

    def test_one_strategy_that_is_out_of_reach_is_no_failure(self):
        done = run("tables", "table1", "--instances", "k33", "--strategies", "full-space,cayley-menger",
                   "--repetitions", 3)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertIn("not measured", done.stdout)

    def test_instances_out_of_reach_say_so_in_every_cell(self):
        done = run("tables", "table1", "--instances", "tangents-durand", "--strategies", "full-space,rcp")
        self.assertEqual(done.returncode, NOT_SOLVED)
        self.assertIn("unsupported", done.stdout)

    def test_general_scenes_are_in_their_table_alone(self):
        done = run("tables", "table1", "general", "--instances", "octahedron,planar-platform", "--strategies",
                   "monodromy,full-space", "--repetitions", 1, "--out", self.folder)
        self.assertEqual(done.returncode, DONE, done.stderr)
        record = json.loads((self.folder / "run.json").read_text())
        shown = {table["name"]: table["instances"] for table in record["tables"]}
        self.assertEqual(shown, {"table1": ["octahedron"], "general": ["octahedron", "planar-platform"]})
        rows = (self.folder / "general.md").read_text().split("planar-platform, up to motion")[1].splitlines()
        self.assertRegex(rows[1], r"^\| known +\| +6 \[\d+\] \| +– \|")
        self.assertRegex(rows[2], r"^\| monodromy +\| +6 \| +4 \| +6 \| +4 \| +all, proven \[\d+\] \|")
        self.assertRegex(rows[3], r"^\| full-space +\| +– \| +2 \| +2 \| +2 \| +those on S \|")
        self.assertIn('id="scene-planar-platform"', (self.folder / "report.html").read_text())

    def test_lines_beside_given_points_have_no_mirror_images(self):
        done = run("tables", "table1", "--instances", "tangents-durand", "--strategies", "monodromy",
                   "--repetitions", 3)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertRegex(done.stdout, r"complex +\| +– \| +12 \[")

    def test_bad_input(self):
        plain_file = self.folder / "file"
        plain_file.write_text("")
        for arguments in (["table3"], ["table1", "--strategies", "nope"], ["table1", "--instances", "nope"],
                          ["table1", "--instances", "k33,k33"], ["table1", "--repetitions", "0"],
                          ["table1", "--resume"], ["table1", "--instances", "k33", "--out", plain_file]):
            with self.subTest(arguments):
                done = run("tables", *arguments)
                self.assertEqual(done.returncode, BAD_INPUT, done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertTrue(done.stderr.startswith("gcsbench: "), done.stderr)


class Report(WithFolder):
    def test_rebuilds_what_tables_wrote(self):
        measured = self.measure()
        before = contents(self.folder, TABLE_FILES)
        for name in TABLE_FILES:
            (self.folder / name).unlink()
        done = run("report", self.folder, "--format", "md,csv,tex")
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertEqual(done.stdout, measured.stdout)
        self.assertEqual(contents(self.folder, TABLE_FILES), before)

    def test_rebuilds_the_figure(self):
        run("tables", "hoffmann-yuan", "--repetitions", 3, "--out", self.folder)
        figure = self.folder / "hoffmann-yuan-curve.svg"
        before = figure.read_bytes()
        figure.unlink()
        self.assertEqual(run("report", self.folder).returncode, DONE)
        self.assertEqual(figure.read_bytes(), before)

    def test_figures_of_instances(self):
        self.measure()
        self.assertEqual(run("report", self.folder, "--format", "svg").returncode, DONE)
        figures = {path.stem for path in self.folder.glob("*.svg")}
        self.assertEqual(figures, {"graph-octahedron", "tree-octahedron", "path-octahedron"})
        for figure in self.folder.glob("*.svg"):
            xml.etree.ElementTree.parse(figure)

    def test_page_of_several_runs(self):
        self.measure()
        other = self.folder / "other"
        run("tables", "table1", "--instances", "k33", "--strategies", "full-space", "--repetitions", 3, "--out", other)
        page = self.folder / "new" / "report.html"
        done = run("report", self.folder, other, "--format", "html", "--out", page.parent)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertEqual([path.name for path in page.parent.iterdir()], ["report.html"])
        text = page.read_text()
        for instance in ("octahedron", "k33"):
            self.assertEqual(text.count(f'id="scene-{instance}"'), 1)

    def test_pages_of_two_instances_by_one_name(self):
        self.measure()
        longer = self.folder / "octahedron.json"
        instance = json.loads((SOURCE / "instances" / "octahedron.json").read_text())
        instance["constraints"][0]["length"] *= 1.01
        longer.write_text(json.dumps(instance))
        other = self.folder / "other"
        done = run("tables", "table1", "--instances", longer, "--strategies", "full-space", "--repetitions", 3, "--out",
                   other)
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertNotRegex(done.stdout, r"\| +72 \[", "what the paper prints of the shipped octahedron")
        self.assertIn("octahedron: not the shipped instance", done.stdout)
        done = run("report", self.folder, other)
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
        self.assertIn("'octahedron'", done.stderr)

    def test_broken_scenes_change_nothing(self):
        self.measure()
        before = {path.name for path in self.folder.iterdir()}
        scene, path = self.folder / "scenes/octahedron.json", self.folder / "paths/octahedron.json"
        backwards = '"rows": [\n[0, 9e9' + ", 0" * 13 + "],\n"  # t, length, radius and 12 moving coordinates
        for file, old, new in (
                (scene, '{"format"', '{"format'),
                (scene, "gcsbench-scene/1", "gcsbench-scene/9"),
                (scene, '"crossings": [', '"crossings": 7, "was": ['),
                (scene, '"solution": 0', '"solution": 99'),
                (scene, '"signs": [1', '"signs": [0'),
                (path, '"id": "octahedron"', '"id": "another"'),
                (path, '"crossings": [', '"crossings": [], "was": ['),
                (path, '"radius"', '"radium"'),
                (path, '"p4.x"', '"p9.x"'),
                (path, '"rows": [\n', backwards)):
            with self.subTest(file=file.parent.name, new=new):
                good = file.read_text()
                self.assertIn(old, good)
                file.write_text(good.replace(old, new, 1))
                done = run("report", self.folder)
                file.write_text(good)
                self.assertEqual(done.returncode, BAD_INPUT, done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertTrue(done.stderr.startswith(f"gcsbench: {file}"), done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1)
                self.assertEqual({entry.name for entry in self.folder.iterdir()}, before)

    def test_a_run_is_named_from_within_its_folder(self):
        self.measure()
        done = run("report", "run.json", "--format", "md", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))

    def test_formats_and_folder(self):
        self.measure()
        out = self.folder / "new" / "folder"
        self.assertEqual(run("report", self.folder / "run.json", "--format", "csv", "--out", out).returncode, DONE)
        self.assertEqual({path.name for path in out.iterdir()}, {"table1.csv", "measurements.csv", "verdicts.csv"})

    def test_bad_input(self):
        self.measure()
        for arguments in ([self.folder, "--format", "docx"], [self.folder / "nothing"],
                          [self.folder, self.folder, "--out", self.folder], []):
            with self.subTest(arguments):
                done = run("report", *arguments)
                self.assertEqual(done.returncode, BAD_INPUT)
                self.assertEqual(done.stdout, "")
                self.assertTrue(done.stderr.startswith("gcsbench: "), done.stderr)


if __name__ == "__main__":
    command_line.main()
