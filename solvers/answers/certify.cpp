#include "solvers/answers/certify.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "solvers/certificates/certificate_member.hpp"
#include "solvers/certificates/coincidences.hpp"
#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/certificates/enclosed_point.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/certificates/solutions_at_infinity.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/figure_in_frame.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

using Point = std::vector<std::complex<double>>;

ProvenPlace place_of(const Certificate& certificate, const Point& x) {
  double reach = 0;
  for (std::size_t i = 0; i < x.size(); ++i) reach = std::max(reach, certificate.offset(i, x[i]));
  return {reach, (certificate.enclosure.unique - reach) * (1 - 4 * epsilon)};
}

/// Where points are proven to be next to a solution; nothing where they are not.
using ProvenPlaces = std::vector<std::optional<ProvenPlace>>;

/// Which may be next to the same one. Those whose places meet are proven again: their enclosures are smaller.
std::vector<Coincidence> coincidences_among(const Certifier& certifier, const PointOf& point_of,
                                            const ProvenPlaces& places, const ProofSetup& setup) {
  const SignMasks& mirror = certifier.system().mirror;
  std::vector<std::size_t> isolated;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i]) isolated.push_back(i);
  std::set<std::size_t> met;
  const auto place = [&](std::size_t i) { return box_around(point_of(i), *places[i]); };
  for (const Coincidence& pair : coincidences(
           isolated.size(), [&](std::size_t k) { return place(isolated[k]); }, mirror))
    met.insert(
        {isolated[static_cast<std::size_t>(pair.first)], isolated[static_cast<std::size_t>(pair.second)]});
  const std::vector<std::size_t> meeting(met.begin(), met.end());
  std::vector<Enclosure> boxes;
  for (const std::size_t i : meeting) boxes.push_back(place(i));
  certify_points(
      certifier, meeting.size(), [&](std::size_t k) { return point_of(meeting[k]); },
      {.threads = setup.threads, .stop = setup.stop, .crew = setup.crew},
      [&](std::size_t k, Certificate certificate) { boxes[k] = std::move(certificate.enclosure); });
  std::vector<Coincidence> pairs = coincidences(boxes, mirror);
  for (Coincidence& pair : pairs) {
    pair.first = static_cast<int>(meeting[static_cast<std::size_t>(pair.first)]);
    pair.second = static_cast<int>(meeting[static_cast<std::size_t>(pair.second)]);
  }
  return pairs;
}

/// How many classes the points are proven to be, each next to a solution of its own.
std::uint64_t proven_classes(const Certifier& certifier, const std::vector<Point>& points,
                             const ProofSetup& setup) {
  ProvenPlaces places(points.size());
  std::vector<char> counts(points.size());  // threads do not share a char
  const auto point_of = [&](std::size_t i) { return points[i]; };
  certify_points(certifier, points.size(), point_of, setup,
                 [&](std::size_t i, const Certificate& certificate) {
                   if (certificate.is_isolated()) places[i] = place_of(certificate, points[i]);
                   counts[i] = certificate.is_proven;
                 });
  for (const Coincidence& pair : coincidences_among(certifier, point_of, places, setup))
    counts[static_cast<std::size_t>(pair.second)] = false;
  return static_cast<std::uint64_t>(std::count(counts.begin(), counts.end(), true));
}

/// What keeps a solution from counting as proven; empty when nothing does.
std::string objection(const AssessedSolution& solution, const SolutionProof& proof) {
  using Realness = Certificate::Realness;
  const bool is_real = solution.figure.is_real();
  const int cluster = proof.certificate.cluster;
  if (cluster > 0 && !proof.fits(solution.multiplicity))
    return fmt::format(
        "is listed with multiplicity {} and is a cluster of {} solutions, multiplicities counted",
        solution.multiplicity, cluster);
  if (cluster > 0 && !proof.certificate.is_multiple)
    return fmt::format("is not proven: {}, no further from it than {:.1e}", proof.certificate.cause,
                       std::ldexp(proof.distance, solution.terms->unit_exponent));
  if (!proof.certificate.holds_one()) return "is not proven: " + proof.certificate.cause;
  if (cluster == 0 && solution.multiplicity > 1)
    return fmt::format("is listed with multiplicity {} and is a simple one", solution.multiplicity);
  if (proof.is_proven_same) return fmt::format("is the same class as solution {}", proof.same_as);
  if (proof.same_as >= 0)
    return fmt::format("is not proven to be another class than solution {}", proof.same_as);
  if (is_real && proof.certificate.realness == Realness::not_real) return "is listed as real and is not";
  if (!is_real && proof.certificate.realness == Realness::real) return "is listed as complex and is real";
  if (proof.certificate.realness == Realness::undecided) return "is neither proven real nor proven not to be";
  return "";
}

/// Of proven solutions that doubles do not hold. Where stop is asked for none for those that are left.
void find_decimals(const SceneEquations& equations, const Scene& scene, const ProofSetup& setup,
                   std::vector<AssessedSolution>& solutions) {
  share_on_threads(solutions.size(), setup.threads, [&](std::size_t i) {
    AssessedSolution& solution = solutions[i];
    if (!solution.certified || !loses_distances(scene, solution.figure) || setup.stop.stop_requested())
      return;
    const int digits = digits_that_hold(scene, solution.figure);
    if (auto decimals = decimal_figure(equations, scene, solution.figure, digits))
      solution.decimals = std::make_shared<const DecimalFigure>(*std::move(decimals));
  });
}

bool proves_real(const Certificate& certificate) {
  return certificate.holds_one() && certificate.realness == Certificate::Realness::real;
}

std::uint64_t proven_real(const Assessment& assessment) {
  return static_cast<std::uint64_t>(
      std::count_if(assessment.solutions.begin(), assessment.solutions.end(),
                    [](const AssessedSolution& s) { return s.certified && s.is_as_stated(); }));
}

std::uint64_t proven_undecided(const Assessment& assessment) {
  return static_cast<std::uint64_t>(
      std::count_if(assessment.solutions.begin(), assessment.solutions.end(), [](const AssessedSolution& s) {
        return s.certified && s.is_real() && s.signs.standing == Standing::undecided;
      }));
}

/// What signs say of the real solution that is proven next to a figure: of its enclosure or, where that is too wide, of
/// one in a higher precision.
SignVerdict proven_signs(const SceneEquations& equations, const std::vector<StatedSign>& signs,
                         const Figure& figure, const Certificate& certificate) {
  constexpr int precise_bits = 128;  // of which the enclosure's doubles keep 53
  const SystemBuilder& elements = equations.general()->elements();
  const auto verdict = [&](const Enclosure& enclosure) {
    return verdict_on(signs, [&](int point) { return enclosed_point(elements.point(point), enclosure); });
  };
  const SignVerdict first = verdict(certificate.enclosure);
  if (first.standing != Standing::undecided) return first;
  const Certificate precise =
      Certifier(equations.system()).certify(equations.coordinates(figure), precise_bits);
  return precise.is_proven ? verdict(precise.enclosure) : first;
}

/// What is proven of the solutions of an assessment, each for itself and among the others. Their figures are lent, not
/// copied, as lists may be long.
void prove_listed(const SceneEquations& equations, const Scene& scene, const ProofSetup& setup,
                  Assessment& assessment) {
  Proofs& proofs = *assessment.proofs;
  std::vector<Figure> figures;
  figures.reserve(assessment.solutions.size());
  for (AssessedSolution& solution : assessment.solutions) figures.push_back(std::move(solution.figure));
  const std::vector<StatedSign> signs = stated_signs(scene.problem());
  const std::vector<SolutionProof> all = prove_solutions(equations, signs, figures, setup);
  for (std::size_t i = 0; i < all.size(); ++i) {
    AssessedSolution& solution = assessment.solutions[i];
    solution.figure = std::move(figures[i]);
    if (!all[i].certificate.is_tried()) continue;
    const std::string what = objection(solution, all[i]);
    if (!what.empty()) {
      const Certificate& certificate = all[i].certificate;
      const bool is_multiple =
          !certificate.holds_one() &&
          (certificate.cluster == 0 ? solution.multiplicity > 1 : all[i].fits(solution.multiplicity));
      assessment.failed_checks.push_back(
          {is_multiple ? "singular" : "certificate", fmt::format("solution {} {}", i, what)});
    }
    if (all[i].certificate.holds_one())
      solution.error_bound = error_in_file(solution.figure, all[i].distance, scene.size(),
                                           scene.unit_exponent(), scene.problem().file_frame);
    if (!signs.empty() && proves_real(all[i].certificate) && solution.is_real())
      solution.signs = all[i].signs;
    solution.certified = what.empty();
    proofs.classes += solution.certified ? 1 : 0;
    proofs.multiple += solution.certified && all[i].certificate.is_multiple ? 1 : 0;
    proofs.most_bits = std::max(proofs.most_bits, all[i].certificate.bits);
  }
  count_clusters_and_images(all, proofs);
}

/// For itself, not yet among others.
SolutionProof proof_of(const SceneEquations& equations, const SignMasks& mirror,
                       const std::vector<StatedSign>& signs, const Figure& figure, Certificate certificate) {
  SolutionProof proof;
  if (certificate.is_isolated()) {
    proof.place = place_of(certificate, equations.coordinates(figure));
    proof.distance = equations.distance(figure, certificate);
  }
  if (certificate.is_isolated() && (certificate.cluster > 0 || equations.general())) {
    const int images = meeting_images(certificate.enclosure, mirror);
    proof.has_image = certificate.is_proven && images == 1;
    if (certificate.cluster > 0) proof.least = (certificate.cluster + images - 1) / images;
  }
  if (!signs.empty() && proves_real(certificate))
    proof.signs = proven_signs(equations, signs, figure, certificate);
  proof.certificate = std::move(certificate);
  proof.certificate.enclosure = {};
  return proof;
}

}  // namespace

Enclosure box_around(Point x, const ProvenPlace& place) {
  std::vector<std::complex<double>> radius(x.size(), {place.reach, place.reach});
  return {std::move(x), std::move(radius), place.unique};
}

std::vector<SolutionProof> prove_solutions(const SceneEquations& equations,
                                           const std::vector<StatedSign>& signs,
                                           const std::vector<Figure>& figures, const ProofSetup& setup) {
  const Certifier certifier(equations.system());
  std::vector<SolutionProof> proofs(figures.size());
  ProvenPlaces places(figures.size());
  const auto point_of = [&](std::size_t i) { return equations.coordinates(figures[i]); };
  certify_points(certifier, figures.size(), point_of, setup, [&](std::size_t i, Certificate certificate) {
    proofs[i] = proof_of(equations, certifier.system().mirror, signs, figures[i], std::move(certificate));
    if (proofs[i].certificate.is_isolated()) places[i] = proofs[i].place;
  });
  for (const Coincidence& pair : coincidences_among(certifier, point_of, places, setup)) {
    SolutionProof& later = proofs[static_cast<std::size_t>(pair.second)];
    if (later.is_proven_same || (later.same_as >= 0 && !pair.is_proven)) continue;
    later.same_as = pair.first;
    later.is_proven_same = pair.is_proven;
  }
  for (SolutionProof& proof : proofs)
    if (proof.certificate.cluster > 0 && proof.same_as < 0) proof.cluster = proof.least;
  return proofs;
}

ProvenErrors prove_errors(const Scene& scene, const ProofSetup& setup, const std::vector<Figure>& figures) {
  ProvenErrors proven;
  if (why_not_certified(scene)) return proven;
  for (const SolutionProof& proof : prove_solutions(SceneEquations(scene), {}, figures, setup)) {
    proven.errors.push_back(proof.certificate.is_proven ? proof.distance
                                                        : std::numeric_limits<double>::infinity());
    proven.different += proof.counts();
  }
  return proven;
}

void count_clusters_and_images(const std::vector<SolutionProof>& solutions, Proofs& proofs) {
  for (const SolutionProof& solution : solutions) {
    proofs.with_image += solution.counts() && solution.has_image ? 1 : 0;
    proofs.clusters += solution.cluster > 0 ? 1 : 0;
    proofs.in_clusters += static_cast<std::uint64_t>(solution.cluster);
  }
}

void certify(const Scene& scene, const TheoreticalCounts& limits, const std::optional<GenericMember>& generic,
             const ProofSetup& setup, Assessment& assessment) {
  Proofs& proofs = assessment.proofs.emplace();
  if (auto reason = why_not_certified(scene)) {
    proofs.why_none = std::move(*reason);
    return;
  }
  const SceneEquations equations(scene);
  prove_listed(equations, scene, setup, assessment);
  find_decimals(equations, scene, setup, assessment.solutions);
  proofs.real = proven_real(assessment);
  proofs.undecided = proven_undecided(assessment);
  assessment.counts.certified = proofs.classes;
  if (!stated_signs(scene.problem()).empty()) recount(assessment);
  if (generic)
    proofs.generic =
        proven_classes(Certifier(equations.system_at(generic->squares)), generic->solutions, setup);
  prove_escaping(scene, assessment.escaping, setup, proofs);
  set_limit(limits, proofs);
}

void prove_escaping(const Scene& scene, const std::vector<Figure>& escaping, const ProofSetup& setup,
                    Proofs& proofs) {
  if (escaping.empty()) return;
  if (setup.monitor != nullptr) setup.monitor->progress("proving solutions at infinity", 0);
  std::vector<Figure> near;
  for (const Figure& figure : escaping) near.push_back(scene.in_scene_unit(figure));
  ProvenAtInfinity proven = prove_at_infinity(scene, near, setup.threads, setup.stop);
  proofs.at_infinity = proven.classes;
  proofs.why_not_at_infinity = std::move(proven.why_not_all);
  proofs.most_bits = std::max(proofs.most_bits, proven.most_bits);
}

void set_limit(const TheoreticalCounts& limits, Proofs& proofs) {
  const SolutionCount* limit = limits.upper_limit();
  if (!limit) return;
  proofs.limit = limit->up_to_reflection();
  proofs.limit_is_exact = limits.exact.has_value();
  if (limits.bound) proofs.figure_limit = limits.bound->figures;
}

bool Proofs::meets_limit(std::uint64_t count, std::uint64_t two_figures) const {
  return (limit && Natural(count) == *limit) ||
         (figure_limit && Natural(count + two_figures) == *figure_limit);
}

}  // namespace gcs
