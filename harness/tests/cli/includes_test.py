#!/usr/bin/python3
"""Sources include what they use of the precompiled headers, which hide it from the compiler when they do not.

Usage: includes_test.py PROGRAM SOURCE_DIR [unittest arguments]
"""

import re
import unittest
from functools import cache

import command_line
from command_line import SOURCE

# What shows that a source needs a header.
USES = {
    "algorithm": r"std::(ranges::)?(any_of|all_of|binary_search|clamp|copy|count|count_if|equal|fill|find|find_if|for_each"
                 r"|is_sorted|lower_bound|max|max_element|min|min_element|minmax|none_of|nth_element|remove_if|replace"
                 r"|reverse|rotate|sort|stable_sort|transform|unique|upper_bound)\s*[(<]",
    "array": r"std::array\b",
    "cmath": r"std::(abs|acos|atan2|cos|exp|floor|fma|frexp|hypot|isfinite|isnan|ldexp|log|log2|nextafter|pow|round|sin"
             r"|sqrt|tan)\(",
    "complex": r"std::complex<",
    "functional": r"std::function\b",
    "limits": r"std::numeric_limits<",
    "map": r"std::map<",
    "optional": r"std::(optional<|nullopt)",
    "span": r"std::span<",
    "stop_token": r"std::stop_(token|source|callback)\b",
    "string": r"std::(string\b|to_string)",
    "vector": r"std::vector<",
    "Eigen/Core": r"\bEigen::",
    "Eigen/Eigenvalues": r"\b(Complex|SelfAdjoint)?EigenSolver<|\bComplexSchur<",
    "Eigen/Geometry": r"\.cross\(|\b(Quaterniond|AngleAxisd)\b",
    "Eigen/LU": r"\b(Partial|Full)PivLU<|\.determinant\(\)",
    "Eigen/QR": r"HouseholderQR<|\bCompleteOrthogonalDecomposition<",
    "Eigen/SVD": r"\b(Jacobi|BDC)SVD<",
}
# What headers say that they include.
BRINGS = {
    "Eigen/Core": ["cmath", "complex", "limits"],
    "Eigen/Dense": ["Eigen/Eigenvalues", "Eigen/Geometry", "Eigen/LU", "Eigen/QR", "Eigen/SVD"],
    "Eigen/Eigenvalues": ["Eigen/Core", "Eigen/Geometry", "Eigen/LU"],
    "Eigen/Geometry": ["Eigen/Core", "Eigen/LU", "Eigen/SVD"],
    "Eigen/LU": ["Eigen/Core"],
    "Eigen/QR": ["Eigen/Core"],
    "Eigen/SVD": ["Eigen/Core", "Eigen/QR"],
    "gcsbench/gcsbench.hpp": ["Eigen/Core", "map", "optional", "stop_token", "string", "vector"],
}


@cache
def included(path):
    """The headers of libraries that a file includes, itself or through headers of the project."""
    text = path.read_text(encoding="utf-8")
    found = set()
    for name in re.findall(r"^#include <(.+)>", text, re.MULTILINE):
        found |= with_what_it_brings(name)
    for name in re.findall(r'^#include "(.+)"', text, re.MULTILINE):
        if (SOURCE / name).exists():
            found |= included(SOURCE / name)
    return frozenset(found)


def with_what_it_brings(name):
    return {name}.union(*(with_what_it_brings(other) for other in BRINGS.get(name, [])))


def missing(text, headers):
    """Of the headers those that the text needs beside these."""
    code = re.sub(r"//.*", "", text)
    return [header for header, use in USES.items() if header not in headers and re.search(use, code)]


class Includes(unittest.TestCase):
    def test_what_is_used_is_included(self):
        files = [path for house in ("solvers", "harness") for path in sorted((SOURCE / house).rglob("*.[ch]pp"))]
        self.assertGreater(len(files), 600)
        for path in files:
            with self.subTest(str(path.relative_to(SOURCE))):
                self.assertEqual(missing(path.read_text(encoding="utf-8"), included(path)), [])

    def test_what_is_missing_is_found(self):
        text = "double f(const std::vector<double>& x) { return std::max(x[0], 1.0); }  // std::optional<int>"
        self.assertEqual(missing(text, {"vector"}), ["algorithm"])
        self.assertEqual(missing(text, {"vector", "algorithm"}), [])
        self.assertEqual(missing("Eigen::JacobiSVD<Eigen::MatrixXd> svd;", with_what_it_brings("Eigen/LU")), ["Eigen/SVD"])


if __name__ == "__main__":
    command_line.main()
