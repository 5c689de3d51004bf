"""What the scripts share that have PHCpack solve an instance: calling it, finishing its solutions, and printing the result.

J. Verschelde, Algorithm 795: PHCpack: a general-purpose solver for polynomial systems by homotopy continuation, 1999.
"""

import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

# Of a correction, relative to the largest unknown: a regular solution settles at 1e-15 times its condition.
SETTLED = 1e-8
# Relative to the largest coordinate.
IMAGINARY_LIMIT = 1e-10
# Solutions may lie as far away, in units of the scene, and are kept; of the ends that are none, those beyond are on their
# way to infinity.
FAR = 1e3

NAME = re.compile(r"[A-Za-z]\w*")
FACTOR = r"(?:[A-Za-z]\w*|\d+(?:\.\d*)?(?:[eE][+-]?\d+)?)(?:\^\d+)?"
TERM = re.compile(rf"([+-]?)\s*({FACTOR}(?:\s*\*\s*{FACTOR})*)")
SOLUTION = re.compile(r"^solution \d+ :.*?^m : (\d+).*?^the solution for t :\n(.*?)^== (.*?) ==$",
                      re.DOTALL | re.MULTILINE)
VALUE = re.compile(r"^ *(\w+) : +(\S+) +(\S+)$", re.MULTILINE)


class Unsolved(Exception):
    """Why there is no answer."""


def run(command, **more):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        said = (done.stderr or done.stdout)[-200:].strip()
        raise Unsolved(f"{Path(command[0]).name} ended with status {done.returncode}: {said}")
    return done.stdout


def function(expressions, names):
    """Of the values of these unknowns."""
    return eval(f"lambda {', '.join(names)}: [{', '.join(expressions)}]")  # pylint: disable=eval-used


def terms_of(polynomial):
    """(coefficient, {name: exponent}) of each term of a sum such as -1.5*x^2*y + z."""
    for sign, term in TERM.findall(polynomial):
        coefficient, exponents = float(sign.replace(" ", "") + "1"), {}
        for factor in term.split("*"):
            base, _, power = factor.strip().partition("^")
            if NAME.fullmatch(base):
                exponents[base] = exponents.get(base, 0) + int(power or 1)
            else:
                coefficient *= float(base)**int(power or 1)
        yield coefficient, exponents


def derivative(terms, name):
    return [(c * of[name], {**of, name: of[name] - 1}) for c, of in terms if of.get(name)]


def expression(terms):
    return " + ".join("*".join([repr(c), *(f"{n}**{k}" if k > 1 else n for n, k in of.items() if k)])
                      for c, of in terms) or "0"


class Polynomials:
    """In PHCpack's words."""

    def __init__(self, text):
        self.text = text
        polynomials = [list(terms_of(line.rstrip(";"))) for line in text.splitlines()[1:int(text.split(None, 1)[0]) + 1]]
        self.names = sorted({name for terms in polynomials for _, of in terms for name in of})
        rows = [[*(derivative(terms, name) for name in self.names), terms] for terms in polynomials]
        self.entries = function([expression(entry) for row in rows for entry in row], self.names)

    def linearised(self, values):
        """Rows of derivatives with the residual last."""
        entries, width = self.entries(*values), len(values) + 1
        return [entries[i:i + width] for i in range(0, len(entries), width)]


def leaves(node):
    """Of lists and objects that hold numbers."""
    if isinstance(node, (dict, list)):
        return [leaf for n in (node.values() if isinstance(node, dict) else node) for leaf in leaves(n)]
    return [node]


def written(figure):
    """The members of a result's solution: coordinates are numbers, or pairs where any is complex."""
    size = max(map(abs, leaves(figure)))
    is_real = all(abs(number.imag) <= IMAGINARY_LIMIT * size for number in leaves(figure))

    def text(node):
        if isinstance(node, dict):
            return {key: text(n) for key, n in node.items()}
        if isinstance(node, list):
            return list(map(text, node))
        return node.real if is_real else [node.real, node.imag]

    return {**text(figure), "real": is_real}


def solved(rows):
    """The solution of linear equations, given with their right sides, by elimination; None where it is singular."""
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda r: abs(rows[r][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        if rows[k][k] == 0:
            return None
        for r in range(k + 1, size):
            factor = rows[r][k] / rows[k][k]
            if factor:
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[k])]
    solution = [0j] * size
    for k in reversed(range(size)):
        known = sum(rows[k][c] * solution[c] for c in range(k + 1, size))
        solution[k] = (rows[k][-1] - known) / rows[k][k]
    return solution


def finished(system, values):
    """The solution that these values are near, as Newton's method finds it; the values where it does not settle."""
    better, last = values, math.inf
    for _ in range(10):
        correction = solved(system.linearised(better))
        if correction is None:
            return values
        size = max(map(abs, correction))
        if size >= last / 2:
            break
        better, last = [value - step for value, step in zip(better, correction)], size
    return better if last <= SETTLED * max(map(abs, better)) else values


def solutions_of(answer, system):
    """The last list in PHCpack's answer: multiplicity, values of the unknowns, and its own verdict on each."""
    for multiplicity, values, verdict in SOLUTION.findall(answer[answer.rindex("THE SOLUTIONS"):]):
        known = {name: complex(float(a), float(b)) for name, a, b in VALUE.findall(values)}
        yield int(multiplicity), [known[name] for name in system.names], verdict


def ends_of(system):
    """What `phc -b` finds; nothing where there is nothing left to solve."""
    if not system.names:
        return [(1, [], "regular")]
    with tempfile.TemporaryDirectory(prefix="phcpack-") as folder:
        (Path(folder) / "system").write_text(system.text)
        run(["phc", "-b", "-0" + os.environ.get("GCSBENCH_SEED", "1"), "system", "answer"], cwd=folder)
        answer = (Path(folder) / "answer").read_text()
    return list(solutions_of(answer, system)) if "THE SOLUTIONS" in answer else []


def solutions(system, figure):
    """Of polynomials, each as `figure` makes complex positions of the values of its unknowns, by name, and how many ends are
    neither solutions nor far away."""
    ends = ends_of(system)
    kept = [end for end in ends if "regular" in end[2] or "singular" in end[2]]
    undecided = sum(end not in kept and max(map(abs, end[1])) <= FAR for end in ends)
    finals = [finished(system, values) if values else [] for _, values, _ in kept]
    return [{**written(figure(dict(zip(system.names, values)))), "multiplicity": end[0]}
            for values, end in zip(finals, kept)], undecided


def answer(solve):
    """Prints as a result what `solve`, which is given the instance as text, returns as solutions() does."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # so that the temporary folder is removed
    result = {"format": "gcsbench-result/1", "claim": "all complex", "status": "complete", "reason": "", "solutions": []}
    try:
        if shutil.which("phc") is None:
            raise Unsolved("phc, the program of PHCpack, is not installed (Debian: phcpack)")
        result["solutions"], undecided = solve(sys.stdin.read())
        if undecided > 0:
            result["status"] = "partial"
            result["reason"] = f"phc says of {undecided} ends, which are not far away, that they are no solutions"
    except Unsolved as reason:
        result["status"], result["reason"] = "gave up", str(reason)
    json.dump(result, sys.stdout)
