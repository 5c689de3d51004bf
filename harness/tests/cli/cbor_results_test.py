#!/usr/bin/python3
"""Results as CBOR: what they say is what the JSON says, and every command reads either.

Usage: cbor_results_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import json
import random

import cbor
import command_line
from command_line import BAD_INPUT, CHECK_FAILED, DONE, NOT_SOLVED, run


def comparable(value):
    """What a reader of JSON finds, with numbers as doubles, and as texts where they are kept as such."""
    if isinstance(value, dict):
        return {key: comparable(member) for key, member in value.items() if key not in ("timing", "environment")}
    if isinstance(value, list):
        return [comparable(element) for element in value]
    return float(value) if isinstance(value, cbor.Number) or type(value) is int else value


def texts_of_numbers(value):
    """The decimal texts of numbers that are kept as such, in order."""
    if isinstance(value, (dict, list)):
        parts = value.values() if isinstance(value, dict) else value
        return [text for part in parts for text in texts_of_numbers(part)]
    return [str(value)] if isinstance(value, cbor.Number) else []


class CborResults(command_line.CommandLine):
    def solved(self, *solve):
        """The same result in both forms."""
        files = self.folder / "result.json", self.folder / "result.cbor"
        for file in files:
            done = run("solve", *solve, "--out", file)
            self.assertEqual(done.returncode, DONE, done.stderr)
        return files

    def test_they_say_what_the_json_says(self):
        for solve in [("disulfide", "--strategy", "monodromy", "--certify"), ("disulfide", "--strategy", "explore"),
                      ("short-edge@1e-8", "--strategy", "full-space"), ("hoffmann-yuan", "--strategy", "theta-scan")]:
            with self.subTest(solve):
                text, binary = self.solved(*solve)
                said, kept = json.loads(text.read_text()), cbor.loads(binary.read_bytes())
                self.assertEqual(list(kept), list(said))
                self.assertEqual(comparable(kept), comparable(said))
                self.assertLess(binary.stat().st_size, text.stat().st_size)

    def test_lengths_keep_their_digits(self):
        toy = {"format": "gcsbench-instance/1", "id": "toy", "dimension": 2, "points": ["a", "b", "c"],
               "constraints": [{"id": name, "type": "distance", "between": list(name), "length": 1}
                               for name in ("ab", "bc", "ca")]}
        lengths = ["3.00", "4.0000000000000000000000000000001", "5e0"]
        text = json.dumps(toy)
        for length in lengths:
            text = text.replace('"length": 1', f'"length": {length}', 1)
        _, binary = self.solved(self.write(text), "--strategy", "monodromy")
        self.assertEqual(texts_of_numbers(cbor.loads(binary.read_bytes())["instance"]), lengths)
        self.assertEqual(run("verify", binary).returncode, DONE)

    def test_commands_read_either(self):
        text, binary = self.solved("disulfide", "--strategy", "full-space", "--certify")
        reference = self.folder / "reference.json"
        for command in (["verify"], ["reference", "--out", reference],
                        ["follow", "disulfide", "--to", "a7=3.3", "--from"]):
            answers = []
            for file in (text, binary):
                done = run(*command, f"{file}:2" if command[0] == "follow" else file)
                answers.append((done.returncode, done.stdout.replace(file.name, ""),
                                reference.exists() and reference.read_text()))
            with self.subTest(command):
                self.assertEqual(answers[0], answers[1])
                self.assertEqual(answers[0][0], DONE)

    def test_either_is_converted_into_the_other_byte_for_byte(self):
        for solve in [("disulfide", "--strategy", "explore"), ("k33", "--strategy", "monodromy", "--certify")]:
            text, _ = self.solved(*solve)
            converted, back = self.folder / "converted.cbor", self.folder / "back.json"
            self.assertEqual(run("convert", text, "--out", converted).returncode, DONE)
            self.assertEqual(run("convert", converted, "--out", back).returncode, DONE)
            self.assertEqual(back.read_bytes(), text.read_bytes())
            self.assertEqual(run("convert", converted).stdout.encode(), text.read_bytes())
            self.assertEqual(comparable(cbor.loads(converted.read_bytes())), comparable(json.loads(text.read_text())))
        for content in ("{}", "[1]", '{"format": "gcsbench-run/1"}'):
            self.assert_one_message(run("convert", self.write(content, "other.json")), BAD_INPUT, "other.json")

    def test_an_external_program_may_write_them(self):
        text, binary = self.solved("octahedron", "--strategy", "cayley-menger")
        lists = [json.loads(run("solve", "octahedron", "--strategy", f"exec:cat {file}", "--out", "-").stdout)["solutions"]
                 for file in (text, binary)]
        self.assertEqual(len(lists[0]), len(json.loads(text.read_text())["solutions"]))
        self.assertEqual(lists[0], lists[1])

    def test_what_is_cut_off_or_damaged_gets_one_message(self):
        _, binary = self.solved("k33", "--strategy", "rcp")
        data = binary.read_bytes()
        dice = random.Random(5)
        for length in dice.sample(range(1, len(data)), 20):
            binary.write_bytes(data[:length])
            self.assert_one_message(run("verify", binary), BAD_INPUT, binary, "not CBOR")
        for _ in range(40):
            place = dice.randrange(1, len(data))
            binary.write_bytes(data[:place] + dice.randbytes(1) + data[place + 1:])
            done = run("verify", binary)
            self.assertIn(done.returncode, (DONE, CHECK_FAILED, BAD_INPUT, NOT_SOLVED), done.stderr)
            if done.returncode == BAD_INPUT:
                self.assert_one_message(done, BAD_INPUT)
        for nonsense in (b"\xa0", b"\xbf\xff", b"\x80", b"\x00" * 9):
            binary.write_bytes(nonsense)
            self.assert_one_message(run("verify", binary), BAD_INPUT, binary)


if __name__ == "__main__":
    command_line.main()
