#include "harness/results/certificate_io.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/results/decimal_json.hpp"
#include "harness/solving/frame_view.hpp"
#include "solvers/certificates/dyadic_figure.hpp"
#include "solvers/certificates/solutions_at_infinity.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {
namespace {

struct ProvenFigure {
  DyadicFigure figure;
  bool is_real;
};

JsonValue solution_value(const ProvenFigure& proven, int dimension) {
  const auto point_value = [&](const DecimalVector& point) {
    return json_decimals(point, dimension, proven.is_real);
  };
  return json_object({{"real", json_boolean(proven.is_real)},
                      {"exponent", json_number(proven.figure.exponent)},
                      {"radius", json_text(std::to_string(DyadicFigure::radius))},
                      {"points", json_array_of(proven.figure.points, point_value)}});
}

JsonValue names_value(const ProblemStatement& problem, const std::vector<int>& points) {
  return json_array_of(points, [&](int point) { return json_text(problem.name(point)); });
}

JsonValue escape_value(const ProblemStatement& problem, const std::vector<Escape>& way,
                       const Escape& escape) {
  const auto crossed =
      std::ranges::find_if(way, [&](const Escape& other) { return other.number == escape.walk.across; });
  return json_object(
      {{"points", names_value(problem, escape.points)},
       {"walk", names_value(problem, escape.walk.corners)},
       {"signs", json_array_of(escape.walk.signs, json_number)},
       {"across",
        crossed == way.end() ? json_null() : json_count(static_cast<std::uint64_t>(crossed - way.begin()))}});
}

JsonValue box_value(const DyadicAtInfinity::Solution& solution) {
  const auto number = [](const DecimalNumber& one) { return json_decimal(one, false); };
  return json_object({{"way", json_count(solution.way)},
                      {"exponent", json_number(solution.box.exponent)},
                      {"radius", json_text(std::to_string(DyadicFigure::radius))},
                      {"numbers", json_array_of(solution.box.numbers, number)}});
}

/// Null where nothing is proven there.
JsonValue at_infinity_value(const Scene& scene, const Answer& answer) {
  std::vector<Figure> near;
  for (const Figure& figure : answer.escaping) near.push_back(scene.in_scene_unit(figure));
  const DyadicAtInfinity proven = dyadic_at_infinity(scene, near, answer.threads);
  if (proven.solutions.empty()) return json_null();
  const ProblemStatement& problem = scene.problem();
  const auto name = [&](int point) { return json_text(problem.name(point)); };
  const auto way_value = [&](const std::vector<Escape>& way) {
    return json_array_of(way, [&](const Escape& escape) { return escape_value(problem, way, escape); });
  };
  return json_object({{"frame", json_object({{"origin", name(proven.frame.origin)},
                                             {"axis", name(proven.frame.axis)},
                                             {"plane", name(proven.frame.plane)}})},
                      {"unit", json_number(scene.unit_exponent())},
                      {"ways", json_array_of(proven.ways, way_value)},
                      {"solutions", json_array_of(proven.solutions, box_value)}});
}

/// By the exact number of a part or its bound; nothing where there is none, or it is not of the part as a whole.
std::optional<JsonMembers> part_argument(const ProblemStatement& part) {
  const TheoreticalCounts counts = theoretical_counts(part);
  if (part.dimension == 2 && counts.exact)
    return JsonMembers{{"argument", json_text("realisation count")},
                       {"at_most", json_count(counts.exact->fixed_frame)}};
  if (!counts.bound || counts.bound->parts != 1) return std::nullopt;
  const CountBound& bound = *counts.bound;
  const JsonValue at_most = json_count(bound.count.fixed_frame);
  if (bound.ring.empty())
    return JsonMembers{{"argument", json_text("m-Bézout bound")},
                       {"at_most", at_most},
                       {"held", names_value(part, bound.reference)}};
  const auto body_value = [&](const std::vector<int>& body) { return names_value(part, body); };
  return JsonMembers{{"argument", json_text("ring of bodies")},
                     {"at_most", at_most},
                     {"bodies", json_array_of(bound.ring, body_value)}};
}

/// How many solutions there can be: of each part while those before it are held, or null.
JsonValue limit_value(const ProblemStatement& problem) {
  std::vector<JsonValue> values;
  for (const Part& part : decompose(problem, Split::all)) {
    std::optional<JsonMembers> members;
    if (part.is_hung_point())
      members = JsonMembers{{"argument", json_text("hung point")}, {"at_most", json_number(2)}};
    else
      members = part_argument(part_problem(problem, part).problem);
    if (!members) return json_null();
    std::vector<int> points = part.base;
    points.insert(points.end(), part.points.begin(), part.points.end());
    members->emplace_back("points", names_value(problem, points));
    values.push_back(json_object(std::move(*members)));
  }
  return json_array(std::move(values));
}

std::vector<ProvenFigure> proven_figures(const Scene& scene, const Answer& answer) {
  std::vector<Figure> certified;
  for (const AssessedSolution& solution : answer.solutions)
    if (solution.certified) certified.push_back(solution.figure);
  const auto figures = dyadic_figures(SceneEquations(scene), scene, certified, answer.threads);
  std::vector<ProvenFigure> proven;
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (figures[i]) proven.push_back({*figures[i], certified[i].is_real()});
  return proven;
}

}  // namespace

void require_certifiable(const Instance& instance) {
  const ProblemStatement& problem = instance.problem;
  if (!problem.is_general() && problem.lines.empty() && !problem.is_anchored()) return;
  throw InputError(instance.origin,
                   problem.is_general()    ? "/format"
                   : problem.lines.empty() ? "/fixed"
                                           : "/lines",
                   "a certificate is of points with distances between them, none with a given position",
                   "leave out --certificate; --certify proves more");
}

std::size_t write_certificate(const Instance& instance, const Scene& scene, const Answer& answer,
                              const TextSink& take) {
  const std::vector<ProvenFigure> proven = proven_figures(scene, answer);
  const auto real =
      std::count_if(proven.begin(), proven.end(), [](const ProvenFigure& p) { return p.is_real; });
  DocumentWriter document("gcsbench-certificate/1", take, answer.threads);
  document.member("instance", instance.document);
  document.member("frame", frame_value(scene));
  document.member("complex", json_count(proven.size()));
  document.member("real", json_count(static_cast<std::uint64_t>(real)));
  document.member("limit", limit_value(instance.problem));
  document.list("solutions", proven,
                [&](const ProvenFigure& p) { return solution_value(p, scene.dimension()); });
  document.member("at_infinity", at_infinity_value(scene, answer));
  document.end();
  return proven.size();
}

}  // namespace gcs
