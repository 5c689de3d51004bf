#!/usr/bin/python3
"""The program from outside: exit codes, what goes to which stream, and every kind of bad input.

Usage: command_line_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import command_line
from bad_instances import BAD_FILES, TOY, changed, with_constraint
from command_line import BAD_INPUT, DONE, NOT_SOLVED, SOURCE, argv, run


class BadFiles(command_line.CommandLine):
    def test_content(self):
        for name, (content, pointer) in BAD_FILES.items():
            with self.subTest(name):
                path = self.write(content)
                done = run("describe", path)
                self.assert_one_message(done, BAD_INPUT, path, pointer)

    def test_the_same_message_from_solve(self):
        path = self.write(with_constraint(2, length=-5))
        done = run("solve", path, "--strategy", "full-space", "--out", self.folder / "out.json")
        self.assert_one_message(done, BAD_INPUT, path, "/constraints/2/length")
        self.assertFalse((self.folder / "out.json").exists())

    def test_standard_input(self):
        self.assert_one_message(run("describe", "-", text_in="{"), BAD_INPUT)
        self.assertEqual(run("describe", "-", text_in=json.dumps(changed(id="other"))).returncode, DONE)

    def test_missing_file(self):
        self.assert_one_message(run("describe", self.folder / "none.json"), BAD_INPUT, "none.json")

    def test_directory(self):
        self.assert_one_message(run("describe", str(self.folder) + "/"), BAD_INPUT, self.folder)

    def test_unknown_id(self):
        self.assert_one_message(run("describe", "disulfid"), BAD_INPUT, "disulfide")


class Usage(command_line.CommandLine):
    def test_errors(self):
        solve = ["solve", "octahedron", "--strategy", "full-space"]
        cases = {
            "nothing": ([], ""),
            "unknown command": (["solv", "octahedron"], "did you mean 'solve'"),
            "flag without a command": (["--jsn"], "--jsn"),
            "unknown flag": (["list", "--jsn"], "--jsn"),
            "unknown thing to list": (["list", "problems"], "problems"),
            "no instance": (["solve", "--strategy", "full-space"], "INSTANCE"),
            "no strategy": (["solve", "octahedron"], "--strategy"),
            "two instances": (["describe", "octahedron", "k33"], "k33"),
            "unknown strategy": (["solve", "octahedron", "--strategy", "fullspace"], "did you mean 'full-space'"),
            "unknown option": (solve + ["--set", "ordr=8"], "did you mean 'order'"),
            "option without value": (solve + ["--set", "order"], "option=value"),
            "option without name": (solve + ["--set", "=8"], "option=value"),
            "option twice": (solve + ["--set", "order=8", "--set", "order=9"], "twice"),
            "negative seed": (solve + ["--seed", "-1"], "--seed"),
            "fractional seed": (solve + ["--seed", "1.5"], "--seed"),
            "seed beyond 64 bits": (solve + ["--seed", "18446744073709551616"], "--seed"),
            "no threads": (solve + ["--threads", "0"], "--threads"),
            "no time": (solve + ["--time-limit", "0"], "--time-limit"),
            "negative time": (solve + ["--time-limit", "-1"], "--time-limit"),
            "time that is no number": (solve + ["--time-limit", "nan"], "--time-limit"),
            "endless time": (solve + ["--time-limit", "inf"], "--time-limit"),
            "no solutions": (solve + ["--max-solutions", "0"], "--max-solutions"),
            "other solutions": (solve + ["--solutions", "some"], "--solutions"),
            "misspelt option that is required": (["solve", "octahedron", "--stategy", "rcp"], "did you mean --strategy"),
            "seed that is no number": (solve + ["--seed", "0x10"], "whole number"),
            "option for a file's name": (solve + ["--out", "--certify"], "./--certify"),
            "empty file's name": (solve + ["--out", ""], "--out"),
            "empty journal's name": (["solve", "octahedron", "--strategy", "monodromy", "--resume", ""], "--resume"),
            "folder like an option": (["tables", "table1", "--out", "--resume"], "--out"),
            "nothing to measure": (["tables", "table1", "--strategies", "theta-scan", "--instances", "octahedron"],
                                   "nothing to measure"),
        }
        for name, (arguments, mentioned) in cases.items():
            with self.subTest(name):
                self.assert_usage_error(run(*arguments), mentioned)

    def test_numbers_are_decimal(self):
        for given, seed in [("010", 10), ("08", 8), ("1", 1)]:
            done = run("solve", "k33", "--strategy", "rcp", "--seed", given, "--out", "-")
            self.assertEqual(json.loads(done.stdout)["seed"], seed)
        self.assertEqual(run("solve", "k33", "--strategy", "rcp", "--time-limit", "010").returncode, DONE)

    def test_names_after_a_list_are_no_part_of_it(self):
        done = run("precision", "--strategies", "rcp", "no-such")
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("no shipped instance", done.stderr)

    def test_option_value(self):
        for value in ["fast", "", "1e999", "-3", "nan"]:
            with self.subTest(value):
                done = run("solve", "octahedron", "--strategy", "full-space", "--set", "order=" + value)
                self.assert_one_message(done, BAD_INPUT, "order=" + value)

    def test_help_and_version(self):
        for arguments in [["--help"], ["--version"], ["list", "--help"], ["describe", "--help"], ["count", "--help"],
                          ["solve", "--help"]]:
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual(done.returncode, DONE)
                self.assertEqual(done.stderr, "")
                self.assertIn("gcsbench", done.stdout)
        self.assertIn("Examples:", run("solve", "--help").stdout)


class ListAndDescribe(command_line.CommandLine):
    def test_list(self):
        text = run("list").stdout
        data = json.loads(run("list", "--json").stdout)
        self.assertEqual(sorted(data), ["families", "instances", "left_out", "strategies"])
        for one in data["families"]:
            self.assertIn(one["name"], text)
        for one in data["instances"]:
            self.assertIn(one["id"], text)
        for one in data["strategies"]:
            self.assertIn(one["name"], text)
        ids = [path.stem for path in (SOURCE / "instances").glob("*.json") if path.stem != "schema"]
        self.assertEqual([one["id"] for one in data["instances"]], sorted(ids))

    def test_list_one_kind_one_line_each(self):
        for what in ["instances", "families", "strategies"]:
            data = json.loads(run("list", what, "--json").stdout)
            self.assertEqual(list(data), [what])
            lines = run("list", what).stdout.splitlines()
            present = [line for line in lines if not line.startswith("off in this build: ")]
            self.assertEqual(len(present), len(data[what]))

    def test_what_cannot_be_read_is_named_and_the_rest_listed(self):
        (self.folder / "instances").mkdir()
        self.write("{", "instances/broken.json")
        done = run("list", cwd=self.folder)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("instances/broken.json", done.stderr)
        self.assertIn("\noctahedron ", done.stdout)
        self.assertIn("\nplan-scan ", done.stdout)

    def test_members_of_families_are_instances(self):
        for one in json.loads(run("list", "families", "--json").stdout)["families"]:
            self.assertEqual(run("describe", one["members"][0]).returncode, DONE, one["name"])

    def test_every_shipped_instance_is_described(self):
        for one in json.loads(run("list", "instances", "--json").stdout)["instances"]:
            with self.subTest(one["id"]):
                done = run("describe", one["id"], "--json")
                self.assertEqual((done.returncode, done.stderr), (DONE, ""))
                data = json.loads(done.stdout)
                self.assertTrue(data["degrees_of_freedom"]["rigid"])
                freedom = data["degrees_of_freedom"]
                equations = freedom.get("equations", one["constraints"])  # general scenes have further ones
                self.assertEqual(freedom["unknowns"], equations)
                self.assertIn(one["title"], run("describe", one["id"]).stdout)

    def test_core(self):
        data = json.loads(run("describe", self.write(TOY), "--json").stdout)["core"]
        self.assertTrue(data["trivial"])
        self.assertEqual(data["entities"], ["p1", "p2"])
        self.assertEqual(sorted(one["place"] for one in data["placed"]), ["p3", "p4"])
        data = json.loads(run("describe", "octahedron", "--json").stdout)["core"]
        self.assertFalse(data["trivial"])
        self.assertEqual(data["placed"], [])

    def test_construction_plan(self):
        plan = json.loads(run("describe", "disulfide", "--json").stdout)["construction"]
        self.assertEqual(plan["driving_parameters"], 1)
        self.assertEqual(len(plan["removed"]), 1)
        self.assertEqual(len(plan["instructions"]), 8)
        self.assertIsNone(json.loads(run("describe", "prism", "--json").stdout)["construction"])

    def test_interpretation_tree(self):
        hostile = self.write(json.dumps(TOY).replace('"p1"', json.dumps("<&\"'>")))
        for instance in ("qk33", "k33", "octahedron", hostile):
            with self.subTest(instance):
                done = run("describe", instance, "--tree", "-")
                self.assertEqual((done.returncode, done.stderr), (DONE, ""))
                self.assertTrue(ElementTree.fromstring(done.stdout).tag.endswith("svg"))
                file = self.folder / "tree.svg"
                self.assertEqual(run("describe", instance, "--tree", file).stdout, "")
                self.assertEqual(file.read_text(encoding="utf-8"), done.stdout)

    def test_no_interpretation_tree(self):
        out = self.folder / "tree.svg"
        for instance, why in {"prism": "sketch", "hoffmann-yuan": "lines", "dodecagon": "10 times"}.items():
            self.assert_one_message(run("describe", instance, "--tree", out), NOT_SOLVED, why)
        toy = self.write(TOY)
        self.assert_usage_error(run("describe", toy, "--tree", toy), "toy.json")
        self.assert_usage_error(run("describe", toy, "--tree", out, "--json"), "--json")
        self.assert_one_message(run("describe", toy, "--tree", self.folder / "none" / "tree.svg"), BAD_INPUT, "tree.svg")
        self.assertFalse(out.exists())
        self.assertEqual(json.loads(toy.read_text()), TOY)

    def test_where_lengths_are_positive(self):
        # 5 + t + 4t(1 - t) vanishes at (5 ± √105)/8, and nothing else between. All lengths grow: the second one, from
        # √13 to 5, is the first to vanish for falling t.
        ends = {'{"a1": [4]}': [(5 - 105**0.5) / 8, (5 + 105**0.5) / 8], "{}": [-13**0.5 / (5 - 13**0.5), None]}
        for bends, expected in ends.items():
            file = self.write(changed(interpolation={"bends": json.loads(bends)}))
            data = json.loads(run("describe", file, "--json").stdout)["interpolation"]
            self.assertEqual(data["bends"], json.loads(bends))
            self.assertEqual(data["compact"], None not in expected)
            for end, there in zip(data["positive_support"], expected):
                self.assertEqual(end is None, there is None)
                if there is not None:
                    self.assertAlmostEqual(end, there, delta=1e-12)
            text = run("describe", file).stdout
            self.assertIn("S closes where it is regular" if data["compact"] else "S may run off to infinity", text)
        self.assertIn("a5 is bent by 2, the other lengths", run("describe", self.write(TOY)).stdout)

    def test_why_a_strategy_does_not_apply(self):
        data = json.loads(run("describe", self.write(changed(sketch=None)), "--json").stdout)
        verdict = {one["name"]: one for one in data["strategies"]}["full-space"]
        self.assertFalse(verdict["applies"])
        self.assertIn("sketch", verdict["why_not"])

    def test_ids_are_found_from_anywhere(self):
        self.assertEqual(run("describe", "octahedron", cwd=self.folder).returncode, DONE)


class Output(command_line.CommandLine):
    SOLVE = ["solve", "octahedron", "--strategy", "full-space", "--out"]

    def test_unwritable(self):
        for place in [self.folder / "none" / "result.json", self.folder, "/proc/result.json"]:
            with self.subTest(place):
                self.assert_one_message(run(*self.SOLVE, place), BAD_INPUT, place, "cannot be written")

    def test_a_failure_leaves_the_old_file(self):
        out = self.write("old", "result.json")
        run("solve", self.write("{"), "--strategy", "full-space", "--out", out)
        self.assertEqual(out.read_text(), "old")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["result.json", "toy.json"])

    def test_an_old_file_is_replaced_and_a_link_kept(self):
        out = self.write("old", "result.json")
        link = self.folder / "link.json"
        link.symlink_to(out)
        self.assertEqual(run(*self.SOLVE, link).returncode, DONE)
        self.assertTrue(link.is_symlink())
        self.assertEqual(json.loads(out.read_text())["status"], "complete")

    def test_a_device_stays_a_device(self):
        self.assertEqual(run(*self.SOLVE, "/dev/null").returncode, DONE)
        self.assertTrue(Path("/dev/null").is_char_device())

    def test_a_full_disk(self):
        self.assertEqual(run(*self.SOLVE, "/dev/full").returncode, BAD_INPUT)
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run(argv(*self.SOLVE, "-"), stdout=full, stderr=subprocess.PIPE, text=True,
                                  cwd=SOURCE, check=False)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("standard output", done.stderr)

    def test_replaces_nothing_that_the_run_uses(self):
        mine = self.write(TOY)
        before = mine.read_text()
        for command in (["solve", mine, "--strategy", "rcp"], ["path", mine]):
            with self.subTest(command):
                self.assert_usage_error(run(*command, "--out", mine), "would replace")
                self.assertEqual(mine.read_text(), before)
        journal = self.folder / "journal"
        self.assert_usage_error(run("solve", "octahedron", "--strategy", "monodromy", "--resume", journal, "--out", journal),
                                "would replace")
        self.assertFalse(journal.exists())

    def test_dash_is_standard_output_everywhere(self):
        path = run("path", "k33", "--out", "-")
        self.assertEqual(json.loads(path.stdout)["format"], "gcsbench-path/1")
        result = run("solve", "octahedron", "--strategy", "cayley-menger", "--out", "-").stdout
        reference = run("reference", "-", "--out", "-", text_in=result)
        self.assertEqual(json.loads(reference.stdout)["format"], "gcsbench-reference/1")


if __name__ == "__main__":
    command_line.main()
