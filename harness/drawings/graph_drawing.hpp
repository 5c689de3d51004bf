#pragma once
/// The constraint graph of a problem as SVG, for one column of a paper.

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// What a constraint holds against each other.
struct GraphEdge {
  std::array<int, 2> between{};  ///< entities
  std::string name;              ///< of the constraint
};

/// One for each distance of `constraints`, in their order; then those of the relations: of a pair one for each entity of one
/// operand with each of the other, of points in a row or a plane one from each to the next, and of an orientation none.
std::vector<GraphEdge> graph_edges(const ProblemStatement& problem);

/// The elements of a body, in its order.
std::vector<int> entities_of(const RigidBody& body);

/// Places for the entities in the unit square, one column each. Of barycentric drawings around each triangle
/// (Tutte 1963: without crossings where the graph is planar and three-connected), and of what becomes of them
/// and of a circle when distances are made those in the graph (Kamada, Kawai 1989), the one is taken that has
/// few crossings and much room between entities and edges of others.
Eigen::Matrix2Xd graph_layout(const ProblemStatement& problem);

/// The whole SVG document, of a well posed problem. Points are discs, lines are squares, planes are triangles; those
/// that fix the frame, or are given, are dark. Elements of a body are joined by grey lines. Bent constraints are dashed. Constraints are named where there is room
/// for it.
std::string graph_svg(const ProblemStatement& problem, const std::string& title);

}  // namespace gcs
