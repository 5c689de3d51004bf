#pragma once
/// The constraint graph of a problem as SVG, for one column of a paper.

#include <Eigen/Core>
#include <string>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Places for the entities in the unit square, one column each. Of barycentric drawings around each triangle
/// (Tutte 1963: without crossings where the graph is planar and three-connected), and of what becomes of them
/// and of a circle when distances are made those in the graph (Kamada, Kawai 1989), the one is taken that has
/// few crossings and much room between entities and edges of others.
Eigen::Matrix2Xd graph_layout(const ProblemStatement& problem);

/// The whole SVG document, of a well posed problem. Points are discs, lines are squares; those that fix the
/// frame, or are given, are dark. Bent constraints are dashed. Constraints are named where there is room
/// for it.
std::string graph_svg(const ProblemStatement& problem, const std::string& title);

}  // namespace gcs
