#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "harness/drawings/graph_drawing.hpp"

namespace gcs {
namespace {

using Layout = Eigen::Matrix2Xd;

/// Entities and which of them are constrained against each other.
class Graph {
 public:
  explicit Graph(const ProblemStatement& problem)
      : size(problem.entity_count()), adjacent(Eigen::MatrixXi::Zero(size, size)) {
    for (const GraphEdge& edge : graph_edges(problem)) add(edge.between);
    std::vector<int> given;
    for (int e = 0; e < static_cast<int>(size); ++e)
      if (problem.is_fixed(e)) given.push_back(e);
    put_side_by_side(given);
    for (const RigidBody& body : problem.bodies) put_side_by_side(entities_of(body));
  }

  Eigen::Index size;
  Eigen::MatrixXi adjacent;
  std::vector<std::array<int, 2>> edges;

 private:
  /// Members of what is rigid.
  void put_side_by_side(const std::vector<int>& entities) {
    for (const int a : entities)
      for (const int b : entities)
        if (a != b) adjacent(a, b) = 1;
  }

  void add(const std::array<int, 2>& edge) {
    adjacent(edge[0], edge[1]) = adjacent(edge[1], edge[0]) = 1;
    edges.push_back(edge);
  }
};

/// Numbers of edges on the shortest ways (Floyd, Warshall); as many as there are entities where there is
/// none.
Eigen::MatrixXd graph_distances(const Graph& graph) {
  Eigen::MatrixXd distance =
      Eigen::MatrixXd::Constant(graph.size, graph.size, static_cast<double>(graph.size));
  for (Eigen::Index i = 0; i < graph.size; ++i)
    for (Eigen::Index j = 0; j < graph.size; ++j)
      if (i == j || graph.adjacent(i, j) != 0) distance(i, j) = i == j ? 0 : 1;
  for (Eigen::Index k = 0; k < graph.size; ++k)
    for (Eigen::Index i = 0; i < graph.size; ++i)
      for (Eigen::Index j = 0; j < graph.size; ++j)
        distance(i, j) = std::min(distance(i, j), distance(i, k) + distance(k, j));
  return distance;
}

Layout on_circle(Eigen::Index size) {
  Layout layout(2, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size);
    layout.col(i) << std::sin(angle), std::cos(angle);
  }
  return layout;
}

/// From `layout`, its weighted stress Σ (|p_i − p_j| − d_ij)²/d_ij² lowered by majorisation point by point.
Layout relaxed(Layout layout, const Graph& graph) {
  constexpr int sweeps = 200;
  const Eigen::MatrixXd distance = graph_distances(graph);
  layout *= distance.maxCoeff() / 2;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (Eigen::Index i = 0; i < graph.size; ++i) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      double weights = 0;
      for (Eigen::Index j = 0; j < graph.size; ++j) {
        if (i == j) continue;
        const double weight = 1 / (distance(i, j) * distance(i, j));
        const Eigen::Vector2d apart = layout.col(i) - layout.col(j);
        const Eigen::Vector2d direction = apart.norm() > 0 ? Eigen::Vector2d(apart.normalized())
                                                           : Eigen::Vector2d(Eigen::Vector2d::UnitX());
        sum += weight * (layout.col(j) + distance(i, j) * direction);
        weights += weight;
      }
      if (weights > 0) layout.col(i) = sum / weights;
    }
  return layout;
}

/// Every other entity at the mean of its neighbours; the triangle at the corners of a regular one.
Layout barycentric_layout(const Graph& graph, const std::array<int, 3>& outer) {
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Identity(graph.size, graph.size);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(graph.size, 2);
  const Layout corners = on_circle(3);
  for (Eigen::Index i = 0; i < graph.size; ++i) {
    const auto* const corner = std::find(outer.begin(), outer.end(), i);
    if (corner != outer.end()) {
      right.row(i) = corners.col(corner - outer.begin()).transpose();
    } else if (const int degree = graph.adjacent.row(i).sum(); degree > 0) {
      laplacian.row(i) -= graph.adjacent.row(i).cast<double>() / degree;
    }
  }
  return laplacian.fullPivLu().solve(right).transpose();
}

std::vector<std::array<int, 3>> triangles(const Graph& graph) {
  std::vector<std::array<int, 3>> found;
  const int size = static_cast<int>(graph.size);
  for (int a = 0; a < size; ++a)
    for (int b = a + 1; b < size; ++b)
      for (int c = b + 1; c < size; ++c)
        if (graph.adjacent(a, b) != 0 && graph.adjacent(a, c) != 0 && graph.adjacent(b, c) != 0)
          found.push_back({a, b, c});
  return found;
}

Layout in_unit_square(const Layout& layout) {
  const Eigen::Vector2d low = layout.rowwise().minCoeff(), high = layout.rowwise().maxCoeff();
  const double width = std::max((high - low).maxCoeff(), 1e-9);
  const Eigen::Vector2d middle = (low + high) / 2;
  return ((layout.colwise() - middle) / width).array() + 0.5;
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool cross(const Layout& layout, const std::array<int, 2>& e, const std::array<int, 2>& f) {
  if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) return false;
  const auto p = [&](int i) -> Eigen::Vector2d { return layout.col(i); };
  return turn(p(e[0]), p(e[1]), p(f[0])) * turn(p(e[0]), p(e[1]), p(f[1])) < 0 &&
         turn(p(f[0]), p(f[1]), p(e[0])) * turn(p(f[0]), p(f[1]), p(e[1])) < 0;
}

double segment_distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double part = std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
  return (p - a - part * along).norm();
}

/// Small for few crossings and much room between entities, and between entities and edges: a crossing more is
/// worth as much as twice the room, where that is little.
double confusion(const Layout& layout, const Graph& graph) {
  constexpr double little_room = 0.1;
  double crossings = 0, room = 1;
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    for (std::size_t f = 0; f < e; ++f) crossings += cross(layout, graph.edges[e], graph.edges[f]) ? 1 : 0;
  for (Eigen::Index i = 0; i < graph.size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) room = std::min(room, (layout.col(i) - layout.col(j)).norm());
    for (const auto& [a, b] : graph.edges)
      if (a != i && b != i)
        room = std::min(room, segment_distance(layout.col(i), layout.col(a), layout.col(b)));
  }
  return crossings + 2 * little_room / std::max(room, 1e-9);
}

}  // namespace

Eigen::Matrix2Xd graph_layout(const ProblemStatement& problem) {
  constexpr std::size_t most_triangles = 100;
  const Graph graph(problem);
  Layout best;
  double least = std::numeric_limits<double>::infinity();
  const auto judge = [&](const Layout& layout) {
    const Layout candidate = in_unit_square(layout);
    const double value = confusion(candidate, graph);
    if (value >= least) return;
    least = value;
    best = candidate;
  };
  judge(on_circle(graph.size));
  judge(relaxed(on_circle(graph.size), graph));
  const auto outer = triangles(graph);
  for (std::size_t i = 0; i < std::min(outer.size(), most_triangles); ++i) {
    const Layout layout = barycentric_layout(graph, outer[i]);
    judge(layout);
    judge(relaxed(layout, graph));
  }
  return best;
}

}  // namespace gcs
