"""Scenes of more than points with distances between them, for tests of the program."""


def distances(*rows):
    return [{"type": "distance", "between": [a, b], "length": length} for a, b, length in rows]


# Two triangles in the plane and three legs: at most six postures (Hunt 1983).
PLATFORM = {
    "format": "gcsbench-instance/2", "id": "planar-platform", "dimension": 2, "points": [],
    "bodies": {"base": {"a1": [0, 0], "a2": [1.696793, 1.702087], "a3": [1.501114, 0.179989]},
               "platform": {"b1": [0, 0], "b2": [-0.975807, 1.429743], "b3": [-2.187132, 2.328833]}},
    "constraints": distances(("a1", "b1", 2.223209804508), ("a2", "b2", 1.592107444111), ("a3", "b3", 2.792751828304)),
}

# A line and a plane in a body, and a body that is held to both: every kind of element.
HELD = {
    "format": "gcsbench-instance/2", "id": "held-body", "dimension": 3, "points": [],
    "bodies": {"base": {"a1": [0, 0, 0], "a2": [1.7, 0.1, 0.2], "a3": [0.4, 1.5, -0.3],
                        "K": {"point": [0.3, 0.2, 1.1], "direction": [1, 0.3, 0.2]},
                        "E": {"normal": [0.2, -0.1, 1], "offset": -0.6}},
               "platform": {"b1": [0, 0, 0], "b2": [1.2, 0.3, 0], "b3": [0.5, 1.1, 0.4]}},
    "constraints": distances(("a1", "b1", 1.374772708487), ("a2", "b2", 2.08742624143), ("a3", "b3", 2.481024083889),
                             ("a1", "b3", 2.158923830744), ("b1", "E", 1.951800145897), ("b2", "K", 0.889508559965)),
}

# A triangle with a right angle at a, and the side that c is on.
TRIANGLE = {
    "format": "gcsbench-instance/2", "id": "right-triangle", "dimension": 2, "points": ["a", "b", "c"],
    "constraints": [*distances(("a", "b", 3), ("a", "c", 4), ("b", "c", 5)),
                    {"id": "side", "type": "orientation", "of": ["a", "b", "c"], "sign": -1}],
}


def planes(unit=1):
    """Three points and three planes, all pairs constrained but three: eight classes (Hoffmann, Yuan). Lengths are so
    many units of the file."""
    lengths = (("e1", "e2", 3.477133043187), ("e1", "e3", 2.98888199664), ("e1", "e5", 2.660174436678),
               ("e1", "e6", -2.386319947234), ("e2", "e3", 2.974242632977), ("e2", "e4", 1.151141712353),
               ("e2", "e6", 0.29762364871), ("e3", "e4", 1.851816255962), ("e3", "e5", 0.870596661211))
    cosines = (("e4", "e5", 0.675186443315), ("e4", "e6", -0.920153990406), ("e5", "e6", -0.672766353494))
    return {"format": "gcsbench-instance/2", "id": "three-planes", "dimension": 3, "points": ["e1", "e2", "e3"],
            "planes": ["e4", "e5", "e6"], "reference": {"origin": "e1", "axis": "e2", "plane": "e3"},
            "constraints": distances(*((a, b, unit * length) for a, b, length in lengths)) +
                           [{"type": "angle", "between": [a, b], "cosine": cosine} for a, b, cosine in cosines]}


def osculating(contact, scale=1):
    """Bars from a to p and from b to q move a triangle pqs. Where it stands here s goes along a circle about c to the order
    `contact` of points in common: the derivatives of its squared distance from c along the motion begin with that order. With
    `scale`, of squared lengths, coordinates are no fractions where no squared length is a square."""
    c, p, q, s, b = {3: ((1, -1), (0, 1), (3, -2), (1, 1), (3, 0)), 4: ((4, -3), (0, -1), (-4, 3), (-2, 3), (2, 0))}[contact]
    places = {"a": (0, 0), "b": b, "c": c, "p": p, "q": q, "s": s}
    return {"format": "gcsbench-instance/1", "id": f"osculating-{contact}-{scale}", "dimension": 2, "points": list(places),
            "constraints": [{"type": "distance", "between": [u, v],
                             "squared": scale * sum((x - y) ** 2 for x, y in zip(places[u], places[v]))}
                            for u, v in ("ab", "bc", "ca", "ap", "bq", "cs", "pq", "qs", "sp")]}
