#!/usr/bin/python3
"""No two files define the same name in one namespace: the one-definition rule, which no compiler checks across files.
All rooms share a namespace, so that the name of a type, a concept, an inline variable, or an inline function or
template with its parameters is its own in the whole project. Of other functions and variables the linker sees to it.

Usage: definitions_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import re
import unittest
from collections import defaultdict

import command_line
from command_line import sources

NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
TYPE = re.compile(r"\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(\w+)\s*(?:final\s*)?(?::[^:].*)?$", re.DOTALL)
ALIAS = re.compile(r"\b(?:using|concept)\s+(\w+)\s*=[^;{}]*$")
SHARED = re.compile(r"\b(?:inline|constexpr|template)\b")
FUNCTION = re.compile(r"\b(?!requires\b)(\w+)\s*\(((?:[^()]|\([^()]*\))*)\)\s*(?:noexcept\b.*|requires\b.*|->.*)?$", re.DOTALL)
VARIABLE = re.compile(r"\binline\s+[^;({]*?(\w+)\s*(?:=.*)?$", re.DOTALL)
NAMESPACE = re.compile(r"\bnamespace\s*([\w:]*)\s*$")


def shared_function(statement):
    """The name of an inline function or a template with its parameters' types, or None."""
    found = FUNCTION.search(statement) if SHARED.search(statement) else None
    if not found:
        return None
    types = [re.sub(r"\s+\w+\s*(=.*)?$", "", parameter.strip(), flags=re.DOTALL)
             for parameter in re.split(r",(?![^<]*>)", found[2])]
    return f"{found[1]}({', '.join(types)})"


def defined(statement, part):
    """What the statement before a brace or a semicolon defines that other files could define too, or None."""
    found = TYPE.search(statement) if part == "{" else ALIAS.search(statement)
    found = found or (VARIABLE.search(statement) if "(" not in statement.split("=")[0] else None)
    return found[1] if found else shared_function(statement) if part == "{" else None


def definitions(text):
    """(namespace, name) of what stands in no anonymous namespace, class or function."""
    scopes, statement = [], ""
    for part in re.split(r"([{};])", re.sub(r"^\s*#.*$", "", NOISE.sub(" ", text), flags=re.MULTILINE)):
        if part == "{":
            namespace = NAMESPACE.search(statement)
            name = defined(statement, part)
            if name and None not in scopes and scopes:
                yield "::".join(scopes), name
            scopes.append(namespace[1] or None if namespace else None)
            statement = ""
        elif part == "}":
            scopes.pop()
            statement = ""
        elif part == ";":
            name = defined(statement, part)
            if name and None not in scopes and scopes:
                yield "::".join(scopes), name
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


class Definitions(unittest.TestCase):
    def test_every_name_is_defined_once(self):
        files = list(sources())
        self.assertGreater(sum(len(list(definitions(text))) for _, text in files), 600)
        self.assertEqual(twice(files), {})

    def test_a_second_definition_is_found(self):
        first = "namespace gcs {\n/// struct Other {\ntemplate <int n>\nstruct Cell : Base<n> { int a; };\n}"
        for second in ("namespace gcs { class Cell final { struct Inner {}; }; }", "namespace gcs { using Cell = int; }",
                       "namespace gcs { enum class Cell { a }; }"):
            self.assertEqual(twice([("a.hpp", first), ("b.cpp", second)]), {"gcs::Cell": ["a.hpp", "b.cpp"]}, second)

    def test_a_second_function_or_variable_is_found(self):
        first = ("namespace gcs {\ninline double area(const Cell& cell, int sides = 2) { return f(1); }\n"
                 "inline constexpr double limit = 3;\n}")
        for second, name in (("inline double area(const Cell& of, int n) noexcept { return 2; }", "area(const Cell&, int)"),
                             ("template <int n> void area(const Cell& of, int) {}", "area(const Cell&, int)"),
                             ("inline constexpr int limit{4};", "limit"), ("enum limit { low };", "limit")):
            self.assertEqual(twice([("a.hpp", first), ("b.hpp", "namespace gcs { " + second + " }")]),
                             {"gcs::" + name: ["a.hpp", "b.hpp"]}, second)
        overload = "namespace gcs { inline double area(const Cell& cell) { return 1; } }"
        self.assertEqual(twice([("a.hpp", first), ("b.hpp", overload)]), {})

    def test_what_is_a_files_own_is_left_alone(self):
        own = ("namespace gcs { namespace { struct Cell { int a; }; } struct Outer%s { struct Cell {}; };\n"
               "void f%s() { struct Cell {}; } struct Cell; constexpr const char* s = \"struct Cell {\"; }")
        self.assertEqual(twice([("a.cpp", own % (1, 1)), ("b.cpp", own % (2, 2))]), {})


if __name__ == "__main__":
    command_line.main()
