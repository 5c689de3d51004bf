#!/usr/bin/python3
"""The picture of the rooms shows what the build says of them: drawn anew after every change, by scripts/draw-rooms.
No stem, a source with its header, needs itself through others: the build sees to it between rooms, this within them.

Usage: rooms_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import html
import re
import unittest
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import command_line
from command_line import PROGRAM, SOURCE, sources

INCLUDE = re.compile(r'^#include "([\w/]+)\.hpp"', re.MULTILINE)


def circle(files):
    """Stems of the (name, text) each of which includes the next, the first again at the end; or none."""
    needed = {}
    for name, text in files:
        stem = name.rsplit(".", 1)[0]
        needed.setdefault(stem, set()).update(set(INCLUDE.findall(text)) - {stem})
    try:
        TopologicalSorter(needed).prepare()
    except CycleError as error:
        return error.args[1]
    return []


class Rooms(unittest.TestCase):
    def test_the_picture_shows_what_each_room_uses(self):
        said = (Path(PROGRAM).parent.parent / "rooms.dot").read_text(encoding="utf-8")
        drawn = html.unescape((SOURCE / "solvers/rooms.svg").read_text(encoding="utf-8"))
        uses = re.findall(r'"([\w/]+)" -> "([\w/]+)"', said)
        self.assertGreater(len(uses), 30)
        self.assertEqual(sorted(re.findall(r"<title>([\w/]+)->([\w/]+)</title>", drawn)), sorted(uses))

    def test_no_stem_needs_itself_through_others(self):
        files = list(sources())
        self.assertGreater(sum(len(INCLUDE.findall(text)) for _, text in files), 1000)
        self.assertEqual(circle(files), [])

    def test_a_circle_is_found(self):
        files = [("r/a.hpp", ""), ("r/a.cpp", '#include "r/a.hpp"\n#include "r/b.hpp"\n'),
                 ("r/b.hpp", '#include <map>\n#include "r/c.hpp"\n'), ("r/c.hpp", "")]
        self.assertEqual(circle(files), [])
        self.assertEqual(set(circle([*files, ("r/c.cpp", '#include "r/a.hpp"\n')])), {"r/a", "r/b", "r/c"})


if __name__ == "__main__":
    command_line.main()
