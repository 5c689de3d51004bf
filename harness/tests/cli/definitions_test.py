#!/usr/bin/python3
"""No two files define a type of the same name in one namespace: the one-definition rule, which no compiler checks across
files. All rooms share a namespace, so that a type's name is its own in the whole project.

Usage: definitions_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import re
import unittest
from collections import defaultdict

import command_line
from command_line import SOURCE

NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
TYPE = re.compile(r"\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(\w+)\s*(?:final\s*)?(?::[^:].*)?$", re.DOTALL)
ALIAS = re.compile(r"\busing\s+(\w+)\s*=[^;{}]*$")
NAMESPACE = re.compile(r"\bnamespace\s*([\w:]*)\s*$")


def definitions(text):
    """(namespace, name) of the types and aliases that stand in no anonymous namespace, class or function."""
    scopes, statement = [], ""
    for part in re.split(r"([{};])", re.sub(r"^\s*#.*$", "", NOISE.sub(" ", text), flags=re.MULTILINE)):
        if part == "{":
            namespace = NAMESPACE.search(statement)
            found = TYPE.search(statement)
            if found and None not in scopes:
                yield "::".join(scopes), found[1]
            scopes.append(namespace[1] or None if namespace else None)
            statement = ""
        elif part == "}":
            scopes.pop()
            statement = ""
        elif part == ";":
            found = ALIAS.search(statement)
            if found and None not in scopes and scopes:
                yield "::".join(scopes), found[1]
            statement = ""
        else:
            statement += part


def twice(files):
    """Where each type stands that more than one of the (name, text) defines."""
    places = defaultdict(set)
    for name, text in files:
        for definition in definitions(text):
            places[definition].add(name)
    return {"::".join(key): sorted(where) for key, where in places.items() if len(where) > 1}


def sources():
    for house in ("solvers", "harness"):
        for path in sorted((SOURCE / house).rglob("*.[ch]pp")):
            if not {"tests", "fuzz", "benchmarks"} & set(path.relative_to(SOURCE).parts):
                yield str(path.relative_to(SOURCE)), path.read_text(encoding="utf-8")


class Definitions(unittest.TestCase):
    def test_every_type_is_defined_once(self):
        files = list(sources())
        self.assertGreater(sum(len(list(definitions(text))) for _, text in files), 300)
        self.assertEqual(twice(files), {})

    def test_a_second_definition_is_found(self):
        first = "namespace gcs {\n/// struct Other {\ntemplate <int n>\nstruct Cell : Base<n> { int a; };\n}"
        for second in ("namespace gcs { class Cell final { struct Inner {}; }; }", "namespace gcs { using Cell = int; }",
                       "namespace gcs { enum class Cell { a }; }"):
            self.assertEqual(twice([("a.hpp", first), ("b.cpp", second)]), {"gcs::Cell": ["a.hpp", "b.cpp"]}, second)

    def test_what_is_a_files_own_is_left_alone(self):
        own = ("namespace gcs { namespace { struct Cell { int a; }; } struct Outer%s { struct Cell {}; };\n"
               "void f%s() { struct Cell {}; } struct Cell; inline constexpr const char* s = \"struct Cell {\"; }")
        self.assertEqual(twice([("a.cpp", own % (1, 1)), ("b.cpp", own % (2, 2))]), {})


if __name__ == "__main__":
    command_line.main()
