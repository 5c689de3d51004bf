#include "solvers/counting/set_bound.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "solvers/counting/orientation_count.hpp"

namespace gcs {
namespace {

std::optional<ElementEdge> edge_of(const ProblemStatement& problem, Relation relation) {
  const ConstraintKind* kind = find_kind(problem, relation);
  if (kind == nullptr || kind->polynomials.count == 0) return std::nullopt;
  ElementEdge edge{{relation.of[0].entity, relation.of[1].entity}, kind->polynomials, kind->shares_direction};
  const auto are = [&](std::size_t line, std::size_t plane) {
    return problem.is_line(edge.ends[line]) && problem.is_plane(edge.ends[plane]);
  };
  edge.is_beside = relation.type == "distance" && (are(0, 1) || are(1, 0));
  if (problem.dimension == 2) edge.polynomials.count = 1;
  if (edge.polynomials.sided >= 0) edge.sided = edge.ends[static_cast<std::size_t>(edge.polynomials.sided)];
  edge.joins_sides = value_kind(relation) == ConstraintType::Value::angle &&
                     std::ranges::all_of(edge.ends, [&](int end) { return problem.is_plane(end); });
  return edge;
}

class SetBound {
 public:
  SetBound(const ElementGraph& graph, const std::vector<int>& elements, const std::vector<int>& held)
      : graph_(graph),
        is_free_(static_cast<std::size_t>(graph.problem.entity_count())),
        pinning_(is_free_.size(), nullptr) {
    std::vector<bool> is_inside(is_free_.size());
    for (const int entity : elements) is_inside[static_cast<std::size_t>(entity)] = true;
    is_free_ = is_inside;
    for (const int entity : held) is_free_[static_cast<std::size_t>(entity)] = false;
    for (const ElementEdge& edge : graph.edges)
      if (std::ranges::all_of(edge.ends, [&](int end) { return is_inside[static_cast<std::size_t>(end)]; }) &&
          free_ends(edge) > 0)
        inside_.push_back(&edge);
    if (graph.problem.dimension == 3) pin();
  }

  std::optional<Natural> at_most(std::int64_t& states_left) const {
    std::vector<std::array<int, 2>> edges;
    for (const ElementEdge* edge : inside_)
      if (!is_pinning(*edge))
        edges.insert(edges.end(), static_cast<std::size_t>(edge->polynomials.count), edge->ends);
    std::vector<int> freedoms;
    for (int entity = 0; entity < graph_.problem.entity_count(); ++entity)
      freedoms.push_back(is_free(entity) ? freedoms_left(entity) : 0);
    if (static_cast<int>(edges.size()) != std::accumulate(freedoms.begin(), freedoms.end(), 0))
      return std::nullopt;
    const auto orientations = count_orientations(edges, freedoms, states_left);
    if (!orientations) return std::nullopt;
    Natural bound = *orientations * degrees();
    for (int i = turned_over(); i > 0; --i) bound = bound / 2U;
    return bound;
  }

 private:
  bool is_free(int entity) const { return is_free_[static_cast<std::size_t>(entity)]; }
  int free_ends(const ElementEdge& edge) const {
    return (is_free(edge.ends[0]) ? 1 : 0) + (is_free(edge.ends[1]) ? 1 : 0);
  }
  int free_end(const ElementEdge& edge) const { return edge.ends[is_free(edge.ends[0]) ? 0 : 1]; }
  const ElementEdge*& pinning(int entity) { return pinning_[static_cast<std::size_t>(entity)]; }
  const ElementEdge* pinning(int entity) const { return pinning_[static_cast<std::size_t>(entity)]; }
  static bool have_same_ends(const ElementEdge& one, const ElementEdge& other) {
    return std::ranges::is_permutation(one.ends, other.ends);
  }
  bool is_pinning(const ElementEdge& edge) const {
    return std::ranges::any_of(edge.ends, [&](int end) {
      const ElementEdge* by = pinning(end);
      return by && (by == &edge || (by->is_beside && have_same_ends(*by, edge)));
    });
  }

  /// Directions that are held, and lines through points or in planes that are: two equations of degree one. A line that is said
  /// to be parallel to a plane that is held, and at a distance, is in one of two planes.
  void pin() {
    const auto pin_by = [&](const auto& are_pinning) {
      for (const ElementEdge* edge : inside_)
        if (free_ends(*edge) == 1 && !pinning(free_end(*edge)) && are_pinning(*edge))
          pinning(free_end(*edge)) = edge;
    };
    const auto is_line = [&](const ElementEdge& edge) { return graph_.problem.is_line(free_end(edge)); };
    pin_by([&](const ElementEdge& edge) {
      return edge.polynomials.count == 2 && (edge.shares_direction || is_line(edge));
    });
    pin_by([&](const ElementEdge& edge) {
      return edge.is_beside && is_line(edge) && std::ranges::count_if(inside_, [&](const ElementEdge* other) {
                                                  return have_same_ends(edge, *other);
                                                }) == 2;
    });
  }

  int freedoms_left(int entity) const { return graph_.freedoms(entity) - (pinning(entity) ? 2 : 0); }

  /// The product of the degrees of p·p, which distances alone have, n·n = 1, u·u = 1 and u·m = 0.
  int degree_of_own(int entity) const {
    if (graph_.problem.is_point(entity))
      return std::ranges::any_of(inside_,
                                 [&](const ElementEdge* edge) {
                                   return graph_.are_points(edge->ends) &&
                                          std::ranges::count(edge->ends, entity) > 0;
                                 })
                 ? 2
                 : 1;
    return freedoms_left(entity) == 4 ? 4 : 2;
  }

  bool only_shifts(const ElementEdge& edge) const {
    if (free_ends(edge) != 1 || !edge.polynomials.is_of_shifts) return false;
    const ElementEdge* along = pinning(free_end(edge));
    return along && along->shares_direction &&
           (graph_.problem.is_point(edge.ends[0]) ||
            graph_.directions.find(edge.ends[0]) == graph_.directions.find(edge.ends[1]));
  }

  Natural degrees() const {
    Natural product(1);
    const auto multiply = [&](int factor) {
      product = product * Natural(static_cast<std::uint64_t>(factor));
    };
    for (int entity = 0; entity < graph_.problem.entity_count(); ++entity)
      if (is_free(entity)) multiply(degree_of_own(entity));
    std::set<int> shifted_lines;  // by distances: a place across the direction has a square, as a point has
    for (const ElementEdge* edge : inside_) {
      if (only_shifts(*edge)) {
        if (graph_.problem.is_line(free_end(*edge))) shifted_lines.insert(free_end(*edge));
        continue;
      }
      for (int i = 0; i < edge->polynomials.count && !is_pinning(*edge); ++i)
        multiply(edge->polynomials.degree);
      if (is_pinning(*edge) && edge->is_beside) multiply(2);
    }
    return product * Natural::power_of_two(static_cast<int>(shifted_lines.size()));
  }

  /// How many elements, or planes that are joined, are the same figure when they are turned over.
  int turned_over() const {
    std::set<int> turned, seen;
    int lines = 0;
    for (int entity = 0; entity < graph_.problem.entity_count(); ++entity) {
      if (is_free(entity) && graph_.problem.is_line(entity)) ++lines;
      if (graph_.problem.is_plane(entity))
        (is_free(entity) ? turned : seen).insert(graph_.sides.find(entity));
    }
    for (const ElementEdge& edge : graph_.edges)
      if (edge.sided >= 0) seen.insert(graph_.sides.find(edge.sided));
    std::erase_if(turned, [&](int root) { return seen.contains(root); });
    return lines + static_cast<int>(turned.size());
  }

  const ElementGraph& graph_;
  std::vector<bool> is_free_;
  std::vector<const ElementEdge*> inside_;   ///< with a free end
  std::vector<const ElementEdge*> pinning_;  ///< of each element, or null
};

}  // namespace

ElementEdge distance_edge(const ProblemStatement& problem, int a, int b) {
  return edge_of(problem, {"", "distance", {{a}, {b}}}).value();
}

std::optional<std::vector<ElementEdge>> edges_of(const ProblemStatement& problem) {
  std::vector<ElementEdge> edges;
  for (const DistanceConstraint& c : problem.constraints)
    edges.push_back(distance_edge(problem, c.between[0], c.between[1]));
  for (const Relation& relation : problem.relations) {
    const auto edge = edge_of(problem, relation);
    if (!edge) return std::nullopt;
    edges.push_back(*edge);
  }
  return edges;
}

std::optional<Natural> places_of_set(const ElementGraph& graph, const std::vector<int>& elements,
                                     const std::vector<int>& held, std::int64_t& states_left) {
  return SetBound(graph, elements, held).at_most(states_left);
}

}  // namespace gcs
