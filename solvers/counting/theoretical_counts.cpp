/// A point that hangs on d others is on d spheres around them, which at generic lengths meet in two points of
/// C^d: it doubles the number of solutions, and leaves the rest as it is. So counting begins with the core.

#include "solvers/counting/theoretical_counts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solvers/counting/bezout_bound.hpp"
#include "solvers/counting/general_bound.hpp"
#include "solvers/counting/realisation_count.hpp"
#include "solvers/counting/ring_bound.hpp"
#include "solvers/counting/wheel_bound.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/stated_signs.hpp"
#include "solvers/structure/core_reduction.hpp"
#include "solvers/structure/sub_problem.hpp"

namespace gcs {
namespace {

using Edge = std::array<int, 2>;
using References = std::vector<std::vector<int>>;  ///< sets of points that make a frame

bool is_zero_length(const DistanceConstraint& constraint) { return constraint.given.value == 0; }

SolutionCount count_in_frame(const ProblemStatement& problem, Natural fixed_frame) {
  return {std::move(fixed_frame), frame_images(problem)};
}

/// Points of a part of the problem by consecutive numbers.
struct PointGraph {
  std::vector<int> points;  ///< the point of each number
  std::vector<Edge> edges;
};

int number_of(const PointGraph& graph, int point) {
  return static_cast<int>(std::find(graph.points.begin(), graph.points.end(), point) - graph.points.begin());
}

PointGraph core_graph(const ProblemStatement& problem, const CoreReduction& reduction) {
  PointGraph graph{reduction.core, {}};
  for (const int constraint : reduction.core_constraints) {
    const auto& [a, b] = problem.constraints[constraint].between;
    graph.edges.push_back({number_of(graph, a), number_of(graph, b)});
  }
  return graph;
}

PointGraph whole_graph(const ProblemStatement& problem) {
  PointGraph graph;
  for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) graph.points.push_back(point);
  for (const DistanceConstraint& constraint : problem.constraints)
    if (problem.is_point(constraint.between[0]) && problem.is_point(constraint.between[1]))
      graph.edges.push_back(constraint.between);
  return graph;
}

/// Pairs, or in space triples, of points with all their distances given.
References reference_simplices(const PointGraph& graph, int dimension) {
  const std::size_t count = graph.points.size();
  std::vector<std::vector<bool>> joined(count, std::vector<bool>(count, false));
  for (const auto& [a, b] : graph.edges) joined[a][b] = joined[b][a] = true;
  References simplices;
  for (const auto& [a, b] : graph.edges) {
    if (dimension == 2) simplices.push_back({std::min(a, b), std::max(a, b)});
    for (int c = std::max(a, b) + 1; dimension == 3 && c < static_cast<int>(count); ++c)
      if (joined[a][c] && joined[b][c]) simplices.push_back({std::min(a, b), std::max(a, b), c});
  }
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

/// The points of the whole problem.
std::vector<int> points_of(const PointGraph& graph, std::vector<int> numbers) {
  for (int& number : numbers) number = graph.points[number];
  return numbers;
}

constexpr const char* bound_takes_too_long =
    "The constraint graph hangs together too widely: counting its orientations would take too long.";

std::optional<CountBound> bezout_bound_of_points(const ProblemStatement& problem, const PointGraph& graph,
                                                 const References& references) {
  const BoundProblem part{problem.dimension, graph.edges, std::vector<bool>(graph.points.size(), false),
                          references};
  const auto smallest = smallest_bezout_bound(part);
  if (!smallest) return std::nullopt;
  CountBound bound{
      count_in_frame(problem, smallest->fixed_frame), points_of(graph, references[smallest->reference]), {}};
  for (const std::vector<int>& points : smallest->at_infinity)
    bound.at_infinity.push_back(points_of(graph, points));
  return bound;
}

std::optional<CountBound> ring_bound_of_points(const ProblemStatement& problem, const PointGraph& graph,
                                               const References& references) {
  if (problem.dimension != 3) return std::nullopt;
  const auto found = ring_bound(static_cast<int>(graph.points.size()), graph.edges, references);
  if (!found) return std::nullopt;
  CountBound bound{count_in_frame(problem, found->fixed_frame), points_of(graph, references.front()), {}};
  for (const std::vector<int>& body : found->bodies) bound.ring.push_back(points_of(graph, body));
  return bound;
}

/// Of equal bounds the m-Bézout bound, unless it is less solutions at infinity.
bool is_preferred(const CountBound& of_ring, const CountBound& bezout) {
  const auto order = of_ring.count.fixed_frame <=> bezout.count.fixed_frame;
  return order < 0 || (order == 0 && !bezout.at_infinity.empty());
}

/// Of a problem of points, by the simplices of the given part of it; the rest hangs on this part.
void bound_points(const ProblemStatement& problem, const PointGraph& graph, TheoreticalCounts& counts) {
  const auto references = reference_simplices(graph, problem.dimension);
  if (references.empty()) {
    counts.why_no_bound =
        "No three points have all their distances given, and the bound needs such a triangle.";
    return;
  }
  counts.bound = bezout_bound_of_points(problem, graph, references);
  const auto of_ring = ring_bound_of_points(problem, graph, references);
  if (of_ring && (!counts.bound || is_preferred(*of_ring, *counts.bound))) counts.bound = of_ring;
  if (!counts.bound) {
    counts.why_no_bound = bound_takes_too_long;
    return;
  }
  const int hanging = static_cast<int>(problem.points.size() - graph.points.size());
  Natural& fixed_frame = counts.bound->count.fixed_frame;
  fixed_frame = Natural::power_of_two(hanging) * fixed_frame;
}

/// Without a point that is joined to all others. Nothing where there is none.
std::optional<GraphEdges> base_of_cone(const PointGraph& graph) {
  for (int apex = 0; apex < static_cast<int>(graph.points.size()); ++apex) {
    GraphEdges base = graph.edges;
    std::erase_if(base, [apex](const Edge& edge) { return edge[0] == apex || edge[1] == apex; });
    if (base.size() + graph.points.size() == graph.edges.size() + 1) return base;
  }
  return std::nullopt;
}

/// In space the other points of a cone are seen from its apex on a sphere, as generic there as their distances are.
void count_exactly(const ProblemStatement& problem, const CoreReduction& reduction, const PointGraph& core,
                   const RecursionLimits& limits, TheoreticalCounts& counts) {
  const bool is_planar = problem.dimension == 2;
  std::optional<Natural> of_core;
  if (reduction.core_is_trivial)
    of_core = Natural(1);
  else if (is_planar)
    of_core = count_in_plane(core.edges, limits);
  else if (const auto base = base_of_cone(core))
    of_core = count_on_sphere(*base, limits);
  else
    counts.why_no_exact =
        "In space no method gives the exact number unless the points can be placed one by one, or one is "
        "joined to all others.";
  if (of_core)
    counts.exact =
        count_in_frame(problem, Natural::power_of_two(static_cast<int>(reduction.placed.size())) * *of_core);
  else if (counts.why_no_exact.empty())
    counts.why_no_exact = why_given_up(is_planar ? "bigraphs" : "cross ratios", core.points.size(), limits);
}

/// In the core, or, when it has no triangle, with the points that hang on it.
void count_undivided(const ProblemStatement& problem, const RecursionLimits& limits,
                     TheoreticalCounts& counts) {
  const CoreReduction reduction = reduce_to_core(problem, {});
  const PointGraph core = core_graph(problem, reduction);
  count_exactly(problem, reduction, core, limits, counts);
  const bool core_has_reference = !reference_simplices(core, problem.dimension).empty();
  bound_points(problem, core_has_reference ? core : whole_graph(problem), counts);
}

/// The counts of the parts that are solved apart, and of hung points.
struct PartCounts {
  std::vector<TheoreticalCounts> solved;
  std::vector<int> first;  ///< the points of the first part
  int hung = 0;
};

PartCounts counts_of_parts(const ProblemStatement& problem, const std::vector<Part>& parts,
                           const RecursionLimits& limits) {
  PartCounts counts;
  for (const Part& part : parts) {
    if (part.is_hung_point()) {
      ++counts.hung;
      continue;
    }
    const PartProblem alone = part_problem(problem, part);
    if (counts.solved.empty()) counts.first = alone.points;
    count_undivided(alone.problem, limits, counts.solved.emplace_back());
  }
  return counts;
}

/// With the base of a part held fixed its solutions in the frame are as many, whatever the others are.
void multiply(const ProblemStatement& problem, const PartCounts& parts, TheoreticalCounts& counts) {
  Natural exact = Natural::power_of_two(parts.hung), bound = exact;
  for (const TheoreticalCounts& part : parts.solved) {
    if (part.exact) exact = exact * part.exact->fixed_frame;
    if (part.bound) bound = bound * part.bound->count.fixed_frame;
    if (counts.why_no_exact.empty()) counts.why_no_exact = part.why_no_exact;
    if (counts.why_no_bound.empty()) counts.why_no_bound = part.why_no_bound;
  }
  if (counts.why_no_exact.empty()) counts.exact = count_in_frame(problem, std::move(exact));
  if (!counts.why_no_bound.empty()) return;
  std::vector<int> reference = parts.solved.front().bound->reference;
  for (int& point : reference) point = parts.first[point];
  counts.bound = CountBound{count_in_frame(problem, std::move(bound)),
                            std::move(reference),
                            {},
                            static_cast<int>(parts.solved.size())};
}

void count_points(const ProblemStatement& problem, const std::vector<Part>& parts,
                  const RecursionLimits& limits, TheoreticalCounts& counts) {
  const PartCounts of_parts = counts_of_parts(problem, parts, limits);
  if (of_parts.solved.size() > 1)
    multiply(problem, of_parts, counts);
  else
    count_undivided(problem, limits, counts);
}

void bound_points_and_line(const ProblemStatement& problem, TheoreticalCounts& counts) {
  const PointGraph graph = whole_graph(problem);
  BoundProblem whole{problem.dimension, graph.edges, std::vector<bool>(graph.points.size(), false), {}};
  for (const DistanceConstraint& constraint : problem.constraints)
    for (const int side : {0, 1}) {
      const int point = constraint.between[side];
      if (problem.is_point(constraint.between[1 - side])) continue;
      whole.on_line[point] = true;
      if (!is_zero_length(constraint)) whole.references.push_back({point});
    }
  if (whole.references.empty()) {
    counts.why_no_bound = "No point has a given distance above 0 from the line to make a frame with it.";
    return;
  }
  const bool are_beside = whole.references.size() == problem.points.size();
  if (const auto of_wheel = are_beside ? wheel_bound(whole) : std::nullopt) {
    counts.bound = CountBound{count_in_frame(problem, *of_wheel), {}, {}};
    counts.bound->theorem = "points in a wheel beside a line: 4ⁿ/2 − (1 + √3)ⁿ − (1 − √3)ⁿ for n spokes";
    return;
  }
  const auto smallest = smallest_bezout_bound(whole);
  if (!smallest) {
    counts.why_no_bound = bound_takes_too_long;
    return;
  }
  const int point = whole.references[smallest->reference].front();
  const int line = static_cast<int>(problem.points.size());
  counts.bound = CountBound{count_in_frame(problem, smallest->fixed_frame), {line, point}, {}};
}

std::vector<int> given_points(const ProblemStatement& problem) {
  std::vector<int> given;
  for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
    if (problem.is_fixed(point)) given.push_back(point);
  return given;
}

/// Without positions, and with the first two given points at a distance from each other and from all others.
ProblemStatement with_bars_between(ProblemStatement problem, const std::vector<int>& given) {
  std::ranges::fill(problem.fixed_points, std::nullopt);
  problem.fixed_texts.clear();
  for (std::size_t i = 1; i < given.size(); ++i)
    for (std::size_t j = 0; j < std::min<std::size_t>(i, 2); ++j)
      problem.constraints.push_back({"", {given[i], given[j]}, {1, "1"}, false});
  return problem;
}

/// In the plane all given points but two have two places each where bars hold them, with equally many figures, as their
/// positions are one irreducible family. In space they are held in the m-Bézout bound. Either limit holds wherever they are:
/// isolated figures go on where they are moved.
void count_around_given_points(const ProblemStatement& problem, const std::vector<int>& given,
                               const RecursionLimits& limits, TheoreticalCounts& counts) {
  if (problem.dimension == 2) {
    const TheoreticalCounts barred = theoretical_counts(with_bars_between(problem, given), limits);
    if (barred.exact) {
      Natural count = barred.exact->fixed_frame;
      for (std::size_t i = 2; i < given.size(); ++i) count = count / 2U;
      counts.exact = count_in_frame(problem, std::move(count));
    }
    counts.why_no_exact = barred.why_no_exact;
  } else {
    counts.why_no_exact =
        "Positions are fixed, and in space the exact number is known only where nothing is.";
  }
  const PointGraph graph = whole_graph(problem);
  counts.bound = bezout_bound_of_points(problem, graph, {given});
  if (!counts.bound) counts.why_no_bound = bound_takes_too_long;
}

/// For centres that span space the point of the line is eliminated linearly, and its direction is left to a
/// cubic and a quartic in the projective plane: 12 lines, by Bézout (Macdonald, Pach, Theobald, Common
/// tangents to four unit balls in R³, 2001; Hoffmann, Yuan 2000). Isolated lines persist when centres and
/// radii are moved, so no four centres have more: for each solution of what the lines hang on. Nothing where
/// no line hangs, or where that has no limit.
std::optional<CountBound> bound_with_hung_lines(const ProblemStatement& problem) {
  std::vector<bool> is_left = hung_lines(problem);
  const auto lines = static_cast<int>(std::count(is_left.begin(), is_left.end(), true));
  if (lines == 0) return std::nullopt;
  is_left.flip();
  const ProblemStatement rest = sub_problem(problem, is_left).problem;
  CountBound bound{{Natural(1), frame_images(problem)}, {}, {}, lines};
  bool is_given = true;
  for (int entity = 0; entity < rest.entity_count(); ++entity) is_given = is_given && rest.is_fixed(entity);
  if (!is_given) {
    const TheoreticalCounts counts = theoretical_counts(rest);
    if (!counts.upper_limit()) return std::nullopt;
    bound.count.fixed_frame = counts.upper_limit()->up_to_reflection();
    bound.parts += counts.bound ? counts.bound->parts : 1;
  }
  for (int line = 0; line < lines; ++line) bound.count.fixed_frame = bound.count.fixed_frame * Natural(12);
  bound.count.fixed_frame =
      bound.count.fixed_frame * Natural(static_cast<std::uint64_t>(bound.count.images.in_frame));
  return bound;
}

/// The smaller of two bounds; that by its parts if they are equal.
void bound_beyond_points(const ProblemStatement& problem, const RecursionLimits& limits,
                         TheoreticalCounts& counts) {
  if (const std::vector<int> given = given_points(problem);
      problem.lines.empty() && static_cast<int>(given.size()) >= problem.dimension && !problem.file_frame)
    return count_around_given_points(problem, given, limits, counts);
  const std::optional<CountBound> by_parts = bound_with_hung_lines(problem);
  counts.why_no_exact = problem.is_anchored() && !by_parts
                            ? "Positions are fixed, and the count is known only where nothing is."
                            : "There is a line, and the exact number is known only for points.";
  if (problem.is_anchored())
    counts.why_no_bound = "Positions are fixed, and the bound is known only where nothing is.";
  else if (problem.lines.size() == 1)
    bound_points_and_line(problem, counts);
  else
    counts.why_no_bound = "There is more than one line, and the bound is known for one at most.";
  if (!by_parts ||
      (counts.bound && counts.bound->count.up_to_reflection() < by_parts->count.up_to_reflection()))
    return;
  counts.bound = by_parts;
  counts.why_no_bound.clear();
}

/// Of points with distances between them, of which one has a position, which leaves all rotations; nothing for others.
std::optional<TheoreticalCounts> counts_without_positions(const ProblemStatement& problem) {
  if (!problem.file_frame || has_given_shape(problem)) return std::nullopt;
  const std::vector<bool> all(static_cast<std::size_t>(problem.entity_count()), true);
  const ProblemStatement free = sub_problem(problem, all).problem;
  if (free.is_general() || !free.lines.empty()) return std::nullopt;
  TheoreticalCounts counts = theoretical_counts(free);
  if (counts.exact) counts.exact->images = frame_images(problem);
  if (counts.bound) counts.bound->count.images = frame_images(problem);
  return counts;
}

/// Orientations are no equations, but tell mirror images apart; nothing for problems without them.
std::optional<TheoreticalCounts> counts_without_orientations(const ProblemStatement& problem) {
  const std::optional<ProblemStatement> free = without_orientations(problem);
  if (!free) return std::nullopt;
  TheoreticalCounts counts = theoretical_counts(*free);
  const auto with_images_apart = [&](SolutionCount count) {
    const bool are_pairs = count.images.in_frame > 1;
    return SolutionCount{are_pairs ? Natural(2) * count.up_to_reflection() : count.fixed_frame,
                         frame_images(problem)};
  };
  if (counts.exact) counts.exact = with_images_apart(*counts.exact);
  if (!counts.bound) return counts;
  SolutionCount& count = counts.bound->count;
  count = with_images_apart(count);
  if (const std::optional<Natural> figures = std::exchange(counts.bound->figures, std::nullopt))
    count.fixed_frame = std::min(count.fixed_frame, *figures);
  return counts;
}

}  // namespace

TheoreticalCounts theoretical_counts(const ProblemStatement& problem, const RecursionLimits& limits) {
  if (problem.is_general()) return theoretical_counts(problem, element_order(Scene::unchecked(problem)));
  return theoretical_counts(problem, decompose(problem, Split::all), limits);
}

TheoreticalCounts theoretical_counts(const ProblemStatement& problem, const std::vector<Part>& parts,
                                     const RecursionLimits& limits) {
  TheoreticalCounts counts;
  if (problem.lines.empty() && !problem.is_anchored())
    count_points(problem, parts, limits, counts);
  else
    bound_beyond_points(problem, limits, counts);
  return counts;
}

TheoreticalCounts theoretical_counts(const ProblemStatement& problem,
                                     const std::optional<ElementOrder>& order) {
  if (const auto counts = counts_without_orientations(problem)) return *counts;
  if (const auto counts = counts_without_positions(problem)) return *counts;
  return general_counts(problem, order,
                        [](const ProblemStatement& core) { return theoretical_counts(core); });
}

}  // namespace gcs
