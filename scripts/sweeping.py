"""What the sweeps share: running the program on a scene, random rigid graphs in the plane, and lines of a table."""

import itertools
import json
import math
import random
import subprocess
import sys
from collections import Counter
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
SWEEPS = SOURCE / "results" / "sweeps"


def program_and_number(usage, default):
    """Of the command line: PROGRAM [NUMBER]."""
    if len(sys.argv) not in (2, 3) or len(sys.argv) == 3 and not sys.argv[2].isdecimal():
        sys.exit(usage)
    return Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) == 3 else default


def solved(program, instance, strategy, *options):
    """The result, or the message where there is none. `instance`: a name that the program knows, or a scene as JSON has it."""
    is_named = isinstance(instance, str)
    done = subprocess.run([Path(program).resolve(), "--quiet", "solve", instance if is_named else "-", "--strategy", strategy,
                           "--out", "-", *options],
                          input=None if is_named else json.dumps(instance), cwd=SOURCE, capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.stdout else {"status": "refused", "reason": done.stderr.strip()}


def environment_of(program):
    return solved(program, "octahedron", "full-space")["environment"]


def short_commit(environment):
    commit, mark, edit = environment["commit"].partition("+")
    return commit[:7] + mark + edit


def origin(environment):
    """Of figures: the program and the machine."""
    return f"{short_commit(environment)}, {environment['compiler']}, {environment['cpu']}"


def line(cells):
    """Of a table."""
    return f"| {' | '.join(map(str, cells))} |"


def random_graph(points, dice):
    """By Henneberg's second step from a triangle, so often that no point hangs on two others: minimally rigid."""
    while True:
        edges = {(0, 1), (0, 2), (1, 2)}
        for new in range(3, points):
            a, b = dice.choice(sorted(edges))
            other = dice.choice([point for point in range(new) if point not in (a, b)])
            edges = (edges - {(a, b)}) | {(a, new), (b, new), (other, new)}
        if min(Counter(itertools.chain(*edges)).values()) > 2:
            return sorted(edges)


def random_figure(points, dice):
    return {f"p{i}": [dice.uniform(0, 10), dice.uniform(0, 10)] for i in range(points)}


def random_scene(points, seed):
    """A random rigid graph with the lengths of the figure that is its sketch; and the dice, for more."""
    dice = random.Random(f"components {points} {seed}")
    edges = random_graph(points, dice)
    known = random_figure(points, dice)
    constraints = [{"id": f"a{k}", "type": "distance", "between": [f"p{a}", f"p{b}"],
                    "length": math.dist(known[f"p{a}"], known[f"p{b}"])} for k, (a, b) in enumerate(edges, start=1)]
    return {"format": "gcsbench-instance/1", "id": f"random-{points}-{seed}", "dimension": 2,
            "points": list(known), "constraints": constraints, "sketch": known}, dice
