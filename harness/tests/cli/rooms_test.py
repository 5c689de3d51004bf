#!/usr/bin/python3
"""The picture of the rooms shows what the build says of them: drawn anew after every change, by scripts/draw-rooms.

Usage: rooms_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import html
import re
import unittest
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE


class Rooms(unittest.TestCase):
    def test_the_picture_shows_what_each_room_uses(self):
        said = (Path(PROGRAM).parent.parent / "rooms.dot").read_text(encoding="utf-8")
        drawn = html.unescape((SOURCE / "solvers/rooms.svg").read_text(encoding="utf-8"))
        uses = re.findall(r'"([\w/]+)" -> "([\w/]+)"', said)
        self.assertGreater(len(uses), 30)
        self.assertEqual(sorted(re.findall(r"<title>([\w/]+)->([\w/]+)</title>", drawn)), sorted(uses))


if __name__ == "__main__":
    command_line.main()
