#!/usr/bin/python3
"""What shells and man show of the program.

Usage: shells_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import shutil
import subprocess
import unittest
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE


def run(*arguments):
    return command_line.run(*arguments).stdout


def completed(*words):
    return run("complete", "--", *words).splitlines()


def names(kind, member):
    return sorted(one[member] for one in json.loads(run("list", kind, "--json"))[kind])


class Completion(unittest.TestCase):
    def test_commands(self):
        self.assertEqual(completed("sol"), ["solve"])
        self.assertIn("tables", completed(""))
        self.assertNotIn("complete", completed(""))
        self.assertEqual(completed("--ver"), ["--version"])

    def test_names(self):
        self.assertEqual(completed("solve", "octahedron", "--strategy", ""), names("strategies", "name"))
        self.assertLessEqual(set(names("instances", "id")), set(completed("describe", "")))
        self.assertIn("short-edge@1e-8", completed("describe", "short-edge@"))
        self.assertIn("flat-triangle", completed("stability", "flat"))

    def test_options_and_their_values(self):
        self.assertEqual(completed("solve", "k33", "--certi"), ["--certificate", "--certify"])
        self.assertEqual(completed("solve", "k33", "--solutions", ""), ["all", "real"])
        self.assertEqual(completed("tables", "table1", "--instances", "k33,disul"), ["k33,disulfide"])
        chosen = ["solve", "k33", "--strategy", "rcp", "--set"]
        self.assertEqual(completed(*chosen, "mod"), ["mode="])
        self.assertEqual(completed(*chosen, "mode=p"), ["mode=paper"])

    def test_nothing_fits(self):
        self.assertEqual(completed("no-such-command-at-all"), [])
        self.assertEqual(completed("solve", "k33", "--seed", ""), [])

    def in_bash(self, line):
        script = f"""
            PATH={Path(PROGRAM).parent}:$PATH
            source {SOURCE}/harness/cli/shells/gcsbench.bash
            compopt() {{ :; }}
            COMP_LINE={json.dumps(line)} COMP_POINT={len(line)}
            IFS=' ' read -ra COMP_WORDS <<<"$(sed 's/[=@]/ & /g' <<<"$COMP_LINE")"
            [[ "$COMP_LINE" == *" " ]] && COMP_WORDS+=("")
            COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
            _gcsbench
            printf '%s\\n' "${{COMPREPLY[@]}}"
        """
        return subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=60, cwd=SOURCE,
                              check=True).stdout.split()

    def test_bash(self):
        self.assertEqual(self.in_bash("gcsbench descr"), ["describe"])
        self.assertEqual(self.in_bash("gcsbench solve k33 --strategy monod"), ["monodromy"])
        # Bash replaces what stands after = and @ alone.
        self.assertEqual(self.in_bash("gcsbench solve k33 --strategy rcp --set mode="),
                         ["fast", "newton", "paper"])
        self.assertIn("1e-8", self.in_bash("gcsbench describe short-edge@1e-"))


class Manual(unittest.TestCase):
    def test_it_shows_every_command_and_option(self):
        page = run("manual")
        shown = page.replace("\\-", "-")
        for command in completed(""):
            if command.startswith("--"):
                continue
            self.assertIn(f".SS gcsbench {command}\n", shown)
            for word in completed(command, "--"):
                self.assertIn(f".B {word}", shown)

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_it_is_set_without_a_warning(self):
        done = subprocess.run(["groff", "-k", "-man", "-Tutf8", "-ww"], input=run("manual"), capture_output=True, text=True,
                              timeout=60, check=True)
        self.assertEqual(done.stderr, "")
        self.assertIn("User Commands", done.stdout)


if __name__ == "__main__":
    command_line.main()
