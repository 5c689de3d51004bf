#include "solvers/counting/element_bound.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "solvers/counting/orientation_count.hpp"
#include "solvers/elements/constraint_types.hpp"
#include "solvers/numeric/disjoint_sets.hpp"

namespace gcs {
namespace {

/// Of all sets together: a fraction of a second.
constexpr std::int64_t most_states_of_sets = 500'000;

/// A constraint between two elements.
struct ElementEdge {
  std::array<int, 2> ends{};
  ElementPolynomials polynomials;
  bool shares_direction = false;
  bool is_beside = false;    ///< a distance of a line and a plane, which are parallel
  int sided = -1;            ///< a plane of which it sees a side
  bool joins_sides = false;  ///< two planes are turned over together, or neither
};

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

ElementEdge distance_edge(const ProblemStatement& problem, int a, int b) {
  return edge_of(problem, {"", "distance", {{a}, {b}}}).value();
}

/// Nothing where one is not between two elements.
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

/// The elements of a scene and the constraints between them.
struct ElementGraph {
  ElementGraph(const ProblemStatement& given, std::vector<ElementEdge> stated)
      : problem(given),
        edges(std::move(stated)),
        directions(given.entity_count()),
        sides(given.entity_count()) {
    for (const ElementEdge& edge : edges) {
      if (edge.shares_direction) directions.join(edge.ends[0], edge.ends[1]);
      if (edge.joins_sides) sides.join(edge.ends[0], edge.ends[1]);
    }
  }

  int freedoms(int entity) const {
    const int d = problem.dimension;
    return problem.is_point(entity) ? d : problem.is_line(entity) ? 2 * d - 2 : 3;
  }
  bool are_points(const std::array<int, 2>& ends) const {
    return problem.is_point(ends[0]) && problem.is_point(ends[1]);
  }

  const ProblemStatement& problem;
  std::vector<ElementEdge> edges;
  DisjointSets directions, sides;
};

/// The bound of one set; see placed_sets.
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

  /// Nothing where there are not as many equations as freedoms, or counting takes too long.
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

bool rests(const ProblemStatement& problem, int entity) {
  return problem.is_fixed(entity) ||
         std::ranges::count(bodies_with(problem, entity), problem.reference_body) > 0;
}

/// Places the elements of a scene one set after the other.
class PlacingInSets {
 public:
  PlacingInSets(const ElementGraph& graph, std::int64_t& states_left)
      : graph_(graph),
        states_left_(states_left),
        is_placed_(static_cast<std::size_t>(problem().entity_count())) {
    for (int entity = 0; entity < problem().entity_count(); ++entity)
      is_placed_[static_cast<std::size_t>(entity)] = rests(problem(), entity);
  }

  /// `frame`: points that are held first; empty where something rests.
  std::optional<std::vector<PlacedSet>> sets(const std::vector<int>& frame) {
    if (!frame.empty()) take({frame, frame, false, Natural(1)});
    for (bool goes_on = true; goes_on;)
      goes_on = place_hung_element() ||
                std::ranges::any_of(problem().bodies, [&](const RigidBody& body) { return place(body); });
    return place_rest() ? std::optional(std::move(sets_)) : std::nullopt;
  }

 private:
  const ProblemStatement& problem() const { return graph_.problem; }
  bool is_placed(int entity) const { return is_placed_[static_cast<std::size_t>(entity)]; }
  bool is_of_a_body(int entity) const { return !bodies_with(problem(), entity).empty(); }

  void take(PlacedSet set) {
    for (const int entity : set.elements) is_placed_[static_cast<std::size_t>(entity)] = true;
    sets_.push_back(std::move(set));
  }

  bool place(const std::vector<int>& elements, const std::vector<int>& held) {
    auto at_most = SetBound(graph_, elements, held).at_most(states_left_);
    if (at_most) take({elements, held, false, std::move(*at_most)});
    return at_most.has_value();
  }

  /// A body that is to be placed.
  struct Legged {
    std::set<int> moved, shared;    ///< its elements; what is shared is placed
    std::vector<ElementEdge> legs;  ///< constraints of what is moved with what is placed
    std::set<int> hips, feet;       ///< their ends on either side, and what is shared
  };

  Legged legged(const RigidBody& body) const {
    Legged result;
    for (const BodyElement& element : body.elements)
      (is_placed(element.entity) ? result.shared : result.moved).insert(element.entity);
    result.hips = result.feet = result.shared;
    for (const ElementEdge& edge : graph_.edges)
      for (const int side : {0, 1}) {
        const int end = edge.ends[static_cast<std::size_t>(side)];
        const int other = edge.ends[static_cast<std::size_t>(1 - side)];
        if (!result.moved.contains(end) || !is_placed(other)) continue;
        result.legs.push_back(edge);
        result.hips.insert(end);
        result.feet.insert(other);
      }
    return result;
  }

  bool has_legs_of_points(const Legged& body) const {
    return std::ranges::all_of(body.legs,
                               [&](const ElementEdge& leg) { return graph_.are_points(leg.ends); });
  }

  /// By distances of its points, one for each freedom that what is shared leaves.
  std::optional<Natural> postures(const Legged& body) const {
    struct Joint {
      std::array<int, 3> shared;  ///< points, lines, planes
      std::size_t legs;
      std::uint64_t postures;
    };
    constexpr std::array in_space{Joint{{0, 0, 0}, 6, 40}, Joint{{1, 0, 0}, 3, 8}, Joint{{2, 0, 0}, 1, 2},
                                  Joint{{0, 1, 0}, 2, 8}, Joint{{0, 0, 1}, 3, 6}};
    constexpr std::array in_the_plane{Joint{{0, 0, 0}, 3, 6}, Joint{{1, 0, 0}, 1, 2}, Joint{{0, 1, 0}, 1, 4}};
    const std::span<const Joint> known =
        problem().dimension == 3 ? std::span<const Joint>(in_space) : std::span<const Joint>(in_the_plane);
    std::array<int, 3> shared{};
    for (const int entity : body.shared)
      ++shared[problem().is_point(entity) ? 0 : problem().is_line(entity) ? 1 : 2];
    const auto joint = std::ranges::find(known, shared, &Joint::shared);
    if (joint == known.end() || joint->legs != body.legs.size() || !has_legs_of_points(body))
      return std::nullopt;
    return Natural(joint->postures);
  }

  /// By d corners on one side of all legs, of which the distances from each other are given: where they are on the other side,
  /// its points held, tells the posture.
  std::optional<Natural> places_of_corners(const Legged& body, const std::set<int>& corners) const {
    if (corners.size() != static_cast<std::size_t>(problem().dimension) ||
        !std::ranges::all_of(corners, [&](int entity) { return problem().is_point(entity); }))
      return std::nullopt;
    std::vector<int> elements, held;
    std::ranges::set_union(body.hips, body.feet, std::back_inserter(elements));
    std::set<int> moved;
    std::ranges::set_difference(corners, body.shared, std::inserter(moved, moved.end()));
    std::ranges::set_difference(elements, moved, std::back_inserter(held));
    std::vector<ElementEdge> edges = body.legs;
    for (const int a : corners)
      for (const int b : corners)
        if (a < b) edges.push_back(distance_edge(problem(), a, b));
    return SetBound(ElementGraph(problem(), std::move(edges)), elements, held).at_most(states_left_);
  }

  /// A body on legs; false where it is none, or is placed, or where no bound is known.
  bool place(const RigidBody& body) {
    const Legged on_legs = legged(body);
    if (on_legs.moved.empty()) return false;
    std::optional<Natural> fewest = postures(on_legs);
    const auto take_fewer = [&](const std::optional<Natural>& ways) {
      if (ways && (!fewest || *ways < *fewest)) fewest = ways;
    };
    take_fewer(places_of_corners(on_legs, on_legs.hips));
    if (has_legs_of_points(on_legs)) take_fewer(places_of_corners(on_legs, on_legs.feet));
    if (!fewest) return false;
    std::set<int> elements = on_legs.moved;
    elements.insert(on_legs.feet.begin(), on_legs.feet.end());
    take({{elements.begin(), elements.end()}, {}, true, std::move(*fewest)});
    return true;
  }

  /// One that has as many equations with what is placed as freedoms.
  bool place_hung_element() {
    for (int entity = 0; entity < problem().entity_count(); ++entity) {
      if (is_placed(entity) || is_of_a_body(entity)) continue;
      std::vector<int> held;
      int equations = 0;
      for (const ElementEdge& edge : graph_.edges) {
        const int other = edge.ends[edge.ends[0] == entity ? 1 : 0];
        if (std::ranges::count(edge.ends, entity) == 0 || !is_placed(other)) continue;
        if (std::ranges::count(held, other) == 0) held.push_back(other);
        equations += edge.polynomials.count;
      }
      if (equations != graph_.freedoms(entity)) continue;
      std::vector<int> elements = held;
      elements.push_back(entity);
      if (place(elements, held)) return true;
    }
    return false;
  }

  /// All in one set. False where it has bodies.
  bool place_rest() {
    std::vector<int> all, held;
    for (int entity = 0; entity < problem().entity_count(); ++entity) {
      all.push_back(entity);
      if (is_placed(entity))
        held.push_back(entity);
      else if (is_of_a_body(entity))
        return false;
    }
    return held.size() == all.size() || place(all, held);
  }

  const ElementGraph& graph_;
  std::int64_t& states_left_;
  std::vector<bool> is_placed_;
  std::vector<PlacedSet> sets_;
};

/// Points that can be held because all their distances are given, in every way; one empty set where something rests.
std::vector<std::vector<int>> frames_of(const ElementGraph& graph) {
  const ProblemStatement& problem = graph.problem;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (rests(problem, entity)) return {{}};
  const auto points = static_cast<int>(problem.points.size());
  const auto are_joined = [&](int a, int b) {
    return std::ranges::any_of(graph.edges, [&](const ElementEdge& edge) {
      return edge.ends == std::array{a, b} || edge.ends == std::array{b, a};
    });
  };
  std::vector<std::vector<int>> frames;
  for (int a = 0; a < points; ++a)
    for (int b = a + 1; b < points; ++b) {
      if (!are_joined(a, b)) continue;
      if (problem.dimension == 2) frames.push_back({a, b});
      for (int c = b + 1; c < points && problem.dimension == 3; ++c)
        if (are_joined(a, c) && are_joined(b, c)) frames.push_back({a, b, c});
    }
  return frames;
}

}  // namespace

Natural ways_to_place(const std::vector<PlacedSet>& sets) {
  Natural product(1);
  for (const PlacedSet& set : sets) product = product * set.at_most;
  return product;
}

std::optional<std::vector<PlacedSet>> placed_sets(const ProblemStatement& problem) {
  auto edges = edges_of(problem);
  if (!edges || problem.file_frame) return std::nullopt;
  const ElementGraph graph(problem, std::move(*edges));
  std::int64_t states_left = most_states_of_sets;
  std::optional<std::vector<PlacedSet>> fewest;
  for (const std::vector<int>& frame : frames_of(graph)) {
    auto sets = PlacingInSets(graph, states_left).sets(frame);
    if (sets && (!fewest || ways_to_place(*sets) < ways_to_place(*fewest))) fewest = std::move(sets);
  }
  return fewest;
}

}  // namespace gcs
