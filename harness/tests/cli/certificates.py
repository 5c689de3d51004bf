"""Certificates that the program writes, what the checker says of them, and changes of them, for tests."""

import copy
import functools
import json
import random
import re
import tempfile
from pathlib import Path

import command_line
from command_line import DONE, SOURCE, run

SCRIPT = SOURCE / "scripts" / "check-certificate"

checker = command_line.load_script(SCRIPT.name)


def sentence(name, found, real, quantity="exactly", counted=" up to reflection"):
    return f"{name}: {quantity} {found} complex solutions{counted}, {real} of them real: proven."


def some_of(name, found, real, most):
    return sentence(name, found, real, "at least")[:-1] + f"; isolated are at most {most}."


def verdict(certificate):
    """The theorem, or None."""
    try:
        return checker.theorem(checker.parsed(json.dumps(certificate)))
    except (checker.Refused, checker.Unreadable):
        return None


def places(value, path=()):
    """Paths to all values within one."""
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield (*path, key)
            yield from places(value[key], (*path, key))


def at(value, path):
    for key in path:
        value = value[key]
    return value


def with_value(certificate, path, value):
    changed = copy.deepcopy(certificate)
    at(changed, path[:-1])[path[-1]] = value
    return changed


def without(certificate, path):
    changed = copy.deepcopy(certificate)
    del at(changed, path[:-1])[path[-1]]
    return changed


def changes(value, draw, names):
    """Other values in the place of one."""
    if isinstance(value, bool):
        return [not value]
    if isinstance(value, (int, float)):
        return [value + 1, value - 1, 2 * value, -value]
    if isinstance(value, str) and value.lstrip("-").isdigit():
        return [str(int(value) + step) for step in (-(10 ** 9), 10 ** 9, draw.getrandbits(70))]
    if isinstance(value, str):
        return [draw.choice(names), ""]
    if isinstance(value, list) and value:
        return [value[:-1], value + value[:1], value[::-1]]
    return [None, {}]


@functools.cache
def written(instance, *options, strategy="monodromy"):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "certificate.json"
        done = run("--quiet", "solve", instance, "--strategy", strategy, "--certificate", out, *options)
        return done.returncode, out.read_text() if out.exists() else None


class CertificateTest(command_line.CommandLine):
    def certificate(self, instance, *options, codes=(DONE,), **strategy):
        code, text = written(instance, *options, **strategy)
        self.assertIn(code, codes)
        return json.loads(text)

    def assert_changes_are_harmless(self, name, certificate, places_of_a_kind=1, most_changes=2, but=None):
        """Each of some hundreds, in every kind of place, is refused or proves the same, or what is proven without what is
        at infinity. `but`: a pattern of what is said of the instance alone, which a change of it changes."""
        draw = random.Random(7)

        def proven_of(changed):
            proven = verdict(changed)
            return re.sub(but, "", proven) if proven and but else proven

        true = {proven_of(certificate), proven_of({**certificate, "at_infinity": None})}
        self.assertNotIn(None, true)
        kinds = {}
        for path in places(certificate):
            kinds.setdefault(tuple(key for key in path if isinstance(key, str)), []).append(path)
        for paths in kinds.values():
            for path in draw.sample(paths, min(len(paths), places_of_a_kind)):
                value = at(certificate, path)
                others = changes(value, draw, certificate["instance"]["points"] or ["nobody"])
                changed_ones = [*(with_value(certificate, path, other) for other in others if other != value),
                                without(certificate, path)]
                for changed in draw.sample(changed_ones, min(len(changed_ones), most_changes)):
                    with self.subTest(path=path):
                        proven = proven_of(changed)
                        # The sentence is about the instance, which may have another id.
                        self.assertIn(proven and proven.replace(changed["instance"]["id"], name, 1), (None, *true))
