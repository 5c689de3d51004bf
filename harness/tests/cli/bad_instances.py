"""A small valid instance, and every way in which an instance file can be wrong."""

import copy
import json

# Two triangles on the side p1-p2, in the plane: two solutions up to reflection.
TOY = {
    "format": "gcsbench-instance/1",
    "id": "toy",
    "title": "Toy",
    "dimension": 2,
    "points": ["p1", "p2", "p3", "p4"],
    "constraints": [
        {"type": "distance", "between": ["p1", "p2"], "length": 6},
        {"type": "distance", "between": ["p1", "p3"], "length": 5},
        {"type": "distance", "between": ["p2", "p3"], "length": 5},
        {"type": "distance", "between": ["p1", "p4"], "length": 8},
        {"type": "distance", "between": ["p2", "p4"], "length": 10},
    ],
    "sketch": {"p1": [0, 0], "p2": [5, 0], "p3": [2, 3], "p4": [1, 7]},
}


def changed(**members):
    """TOY with other members; None removes one."""
    result = copy.deepcopy(TOY)
    for name, value in members.items():
        if value is None:
            del result[name]
        else:
            result[name] = value
    return result


def with_constraint(index, **members):
    """TOY with one constraint changed; None removes a member."""
    result = copy.deepcopy(TOY)
    for name, value in members.items():
        if value is None:
            del result["constraints"][index][name]
        else:
            result["constraints"][index][name] = value
    return result


def with_text(old, new):
    """TOY as text with a piece replaced, for what json cannot write."""
    text = json.dumps(TOY)
    assert old in text
    return text.replace(old, new, 1)


def constraint(first, second, length=3):
    return {"type": "distance", "between": [first, second], "length": length}


TETRAHEDRA = [("p1", "p2"), ("p1", "p3"), ("p2", "p3"), ("p1", "p4"), ("p2", "p4"), ("p3", "p4")]

# name: (content, what the message must name)
BAD_FILES = {
    "control character in a name": (changed(points=["p1", "p2", "p3\x1b[31m", "p4"]), "control character"),
    "length below full precision": (with_constraint(0, length=1e-310), "full precision"),
    "empty": ("", ""),
    "blank": ("  \n", ""),
    "broken JSON": (json.dumps(TOY)[:-10], ""),
    "not JSON": ("points: p1, p2", ""),
    "two values": (json.dumps(TOY) + "{}", ""),
    "an array": ([TOY], ""),
    "10 MB of nested brackets": ("[" * 10_000_000, ""),
    "nested objects": ('{"a":' * 100_000, ""),
    "invalid UTF-8": (b'{"format": "\xff"}', ""),
    "a zero byte": (json.dumps(TOY).encode() + b"\0", ""),
    "duplicate key": (with_text('"title": "Toy"', '"title": "Toy", "title": "Joy"'), "/title"),
    "NaN": (with_text('"length": 8', '"length": NaN'), "constraints/3"),
    "infinity": (with_text('"length": 8', '"length": Infinity'), "constraints/3"),
    "too small for a double": (with_text('"length": 8', '"length": 1e-400'), "/constraints/3/length"),
    "too large for a double": (with_text('"length": 8', '"length": 1e400'), "/constraints/3/length"),
    "no format": (changed(format=None), "format"),
    "another format": (changed(format="gcsbench-instance/9"), "/format"),
    "no constraints": (changed(constraints=None), "constraints"),
    "unknown field": (changed(sketh={}), "/sketh"),
    "unknown field of a constraint": (with_constraint(1, lenght=5), "/constraints/1/lenght"),
    "another id than the file's": (changed(id="joy"), "/id"),
    "dimension 4": (changed(dimension=4), "/dimension"),
    "dimension as text": (changed(dimension="2"), "/dimension"),
    "duplicate name": (changed(points=["p1", "p2", "p3", "p4", "p2"]), "/points/4"),
    "points that are no texts": (changed(points=[1, 2, 3, 4]), "/points/0"),
    "a line in the plane": (changed(lines=["L"]), "/lines"),
    "unknown type": (with_constraint(2, type="angle"), "/constraints/2/type"),
    "unknown point": (with_constraint(2, between=["p2", "p9"]), "/constraints/2/between/1"),
    "a point to itself": (with_constraint(2, between=["p2", "p2"]), "/constraints/2"),
    "three points": (with_constraint(2, between=["p2", "p3", "p4"]), "/constraints/2/between"),
    "the same pair twice": (with_constraint(2, between=["p3", "p1"]), "/constraints/2"),
    "duplicate constraint id": (with_constraint(2, id="a1"), "/constraints"),
    "negative length": (with_constraint(2, length=-5), "/constraints/2/length"),
    "length 0": (with_constraint(2, length=0), "/constraints/2/length"),
    "length as text": (with_constraint(2, length="5"), "/constraints/2/length"),
    "negative square": (with_constraint(2, length=None, squared=-1), "/constraints/2/squared"),
    "both length and squared": (with_constraint(2, squared=25), "/constraints/2"),
    "neither length nor squared": (with_constraint(2, length=None), "/constraints/2"),
    "under-constrained": (changed(constraints=TOY["constraints"][:4]), "/constraints"),
    "over-constrained": (changed(constraints=TOY["constraints"] + [constraint("p3", "p4")]), "/constraints"),
    "wrongly constrained": (
        changed(points=["p1", "p2", "p3", "p4", "p5"],
                constraints=[constraint(*pair) for pair in TETRAHEDRA] + [constraint("p1", "p5")], sketch=None),
        "/constraints"),
    "violated triangle inequality": (with_constraint(0, length=60), "/constraints"),
    "incomplete sketch": (changed(sketch={"p1": [0, 0], "p2": [5, 0], "p3": [2, 3]}), "/sketch"),
    "unknown point in the sketch": (changed(sketch=dict(TOY["sketch"], p9=[1, 1])), "/sketch/p9"),
    "sketch with coincident points": (changed(sketch=dict(TOY["sketch"], p3=[0, 0])), "/sketch"),
    "sketch in another dimension": (changed(sketch=dict(TOY["sketch"], p3=[0, 0, 1])), "/sketch/p3"),
    "bent constraint that is not there": (changed(interpolation={"bent": "a9"}), "/interpolation/bent"),
    "bends and a bent constraint": (changed(interpolation={"bent": "a1", "bends": {}}), "/interpolation"),
    "bends of a constraint that is not there": (changed(interpolation={"bends": {"a9": [1]}}), "/interpolation/bends/a9"),
    "bends that are no list": (changed(interpolation={"bends": {"a1": 1}}), "/interpolation/bends/a1"),
    "too many coefficients": (changed(interpolation={"bends": {"a1": [1] * 17}}), "/interpolation/bends/a1"),
    "a length that is not positive on the way": (
        changed(interpolation={"bends": {"a1": [1], "a2": [0, -90]}}), "/interpolation/bends/a2"),
    "reference to an unknown point": (changed(reference={"origin": "p9", "axis": "p1"}), "/reference/origin"),
}
