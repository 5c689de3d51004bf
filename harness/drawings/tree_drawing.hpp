#pragma once
/// The interpretation tree of a scene's first construction plan (after Figure 3 of Imbach, Mathis, Schreck 2016), for
/// both columns of a paper.

#include <optional>
#include <string>

#include "harness/drawings/drawing.hpp"
#include "solvers/reading/instance_parser.hpp"

namespace gcs {

/// Why the tree is not drawn (no plan, or too many branches), or nothing.
std::optional<std::string> why_no_tree(const Instance& instance);

/// "tree-<id>": the plan, all branches at the given lengths with driving parameters as in the sketch, and the
/// figures that they build, or the first of them. Figures in space are seen from a fixed place. Precondition:
/// nothing from why_no_tree.
Drawing draw_tree(const Instance& instance);

}  // namespace gcs
