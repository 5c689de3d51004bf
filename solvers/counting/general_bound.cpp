#include "solvers/counting/general_bound.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "solvers/counting/element_bound.hpp"
#include "solvers/counting/ring_bound.hpp"
#include "solvers/counting/system_bound.hpp"
#include "solvers/counting/three_lines_bound.hpp"
#include "solvers/structure/octahedral_pairs.hpp"

namespace gcs {
namespace {

using Edge = std::array<int, 2>;
using References = std::vector<std::vector<int>>;

/// Nothing but two bodies and as many distances between points of both as they have freedoms against each other.
bool is_platform(const ProblemStatement& problem) {
  const std::size_t freedoms = problem.dimension == 3 ? 6 : 3;
  if (problem.bodies.size() != 2 || !problem.lines.empty() || !problem.planes.empty() ||
      !problem.relations.empty() || problem.constraints.size() != freedoms || problem.is_anchored())
    return false;
  for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
    if (bodies_with(problem, point).size() != 1) return false;
  return std::all_of(problem.constraints.begin(), problem.constraints.end(),
                     [&](const DistanceConstraint& c) {
                       return bodies_with(problem, c.between[0]) != bodies_with(problem, c.between[1]);
                     });
}

constexpr const char* by_sets = "the m-Bézout bounds of its elements, placed one set after the other";

/// Isolated postures persist when bodies and lengths are moved, so that no platform has more than a general one.
void bound_platform(const ProblemStatement& problem, TheoreticalCounts& counts) {
  const bool is_spatial = problem.dimension == 3;
  counts.bound = CountBound{{Natural(is_spatial ? 40 : 6), frame_images(problem)}, {}, {}};
  counts.bound->theorem =
      is_spatial ? "two bodies and six distances: 40 postures, Ronga and Vust 1992, Mourrain 1993"
                 : "two bodies and three distances in the plane: 6 postures, Hunt 1983";
  const auto sets = placed_sets(problem);
  if (!sets || !(ways_to_place(*sets) < counts.bound->count.fixed_frame)) return;
  counts.bound->count.fixed_frame = ways_to_place(*sets);
  counts.bound->theorem = by_sets;
}

/// Nothing but six bodies in a ring, each hinged to the next: ring_bound.hpp's, with their shapes.
bool is_hinged_ring(const ProblemStatement& problem) {
  if (problem.dimension != 3 || problem.bodies.size() != 6 || !problem.relations.empty() ||
      !problem.constraints.empty() || problem.is_anchored())
    return false;
  for (int entity = static_cast<int>(problem.points.size()); entity < problem.entity_count(); ++entity)
    if (bodies_with(problem, entity).size() != 1) return false;
  std::set<std::vector<int>> bodies;
  std::set<Edge> edges;
  References triangles;
  for (const RigidBody& body : problem.bodies) {
    std::vector<int> points;
    for (const BodyElement& element : body.elements)
      if (problem.is_point(element.entity)) points.push_back(element.entity);
    std::sort(points.begin(), points.end());
    for (std::size_t c = 0; c < points.size(); ++c)
      for (std::size_t b = 0; b < c; ++b) {
        edges.insert({points[b], points[c]});
        for (std::size_t a = 0; a < b; ++a) triangles.push_back({points[a], points[b], points[c]});
      }
    bodies.insert(std::move(points));
  }
  const auto ring =
      ring_bound(static_cast<int>(problem.points.size()), {edges.begin(), edges.end()}, triangles);
  return ring && std::set(ring->bodies.begin(), ring->bodies.end()) == bodies;
}

void bound_hinged_ring(const ProblemStatement& problem, TheoreticalCounts& counts) {
  counts.bound = CountBound{{Natural(16), frame_images(problem)}, {}, {}};
  counts.bound->theorem =
      "six bodies in a ring, each hinged to the next: 16 postures, Primrose 1986, Lee and Liang 1988";
}

/// Whether a step hangs on distances of its points from others alone.
bool hangs_on_distances(const ProblemStatement& problem, const PlacingStep& step) {
  const auto is_placed = [&](int entity) {
    return std::find(step.entities.begin(), step.entities.end(), entity) != step.entities.end();
  };
  const auto is_of_step = [&](const Relation& relation) {
    return std::any_of(relation.of.begin(), relation.of.end(), [&](const Operand& of) {
      return is_placed(of.entity) || (of.is_segment() && is_placed(of.end));
    });
  };
  const auto shared = [&](int entity) { return bodies_with(problem, entity).size() > 1; };
  return std::none_of(problem.relations.begin(), problem.relations.end(), is_of_step) &&
         std::none_of(step.entities.begin(), step.entities.end(), shared) &&
         std::all_of(step.entities.begin(), step.entities.end(),
                     [&](int entity) { return problem.is_point(entity); });
}

/// In how many ways a step is placed on one place of what is there, at most: by theorems, otherwise by Bézout. Isolated
/// ways persist when that place is moved, so that only isolated ones of it count.
Natural most_ways(const ProblemStatement& problem, const PlacingStep& step) {
  if (step.bodies == 0 && hung_lines(problem)[static_cast<std::size_t>(step.entities[0])]) return Natural(12);
  if (step.bodies < 2 && hangs_on_distances(problem, step))
    return Natural(step.bodies == 0 ? 2 : (problem.dimension == 3 ? 40 : 6));
  return Natural::power_of_two(step.quadratic - turnings(step.signs));
}

/// The product of the bounds of what is solved apart or placed after the rest.
void bound_in_order(const ProblemStatement& problem, const ElementOrder& order, const CountsOf& counts_of,
                    TheoreticalCounts& counts) {
  CountBound bound{{Natural(1), frame_images(problem)}, {}, {}, static_cast<int>(order.steps.size())};
  for (const PlacingStep& step : order.steps) {
    if (!step.is_core()) {
      bound.count.fixed_frame = bound.count.fixed_frame * most_ways(problem, step);
      continue;
    }
    const TheoreticalCounts of_core = counts_of(step.alone->problem);
    if (!of_core.upper_limit()) {
      counts.why_no_bound = of_core.why_no_bound;
      return;
    }
    bound.count.fixed_frame = bound.count.fixed_frame * of_core.upper_limit()->fixed_frame;
  }
  counts.bound = std::move(bound);
  counts.why_no_bound.clear();
}

/// Of each opposite pair one is a point, and these three are the frame. What is opposite keeps two pairs with them and
/// moves on a conic: a point on a circle, a plane (n, h) where two linear equations leave n·n = 1 one unknown. On a circle
/// p·p is linear in p, so that the three pairs that are left are linear in each of two conics: of bidegree (2, 2) in their
/// parameters, and on (P¹)³ (2a + 2b)(2b + 2c)(2c + 2a) = 16abc, of which the frame's mirror makes 8. Isolated figures
/// persist when values are moved, so that special ones leave no more.
void bound_octahedron_with_planes(const ProblemStatement& problem, TheoreticalCounts& counts) {
  counts.bound = CountBound{{Natural(16), frame_images(problem)}, {}, {}};
  counts.bound->theorem = "an octahedron of points and planes: three elements, each on a conic, by Bézout";
}

/// By the scene's equations, or its elements in sets, where that is less.
void bound_by_equations(const ProblemStatement& problem, TheoreticalCounts& counts) {
  const Scene scene = Scene::unchecked(problem);
  if (why_no_system(scene)) return;
  const SceneSystem system(scene);
  const FrameImages images = frame_images(problem);
  const auto take = [&](const std::optional<Natural>& classes, const char* theorem) {
    if (!classes || (counts.bound && !(*classes < counts.bound->count.up_to_reflection()))) return;
    counts.bound =
        CountBound{{*classes * Natural(static_cast<std::uint64_t>(images.in_frame)), images}, {}, {}};
    counts.bound->theorem = theorem;
    counts.why_no_bound.clear();
  };
  const auto sets = placed_sets(problem);
  const auto figures = sets ? std::optional(ways_to_place(*sets)) : std::nullopt;
  const bool has_pairs = figures && images.in_frame == 2 && divides_by_all(system.equations());
  take(has_pairs ? *figures / 2U : figures, by_sets);
  take(class_bound(system), "the m-Bézout bound of its equations, with groups of unknowns");
  if (figures && images.in_frame == 2) counts.bound->figures = figures;
}

void bound_three_lines(const ProblemStatement& problem, std::uint64_t most, TheoreticalCounts& counts) {
  counts.bound = CountBound{{Natural(most), frame_images(problem)}, {}, {}};
  counts.bound->theorem =
      "three points and three lines: the lines at given distances from the points, by their directions";
}

void bound_by_products(const ProblemStatement& problem, const std::optional<ElementOrder>& order,
                       const CountsOf& counts_of, TheoreticalCounts& counts) {
  counts.why_no_bound =
      "No theorem is known for scenes of its kind, and it has no square system of equations.";
  if (order) bound_in_order(problem, *order, counts_of, counts);
  bound_by_equations(problem, counts);
}

}  // namespace

std::vector<bool> hung_lines(const ProblemStatement& problem) {
  std::vector<int> distances(static_cast<std::size_t>(problem.entity_count()));
  for (const DistanceConstraint& c : problem.constraints)
    for (const int entity : c.between) ++distances[static_cast<std::size_t>(entity)];
  std::vector<bool> hung;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    hung.push_back(problem.is_line(entity) && !problem.is_fixed(entity) &&
                   distances[static_cast<std::size_t>(entity)] == 4);
  return hung;
}

TheoreticalCounts general_counts(const ProblemStatement& problem, const std::optional<ElementOrder>& order,
                                 const CountsOf& counts_of) {
  TheoreticalCounts counts;
  counts.why_no_exact = "The exact number is known only for points with distances between them.";
  if (is_platform(problem))
    bound_platform(problem, counts);
  else if (is_hinged_ring(problem))
    bound_hinged_ring(problem, counts);
  else if (!problem.is_anchored() && find_octahedron_with_planes(problem))
    bound_octahedron_with_planes(problem, counts);
  else if (const auto most = three_lines_bound(problem))
    bound_three_lines(problem, *most, counts);
  else
    bound_by_products(problem, order, counts_of, counts);
  return counts;
}

}  // namespace gcs
