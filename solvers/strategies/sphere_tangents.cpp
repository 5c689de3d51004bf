/// The lines at given distances from four fixed points: the common tangents of four spheres (4p1L).
///
/// With one centre at the origin the point of the line is a quadratic function of its direction but for its
/// component τ across the plane of three centres. Three equations in the direction and τ are left, whose 12
/// common zeros are, method direct, joint eigenvalues of two commuting matrices
/// (tangents/tangent_algebra.hpp): no path is followed and no initial guess made; multiple lines are the
/// means of eigenvalues that belong together. Method homotopy follows 24 paths to them
/// (tangents/tangent_homotopy.hpp); multiple lines are the ends of several. Simple lines are polished by
/// Newton's method on the six equations in the line's coordinates, complex ones too.
///
/// Method published follows the paths of the literature's systems as they stand (tangents/published_tangents.hpp),
/// for their numbers; nearly collinear centres it does not mend, coplanar ones the cubic system excludes, and
/// of the quadrics' many paths to infinity none is told to be a line there.
///
/// The 12 lines of nearly collinear centres, off a line by ε of their distances, are complex as a rule, have
/// directions with |u| of the order of 1/ε where u·u = 1 and are as far away: in Cartesian coordinates they
/// come near to each other and to infinity. Where lines are not found both methods find those of spheres
/// whose centres are moved apart and follow them back in isotropic coordinates
/// (tangents/squeezed_tangents.hpp). Where their coordinates in doubles hold the distances no longer, from an ε
/// of 1e-8 on, each is proven to be next to a line, or the status is partial. Multiple lines are not followed,
/// so that there the status is partial.
///
/// Lines that come out as multiple ones are settled with the exact decimals of the file
/// (certificates/nearly_singular.hpp): as multiple ones, or as several that are proven to be different.
/// Where neither succeeds, or doubles do not tell them apart, the status is partial.
///
/// Complete: the multiplicities of the lines found and of those at infinity (isotropic directions) sum to 12.
/// Infinitely many solutions are proven and named, with the exact decimals of the file: coinciding and
/// collinear centres beforehand, others by a common factor of the equations (tangents/exact_spheres.hpp).
/// Hoffmann, Yuan, On Spatial Constraint Solving Approaches, 2000, section 4.1, where τ is eliminated too,
/// which coplanar centres do not allow. Step control of paths is a heuristic: where one is taken for its
/// neighbour a line is missing, and the status is partial.

#include "solvers/strategies/sphere_tangents.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/certificates/proven_error.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/systems/system_facts.hpp"
#include "solvers/systems/tangent_systems.hpp"
#include "solvers/tangents/degenerate_spheres.hpp"
#include "solvers/tangents/scene_spheres.hpp"
#include "solvers/tangents/tangent_algebra.hpp"
#include "solvers/tangents/tangent_homotopy.hpp"
#include "solvers/tangents/tangents_of_four_spheres.hpp"

namespace gcs {
namespace {

/// A condition number from which on the rounding of a line's coordinates to doubles leaves nothing of its distances: what it
/// is next to is proven then.
constexpr double undetermined = 0x1p53;

/// The point that a distance constraint names beside the line.
int point_of(const Scene& scene, const DistanceConstraint& constraint) {
  return constraint.between[scene.problem().is_point(constraint.between[0]) ? 0 : 1];
}

Candidate candidate_of(const Scene& scene, const ComplexLine& line, bool is_real, int multiplicity) {
  return {beside_given_points(scene, line, is_real), multiplicity};
}

void report_degenerate(const Scene& scene, const LocalSpheres& local, const DegenerateTangents& tangents,
                       SolveReport& report) {
  report.generic = 0;  // at generic distances nothing touches spheres that are placed like this
  report.reason = tangents.why_infinite;
  report.status = report.reason.empty() ? SolveStatus::complete : SolveStatus::infinite;
  if (!tangents.has_axis) return;
  const auto [point, direction] = line_of_centers(local.spheres);
  report.candidates.push_back(candidate_of(scene, local.in_scene({point, direction}), true, 1));
}

/// Lines that are settled with the file's own numbers. Where lines are missing others that are nearly
/// singular are settled with them: they may be next to those.
bool is_doubtful(const Scene& scene, const FoundTangent& line, const Candidate& candidate, bool are_missing) {
  return line.multiplicity > 1 ||
         (are_missing && jacobian_condition(scene, candidate.figure) >= stiff_condition);
}

int accounted_for(const SolveReport& report, int at_infinity) {
  int sum = at_infinity;
  for (const Candidate& candidate : report.candidates) sum += candidate.multiplicity;
  return sum;
}

/// False where lines lie too near each other to be told apart.
bool list_lines(const SolveRequest& request, const FourSpheres& spheres, const LocalSpheres& local,
                const FoundTangents& tangents, SolveReport& report) {
  const Scene& scene = request.scene;
  const bool are_missing = tangents.accounted_for() != tangent_count;
  std::vector<Candidate> doubtful;
  for (const FoundTangent& found : tangents.lines) {
    const auto& [line, is_real, multiplicity] = found;
    Candidate candidate = candidate_of(
        scene, polished(spheres, local, line, is_real, multiplicity, report.work), is_real, multiplicity);
    (is_doubtful(scene, found, candidate, are_missing) ? doubtful : report.candidates).push_back(candidate);
  }
  const int expected = tangent_count - accounted_for(report, tangents.at_infinity);
  ResolvedCandidates found =
      resolve_nearly_singular(scene, doubtful, report.candidates, expected, request.stop);
  std::ranges::move(found.list, std::back_inserter(report.candidates));
  return found.are_told_apart;
}

/// How many of the lines whose coordinates do not hold their distances are not proven to be next to a solution; the others
/// get their error.
int prove_far_lines(const Scene& scene, std::vector<Candidate>& candidates) {
  std::vector<Candidate*> far;
  for (Candidate& candidate : candidates)
    if (candidate.multiplicity == 1 && jacobian_condition(scene, candidate.figure) >= undetermined)
      far.push_back(&candidate);
  if (far.empty()) return 0;
  const SceneEquations equations(scene);
  const Certifier certifier(equations.system());
  for (Candidate* candidate : far)
    candidate->error =
        std::min(candidate->error, certified_error(equations, certifier, scene.in_frame(candidate->figure)));
  return static_cast<int>(std::ranges::count_if(
      far, [](const Candidate* candidate) { return !std::isfinite(candidate->error); }));
}

void report_lines(const SolveRequest& request, const FourSpheres& spheres, const LocalSpheres& local,
                  const FoundTangents& tangents, SolveReport& report) {
  const Scene& scene = request.scene;
  report.generic = tangent_count;
  report.at_infinity = tangents.at_infinity;
  const bool are_told_apart = list_lines(request, spheres, local, tangents, report);
  const int accounted_for_here = accounted_for(report, tangents.at_infinity);
  if (accounted_for_here == tangent_count && are_told_apart) {
    report.status = SolveStatus::complete;
  } else if (have_infinitely_many_tangents(exact_spheres_of(scene))) {
    report.status = SolveStatus::infinite;
    report.reason =
        "the equations of the common tangents leave a curve of complex solutions, although the centres are "
        "not collinear";
  } else if (!are_told_apart || tangents.accounted_for() == tangent_count) {
    report.status = SolveStatus::partial;
    report.reason = too_near;
  } else if (accounted_for_here > tangent_count) {
    report.status = SolveStatus::partial;
    report.reason = std::to_string(accounted_for_here) + " lines were found where there are " +
                    std::to_string(tangent_count) + ": rounding makes several of one";
  } else {
    report.status = SolveStatus::partial;
    report.reason = "of the " + std::to_string(tangent_count) + " lines " +
                    std::to_string(accounted_for_here) +
                    " are accounted for, multiplicities and those at infinity included";
  }
  const int unproven = prove_far_lines(scene, report.candidates);
  if (unproven == 0 || report.status != SolveStatus::complete) return;
  report.status = SolveStatus::partial;
  report.reason = "the coordinates of " + std::to_string(unproven) +
                  " lines are so large beside the lengths that doubles do not tell what they are next to";
}

void report_stop(SolveReport& report) {
  report.status = SolveStatus::stopped;
  report.reason = "stopped on request";
}

class SphereTangentsStrategy final : public Strategy {
 public:
  explicit SphereTangentsStrategy(const SphereTangents& asked)
      : method_(asked.method), system_(asked.system) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    const ProblemStatement& problem = scene.problem();
    if (problem.dimension != 3 || problem.lines.size() != 1 || problem.points.size() != 4 ||
        problem.constraints.size() != 4)
      return "it finds a line by its distances from four points";
    for (int point = 0; point < 4; ++point)
      if (!problem.is_fixed(point)) return "it needs four points with fixed positions";
    std::array<int, 4> named{};
    for (const DistanceConstraint& constraint : problem.constraints) {
      const auto [a, b] = constraint.between;
      if (problem.is_point(a) == problem.is_point(b)) return "it knows distances from the line only";
      ++named[point_of(scene, constraint)];
    }
    if (named != std::array{1, 1, 1, 1}) return "it needs one distance from each of the four points";
    if (problem.is_fixed(4)) return "the line is fixed, so that nothing is left to find";
    return std::nullopt;
  }

  SolveReport solve(const SolveRequest& request) override {
    SolveReport report;
    report.claim = Claim::all_complex;
    if (request.stop.stop_requested()) {
      report_stop(report);
      return report;
    }
    const FourSpheres spheres = *spheres_of(request.scene);
    const LocalSpheres local(spheres);
    std::optional<std::vector<PathRecord>> paths;
    if (const auto reason = why_not_followed(local))
      report.reason = *reason;
    else
      paths = find(request, spheres, local, report);
    if (paths) report_paths(std::move(*paths), report);
    if (paths && method_ == Method::published) report.particulars = facts(request);
    return report;
  }

 private:
  using Method = SphereTangents::Method;

  /// Of the system whose paths were followed.
  std::vector<Particular> facts(const SolveRequest& request) const {
    const ExactSpheres spheres = exact_spheres_of(request.scene);
    if (system_ == PublishedSystem::quadrics) return system_facts(tangent_quadrics(spheres), request);
    const std::optional<PolynomialSystem> cubic = tangent_cubic(spheres);
    return cubic ? system_facts(*cubic, request) : std::vector<Particular>();
  }

  std::optional<std::string> why_not_followed(const LocalSpheres& local) const {
    return method_ == Method::published ? why_no_system(local.spheres, system_) : std::nullopt;
  }

  /// The paths that were followed, if any.
  std::optional<std::vector<PathRecord>> find(const SolveRequest& request, const FourSpheres& spheres,
                                              const LocalSpheres& local, SolveReport& report) const {
    std::optional<FollowedTangents> followed;
    const auto degenerate = degenerate_tangents(exact_spheres_of(request.scene));
    if (method_ == Method::published)
      followed = follow_published_tangents(local.spheres, system_, request.seed, request.stop,
                                           request.monitor, report.work);
    if (degenerate) {
      report_degenerate(request.scene, local, *degenerate, report);
    } else if (const auto reason = why_nearly_concentric(local.spheres)) {
      report.reason = *reason;
    } else {
      if (method_ == Method::homotopy)
        followed = follow_tangents(local.spheres, request.seed, request.stop, request.monitor, report.work);
      report_lines(request, spheres, local,
                   followed ? followed->found : common_tangents(local.spheres, report.work), report);
    }
    return followed ? std::optional(std::move(followed->paths)) : std::nullopt;
  }

  static void report_paths(std::vector<PathRecord> paths, SolveReport& report) {
    report.paths = std::move(paths);
    if (report.paths.back().end == PathRecord::End::stopped) return report_stop(report);
    const bool any_failed = std::any_of(report.paths.begin(), report.paths.end(), [](const PathRecord& path) {
      return path.end == PathRecord::End::failed;
    });
    if (!any_failed || report.status != SolveStatus::complete) return;
    report.status = SolveStatus::partial;
    report.reason = "all lines are accounted for, but not all paths have an end";
  }

  Method method_;
  PublishedSystem system_;
};

}  // namespace

StrategyEntry sphere_tangents_entry() {
  StrategyEntry entry = entry_of<SphereTangentsStrategy, SphereTangents>();
  entry.summary = "solves for the 12 common tangents of four spheres, complex ones included";
  entry.citation = "Hoffmann, Yuan 2000, section 4.1";
  entry.accuracy_settings = {{{"method", "homotopy"}}};
  return entry;
}

}  // namespace gcs
