"""Geometric constraint solving: place points, lines, planes and rigid bodies so that given distances and angles hold.

>>> import gcsbench
>>> triangle = gcsbench.Problem(dimension=2).points("a", "b", "c")
>>> triangle = triangle.distance("a", "b", "3.1").distance("b", "c", 4).distance("c", "a", 5)
>>> gcsbench.solve(triangle, "monodromy", certify=True).solutions.shape
(1, 3, 2)

Numbers that are given may be texts or decimal.Decimal, which are exact, whole numbers, and floats, which are the binary
numbers that they are: "3.1" is 31/10, and 3.1 is not quite.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from . import _core
from ._core import Answer, Error, Followed

if TYPE_CHECKING:
    import networkx  # type: ignore[import]

__all__ = ["Answer", "Error", "Followed", "Problem", "follow", "follow_polyline", "solve", "strategies"]

Number = Union[str, int, float, Decimal]
Side = Union[str, Sequence[str]]
Progress = Union[bool, Callable[[str, float], None]]
Start = Union[Answer, Followed, Mapping[str, Any], np.ndarray, None]


class _Literal(str):
    """A number as JSON has it."""


def _literal(number: Any) -> _Literal:
    """The exact decimal; what is none is left to be refused where the problem is read."""
    if isinstance(number, (float, np.floating)):
        number = Decimal(float(number))
    if isinstance(number, Decimal):
        if not number.is_finite():
            raise Error(f"{number} is no number that can be given")
        return _Literal(format(number, "E") if abs(number.adjusted()) > 20 else format(number, "f"))
    text = str(number).strip()
    try:
        value = json.loads(text)
    except ValueError:
        value = None
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        raise Error(f"{number!r} is no decimal number; give one such as 3.1, '3.1' or decimal.Decimal('3.1')")
    return _Literal(text)


def _json(value: Any) -> str:
    if isinstance(value, _Literal):
        return str(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(name)}: {_json(member)}" for name, member in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_json, value)) + "]"
    return json.dumps(value)


def _vector(numbers: Iterable[Number]) -> list[_Literal]:
    return [_literal(number) for number in numbers]


def _side(side: Side) -> Any:
    return side if isinstance(side, str) else list(side)


class Problem:
    """Points, lines, planes and rigid bodies, and what is to hold between them.

    Calls may come in any order and be chained. What is wrong is said when the problem is solved, as an Error.
    """

    def __init__(self, dimension: int = 3) -> None:
        self._name = "problem"
        self._document: dict[str, Any] = {"id": "problem", "dimension": dimension, "points": [], "constraints": []}

    @classmethod
    def read(cls, name: str | os.PathLike[str]) -> Problem:
        """The instance in a file, or one that comes with the program, by its id ("disulfide"); raises Error."""
        problem = cls()
        text = _core.Instance.load(os.fspath(name)).text
        problem._name = os.fspath(name)
        problem._document = json.loads(text, parse_float=_Literal, parse_int=_Literal)
        return problem

    @classmethod
    def from_networkx(cls, graph: networkx.Graph, length: str = "length", dimension: int = 2) -> Problem:
        """A point for each node, named by its text, and a distance for each edge: its attribute `length`."""
        problem = cls(dimension).points(*map(str, graph.nodes))
        for a, b, data in graph.edges(data=True):
            if length not in data:
                raise Error(f"the edge ({a!r}, {b!r}) has no attribute '{length}'")
            problem.distance(str(a), str(b), data[length])
        return problem

    def __repr__(self) -> str:
        constraints = len(self._document["constraints"])
        return f"<gcsbench.Problem: {len(self._document['points'])} points, {constraints} constraints>"

    def to_json(self) -> str:
        """The instance as a file has it."""
        document = dict(self._document)
        if "format" not in document:
            is_general = any(kind in document for kind in ("planes", "bodies")) or any(
                constraint["type"] != "distance" for constraint in document["constraints"]) or (
                len(document.get("lines", [])) > 1) or (
                0 < len(document.get("fixed", {})) < document["dimension"])
            document = {"format": f"gcsbench-instance/{2 if is_general else 1}", **document}
        return _json(document)

    # What there is.

    def points(self, *names: str) -> Problem:
        """Further points."""
        self._document["points"] += names
        return self

    def lines(self, *names: str) -> Problem:
        """Further lines."""
        self._document.setdefault("lines", []).extend(names)
        return self

    def planes(self, *names: str) -> Problem:
        """Further planes, in space."""
        self._document.setdefault("planes", []).extend(names)
        return self

    def body(self, name: str, elements: Mapping[str, Any]) -> Problem:
        """A rigid body, never mirrored: where its elements are, in any frame.

        A point has coordinates, a line {"point": …, "direction": …}, a plane {"normal": …, "offset": …}. Elements of a
        body are not named elsewhere; one that two bodies have is a joint of theirs.
        """
        self._document.setdefault("bodies", {})[name] = {
            element: self._position(position) for element, position in elements.items()}
        return self

    # What is to hold.

    def distance(self, a: str, b: str, length: Number) -> Problem:
        """The distance of two elements."""
        return self._constrain("distance", between=[a, b], length=_literal(length))

    def squared_distance(self, a: str, b: str, square: Number) -> Problem:
        """The square of the distance of two elements."""
        return self._constrain("distance", between=[a, b], squared=_literal(square))

    def angle(self, a: Side, b: Side, degrees: Number) -> Problem:
        """The angle of two lines, planes or segments (pairs of points), in degrees."""
        return self._constrain("angle", between=[_side(a), _side(b)], degrees=_literal(degrees))

    def angle_cosine(self, a: Side, b: Side, cosine: Number) -> Problem:
        """The cosine of the angle of two lines, planes or segments."""
        return self._constrain("angle", between=[_side(a), _side(b)], cosine=_literal(cosine))

    def on(self, a: str, b: str) -> Problem:
        """A point lies on a line or plane, or a line on a plane."""
        return self._constrain("on", between=[a, b])

    def meet(self, a: str, b: str) -> Problem:
        """Two lines in space meet."""
        return self._constrain("meet", between=[a, b])

    def parallel(self, a: Side, b: Side) -> Problem:
        """Lines, planes or segments are parallel."""
        return self._constrain("parallel", between=[_side(a), _side(b)])

    def perpendicular(self, a: Side, b: Side) -> Problem:
        """Lines, planes or segments are perpendicular."""
        return self._constrain("perpendicular", between=[_side(a), _side(b)])

    def collinear(self, *points: str) -> Problem:
        """Three points or more lie on a line."""
        return self._constrain("collinear", between=list(points))

    def coplanar(self, *points: str) -> Problem:
        """Four points or more lie in a plane."""
        return self._constrain("coplanar", between=list(points))

    def orientation(self, points: Sequence[str], sign: int) -> Problem:
        """Real solutions count only where det(p2 − p1, p3 − p1, …) has this sign, 1 or −1."""
        return self._constrain("orientation", of=list(points), sign=_literal(sign))

    def fix(self, element: str, position: Any) -> Problem:
        """Where an element is; a position as in `body`."""
        self._document.setdefault("fixed", {})[element] = self._position(position)
        return self

    def sketch(self, element: str, position: Any) -> Problem:
        """Where an element is in the figure at which path strategies start."""
        self._document.setdefault("sketch", {})[element] = self._position(position)
        return self

    def count(self) -> dict[str, Any]:
        """How many complex solutions there can be at generic values, without solving: what `gcsbench count` says."""
        return self._instance().count()

    def _constrain(self, kind: str, **members: Any) -> Problem:
        self._document["constraints"].append({"type": kind, **members})
        return self

    @staticmethod
    def _position(position: Any) -> Any:
        if not isinstance(position, Mapping):
            return _vector(position)
        return {part: _literal(value) if part == "offset" else _vector(value) for part, value in position.items()}

    def _placed(self, positions: Mapping[str, Any]) -> Problem:
        """The same with these positions for its sketch."""
        placed = Problem()
        placed._name = self._name
        placed._document = {**self._document, "sketch": {
            element: self._position(position) for element, position in positions.items()}}
        return placed

    def _instance(self) -> _core.Instance:
        return _core.Instance(self.to_json(), self._name)


def strategies() -> dict[str, Any]:
    """The strategies of this build: what each does, and its options with defaults, what is allowed, and what it means."""
    return _core.strategies()


def _text(value: Any) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    return str(value)


class _Bar:
    """A progress bar of tqdm."""

    def __init__(self, bar: Any) -> None:
        self._bar = bar

    def __call__(self, stage: str, fraction: float) -> None:
        self._bar.set_description(stage, refresh=False)
        self._bar.n = round(max(fraction, 0), 3)
        self._bar.refresh()


def _solve(problem: Problem, strategy: str, options: dict[str, Any], progress: Any, settings: dict[str, Any]) -> Answer:
    texts = {name: _text(value) for name, value in options.items()}
    return _core.solve(problem._instance(), strategy, texts, progress=progress, **settings)


def solve(problem: Problem, strategy: str = "monodromy", *, certify: bool = False, seed: int = 1,
          threads: int | None = None, time_limit: float | None = None, progress: Progress = False,
          **options: Any) -> Answer:
    """Solves with one strategy; see strategies() for their names and options, which are given as keywords.

    certify     prove what is found
    seed        of everything random: the same seed gives the same answer, for any number of threads
    threads     by default as many as there are cores
    time_limit  seconds, after which the answer holds what is there
    progress    True for a bar, when tqdm is installed; or what is called with a stage and the fraction done, negative
                where nobody can know

    Ctrl-C stops and returns what is there, with the status "interrupted"; other threads of Python run meanwhile. Raises
    Error for a problem, a strategy or an option that is not right. A scene that the strategy cannot do is an answer with
    the status "unsupported".
    """
    settings = {"certify": certify, "seed": seed, "threads": threads or len(os.sched_getaffinity(0)),
                "time_limit_s": time_limit}
    if progress is not True:
        return _solve(problem, strategy, options, progress or None, settings)
    try:
        from tqdm.auto import tqdm  # type: ignore[import]
    except ImportError:
        return _solve(problem, strategy, options, None, settings)
    with tqdm(total=1.0, bar_format="{desc}: {percentage:3.0f}% {elapsed}", leave=False) as bar:
        return _solve(problem, strategy, options, _Bar(bar), settings)


def _positions(shown: Answer | Followed, points: Any, lines: Any, planes: Any) -> dict[str, Any]:
    """Of one figure, as sketches have them."""
    positions: dict[str, Any] = dict(zip(shown.points, points))
    for names, arrays in ((shown.lines, lines), (shown.planes, planes)):
        for i, name in enumerate(names):
            positions[name] = {part: array[i] for part, array in arrays.items()}
    return positions


def _start(problem: Problem, start: Start, solution: int) -> Problem:
    """The problem with the figure to begin at for its sketch."""
    if start is None:
        if "sketch" not in problem._document:
            raise Error("the problem has no sketch to begin at; give a figure")
        return problem
    if isinstance(start, Mapping):
        return problem._placed(start)
    if isinstance(start, Followed):
        if start.figure is None:
            raise Error(f"there is no figure to begin at: {start.reason}")
        return problem._placed(_positions(start, start.figure, start.figure_lines, start.figure_planes))
    if isinstance(start, Answer):
        if not -len(start) <= solution < len(start):
            raise Error(f"there is no solution {solution}; the answer has {len(start)}")
        if not start.is_real[solution]:
            raise Error(f"solution {solution} is not real")
        lines, planes = ({part: array[solution].real for part, array in arrays.items()}
                         for arrays in (start.solution_lines, start.solution_planes))
        return problem._placed(_positions(start, start.solutions[solution].real, lines, planes))
    points = problem._document["points"]
    if len(start) != len(points):
        raise Error(f"{len(start)} positions for {len(points)} points; give positions by names where there is more")
    return problem._placed(dict(zip(points, start)))


def follow_polyline(problem: Problem, start: Start, vertices: Iterable[Mapping[str, Number]], *, solution: int = 0,
                    prove: bool = True, beyond: bool = True, time_limit: float | None = None) -> list[Followed]:
    """Follows a figure along a polyline of values, from each vertex that is reached on to the next: as `follow`, one for
    each vertex up to the first that is not reached."""
    texts = [{id: str(_literal(value)) for id, value in vertex.items()} for vertex in vertices]
    return _core.follow(_start(problem, start, solution)._instance(), texts, prove, beyond, time_limit)


def follow(problem: Problem, start: Start = None, to: Mapping[str, Number] = {}, *, solution: int = 0,
           prove: bool = True, beyond: bool = True, time_limit: float | None = None) -> Followed:
    """Where a figure moves to when values change: the solution that it becomes without a flip, or the fold at which there is
    none any more.

    start       the figure to begin at: an answer's real solution of that number, what was followed before, positions by
                names as in Problem.sketch, or n × d coordinates of the points; without it the sketch
    to          {id: value} in the form in which the problem states it: a length, its square, degrees or a cosine;
                constraints are a1, a2, … in their order, or as a file names them. All values go straight there from those
                of the figure
    prove       by tubes along which t grows, from the figure's decimals to those given
    beyond      at a fold: look for the solutions beyond
    time_limit  seconds

    Ctrl-C and the time limit stop it, with the end "stopped"; other threads of Python run meanwhile. Raises Error for a
    figure or a value that is not right.
    """
    return follow_polyline(problem, start, [to], solution=solution, prove=prove, beyond=beyond, time_limit=time_limit)[0]
