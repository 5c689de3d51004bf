#include "solvers/counting/element_bound.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "solvers/counting/set_bound.hpp"

namespace gcs {
namespace {

/// Of all sets together: a fraction of a second.
constexpr std::int64_t most_states_of_sets = 500'000;

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
    auto at_most = places_of_set(graph_, elements, held, states_left_);
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
    return places_of_set(ElementGraph(problem(), std::move(edges)), elements, held, states_left_);
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
