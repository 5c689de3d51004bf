"""Checks instances/schema.json: every shipped instance fits it, and broken ones do not.

Usage: schema_test.py FOLDER_OF_INSTANCES. Exit code 77 (skipped) without python3-jsonschema.
"""

import copy
import json
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

PLANE = {
    "format": "gcsbench-instance/1",
    "id": "plane",
    "dimension": 2,
    "points": ["p1", "p2", "p3"],
    "constraints": [
        {"id": "a1", "type": "distance", "between": ["p1", "p2"], "length": 3},
        {"type": "distance", "between": ["p1", "p3"], "squared": 16.0},
        {"type": "distance", "between": ["p2", "p3"], "length": 5},
    ],
    "reference": {"origin": "p1", "axis": "p2"},
    "sketch": {"p1": [0, 0], "p2": [2, 0], "p3": [0, 3]},
    "interpolation": {"bent": "a1", "bend": 2},
    "construction": [{"place": "p3", "from": [["p1", "a2"], ["p2", "k1"]]}],
    "published": [{"quantity": "real", "convention": "", "value": 2, "source": "Euclid"}],
}

SPACE = {
    "format": "gcsbench-instance/1",
    "id": "space",
    "dimension": 3,
    "points": ["p1"],
    "lines": ["L"],
    "constraints": [{"type": "distance", "between": ["L", "p1"], "length": 0}],
    "reference": {"line": "L", "height": "p1"},
    "sketch": {"p1": [0, 0, 0], "L": {"point": [1, 0, 0], "direction": [0, 1, 0]}},
}

BENT = {**PLANE, "id": "bent", "interpolation": {"bends": {"a1": [2, -0.5], "a3": []}}}

GENERAL = {
    "format": "gcsbench-instance/2",
    "id": "general",
    "dimension": 3,
    "points": [],
    "lines": ["L"],
    "planes": ["E"],
    "bodies": {
        "base": {"p1": [0, 0, 0], "p2": [1, 0, 0], "M": {"point": [0, 0, 1], "direction": [0, 1, 0]}},
        "top": {"p1": [0, 0, 0], "p3": [1, 0, 0], "p4": [0, 1, 0], "F": {"normal": [0, 0, 2], "offset": -1}},
    },
    "constraints": [
        {"type": "distance", "between": ["p2", "E"], "length": -2.5},
        {"id": "turn", "type": "angle", "between": [["p2", "p3"], "L"], "degrees": 30},
        {"type": "angle", "between": ["E", "F"], "cosine": -0.5},
        {"type": "meet", "between": ["L", "M"]},
        {"type": "parallel", "between": [["p1", "p2"], ["p3", "p4"]]},
        {"type": "collinear", "between": ["p2", "p3", "p4"]},
        {"type": "coplanar", "between": ["p1", "p2", "p3", "p4"]},
        {"type": "orientation", "of": ["p1", "p2", "p3", "p4"], "sign": -1},
    ],
    "reference": {"body": "top"},
    "sketch": {"E": {"normal": [0, 1, 0], "offset": 2}},
}

FLAT = {
    "format": "gcsbench-instance/2",
    "id": "flat",
    "dimension": 2,
    "points": ["p1"],
    "lines": ["L"],
    "bodies": {"base": {"p2": [0, 0], "M": {"point": [0, 1], "direction": [0, 1]}}},
    "fixed": {"L": {"point": [0, 0], "direction": [1, 0]}},
    "constraints": [],
}

REMOVED = object()

BROKEN = [
    (PLANE, ["sketh"], {}),
    (PLANE, ["format"], "gcsbench-instance/3"),
    (PLANE, ["format"], REMOVED),
    (PLANE, ["id"], "a/b"),
    (PLANE, ["dimension"], 4),
    (PLANE, ["points"], []),
    (PLANE, ["points", 2], "p1"),
    (PLANE, ["points", 2], ""),
    (PLANE, ["lines"], ["L"]),
    (PLANE, ["constraints"], []),
    (PLANE, ["constraints", 0, "type"], "angle"),
    (PLANE, ["constraints", 0, "lenght"], 3),
    (PLANE, ["constraints", 0, "squared"], 9),
    (PLANE, ["constraints", 0, "length"], REMOVED),
    (PLANE, ["constraints", 0, "length"], -1),
    (PLANE, ["constraints", 0, "length"], "3"),
    (PLANE, ["constraints", 0, "between"], ["p1"]),
    (PLANE, ["constraints", 0, "between"], ["p1", "p1"]),
    (PLANE, ["reference", "axis"], REMOVED),
    (PLANE, ["reference", "plane"], "p3"),
    (PLANE, ["reference", "line"], "L"),
    (PLANE, ["sketch", "p1"], [0, 0, 0]),
    (PLANE, ["sketch", "p1"], [0, "0"]),
    (PLANE, ["fixed"], {"p1": [0, 0, 0]}),
    (PLANE, ["interpolation", "bend"], 0),
    (BENT, ["interpolation", "bend"], 2),
    (BENT, ["interpolation", "bent"], "a1"),
    (BENT, ["interpolation", "bends", "a1"], 2),
    (BENT, ["interpolation", "bends", "a1"], ["2"]),
    (BENT, ["interpolation", "bends", "a1"], [1] * 17),
    (PLANE, ["construction", 0, "from", 0], ["p1"]),
    (PLANE, ["construction", 0, "place"], REMOVED),
    (PLANE, ["published", 0, "value"], "2"),
    (PLANE, ["published", 0, "source"], REMOVED),
    (SPACE, ["reference", "height"], REMOVED),
    (SPACE, ["reference", "origin"], "p1"),
    (SPACE, ["sketch", "p1"], [0, 0]),
    (SPACE, ["sketch", "L", "direction"], [0, 0, 0]),
    (SPACE, ["sketch", "L", "directon"], [0, 0, 1]),
    (SPACE, ["planes"], ["E"]),
    (SPACE, ["bodies"], {}),
    (SPACE, ["reference"], {"body": "b"}),
    (SPACE, ["constraints", 0], {"type": "on", "between": ["L", "p1"]}),
    (GENERAL, ["format"], "gcsbench-instance/1"),
    (GENERAL, ["dimension"], 2),
    (GENERAL, ["points"], REMOVED),
    (GENERAL, ["planes"], ["E", "E"]),
    (GENERAL, ["bodies", "base"], [0, 0, 0]),
    (GENERAL, ["bodies", "base", "p1"], [0, 0]),
    (GENERAL, ["bodies", "top", "F", "normal"], [0, 0, 0]),
    (GENERAL, ["bodies", "top", "F", "offset"], REMOVED),
    (GENERAL, ["bodies", "top", "F", "offset"], [1]),
    (GENERAL, ["constraints", 0, "length"], 0),
    (GENERAL, ["constraints", 0, "squared"], 4),
    (GENERAL, ["constraints", 0, "degrees"], 4),
    (GENERAL, ["constraints", 0, "between", 0], ["p1", "p2"]),
    (GENERAL, ["constraints", 1, "degrees"], 90),
    (GENERAL, ["constraints", 1, "degrees"], 180),
    (GENERAL, ["constraints", 1, "cosine"], 0.5),
    (GENERAL, ["constraints", 1, "between", 0], ["p1", "p2", "p3"]),
    (GENERAL, ["constraints", 2, "cosine"], 1),
    (GENERAL, ["constraints", 2, "cosine"], REMOVED),
    (GENERAL, ["constraints", 3, "type"], "meets"),
    (GENERAL, ["constraints", 3, "between"], ["L"]),
    (GENERAL, ["constraints", 3, "length"], 1),
    (GENERAL, ["constraints", 5, "between"], ["p2", "p3"]),
    (GENERAL, ["constraints", 6, "between"], ["p1", "p2", "p3"]),
    (GENERAL, ["constraints", 7, "of"], ["p1", "p2", "p3"]),
    (GENERAL, ["constraints", 7, "sign"], 0),
    (GENERAL, ["reference", "origin"], "p1"),
    (GENERAL, ["sketch", "E", "normal"], [0, 1]),
    (FLAT, ["planes"], ["E"]),
    (FLAT, ["bodies", "base", "p2"], [0, 0, 0]),
    (FLAT, ["bodies", "base", "E"], {"normal": [0, 0, 1], "offset": 1}),
    (FLAT, ["fixed", "L", "direction"], [1, 0, 0]),
    (FLAT, ["fixed", "L", "direction"], [0, 0]),
    (FLAT, ["constraints"], [{"type": "meet", "between": ["L", "M"]}]),
    (FLAT, ["constraints"], [{"type": "orientation", "of": ["p1", "p2", "p3", "p4"], "sign": 1}]),
]


def changed(document, path, value):
    """A copy of the document with the value at the path replaced or removed."""
    result = copy.deepcopy(document)
    target = result
    for step in path[:-1]:
        target = target[step]
    if value is REMOVED:
        del target[path[-1]]
    else:
        target[path[-1]] = value
    return result


def complaints(validator, folder):
    """Yields a line for every verdict of the schema that is wrong."""
    for file in sorted(folder.glob("*.json")):
        if file.name == "schema.json":
            continue
        for error in validator.iter_errors(json.loads(file.read_text(encoding="utf-8"))):
            yield f"{file.name}: {error.json_path}: {error.message}"
    for document in (PLANE, SPACE, BENT, GENERAL, FLAT):
        for error in validator.iter_errors(document):
            yield f"the sound '{document['id']}' is refused: {error.json_path}: {error.message}"
    for document, path, value in BROKEN:
        if validator.is_valid(changed(document, path, value)):
            yield f"the broken '{document['id']}' passes: {path} = {'removed' if value is REMOVED else value}"


def main():
    folder = pathlib.Path(sys.argv[1])
    schema = json.loads((folder / "schema.json").read_text(encoding="utf-8"))
    Draft202012Validator.check_schema(schema)
    wrong = list(complaints(Draft202012Validator(schema), folder))
    print("\n".join(wrong) if wrong else f"the schema is right about all instances and {len(BROKEN)} broken ones")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
