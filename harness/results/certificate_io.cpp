#include "harness/results/certificate_io.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "harness/results/certificate_limit.hpp"
#include "harness/results/decimal_json.hpp"
#include "harness/solving/frame_view.hpp"
#include "solvers/certificates/dyadic_figure.hpp"
#include "solvers/certificates/solutions_at_infinity.hpp"
#include "solvers/numeric/natural.hpp"

namespace gcs {
namespace {

struct ProvenFigure {
  DyadicBox box;
  bool is_real;
};

/// DyadicBox::radius is 2 to the power of this.
constexpr int radius_bits = std::bit_width(unsigned{DyadicBox::radius}) - 1;

/// `members` come first.
JsonValue box_value(JsonMembers members, const DyadicBox& box, bool is_real) {
  const auto number = [&](const DecimalNumber& one) { return json_decimal(one, is_real); };
  members.emplace_back("exponent", json_number(box.exponent));
  members.emplace_back("radius", json_text(Natural::power_of_two(radius_bits + box.widening).decimal()));
  members.emplace_back("numbers", json_array_of(box.numbers, number));
  return json_object(std::move(members));
}

JsonValue solution_value(const ProvenFigure& proven) {
  JsonMembers members{{"real", json_boolean(proven.is_real)}};
  if (proven.box.solutions > 1) members.emplace_back("multiplicity", json_number(proven.box.solutions));
  return box_value(std::move(members), proven.box, proven.is_real);
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

JsonValue solution_value(const DyadicAtInfinity::Solution& solution) {
  return box_value({{"way", json_count(solution.way)}}, solution.box, false);
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
                      {"ways", json_array_of(proven.ways, way_value)},
                      {"solutions", json_array_of(proven.solutions, [](const auto& solution) {
                         return solution_value(solution);
                       })}});
}

/// Where the instance has what no certificate states; nothing where it has nothing of the kind.
const char* beyond_certificates(const ProblemStatement& problem) {
  if (problem.file_frame) return "/fixed";
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity) && !bodies_with(problem, entity).empty()) return "/fixed";
  if (problem.reference_body >= 0 || problem.has_fixed()) return nullptr;
  if (!problem.bodies.empty()) return "/bodies";
  const Reference reference = Scene::unchecked(problem).reference();
  const bool has_line = !problem.is_general() && reference.line >= 0;
  const bool has_origin = reference.origin >= 0 && problem.is_point(reference.origin) && reference.axis >= 0;
  return has_line || has_origin ? nullptr : "/reference";
}

/// Certified ones, and clusters.
std::vector<ProvenFigure> proven_figures(const Scene& scene, const Answer& answer) {
  std::vector<Figure> listed;
  for (const AssessedSolution& solution : answer.solutions) listed.push_back(solution.figure);
  const auto boxes = dyadic_figures(SceneEquations(scene), scene, listed, answer.threads);
  std::vector<ProvenFigure> proven;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i] && (answer.solutions[i].certified || boxes[i]->solutions > 1))
      proven.push_back(
          {*boxes[i], listed[i].is_real() && (boxes[i]->solutions == 1 || boxes[i]->is_multiple)});
  return proven;
}

}  // namespace

void require_certifiable(const Instance& instance) {
  const char* place = beyond_certificates(instance.problem);
  if (place == nullptr) return;
  throw InputError(
      instance.origin, place,
      "a certificate is of scenes in a frame that begins at a point or has a line and a point, in a body, or "
      "in given elements of no body that leave no motion",
      "leave out --certificate; --certify proves more");
}

std::uint64_t write_certificate(const Instance& instance, const Scene& scene, const Answer& answer,
                                const TextSink& take) {
  const std::vector<ProvenFigure> proven = proven_figures(scene, answer);
  std::uint64_t found = 0;
  for (const ProvenFigure& one : proven) found += static_cast<std::uint64_t>(one.box.solutions);
  const auto real =
      std::count_if(proven.begin(), proven.end(), [](const ProvenFigure& p) { return p.is_real; });
  DocumentWriter document("gcsbench-certificate/2", take, answer.threads);
  document.member("instance", instance.document);
  document.member("frame", frame_value(scene));
  document.member("unit", json_number(scene.unit_exponent()));
  document.member("complex", json_count(found));
  document.member("real", json_count(static_cast<std::uint64_t>(real)));
  document.member("limit", certificate_limit(scene));
  document.list("solutions", proven, [](const ProvenFigure& p) { return solution_value(p); });
  document.member("at_infinity", at_infinity_value(scene, answer));
  document.end();
  return found;
}

}  // namespace gcs
