/// The polynomial systems of Hoffmann, Yuan 2000 for 6p and 5p1L, as they stand, solved by paths.
///
/// Each system is written down with the exact numbers of the file (systems/octahedron_systems.hpp and
/// systems/pyramid_systems.hpp), so that its degrees and monomials are those of the instance and not of a theory; its total
/// degree, a multihomogeneous Bézout number and its mixed volume are computed from it. Its zeros are found by paths
/// (systems/system_paths.hpp), whose ends are counted as they come; those that are regular are turned into points,
/// settled on the distances, and reported.
///
/// With system=quadrics or echelon general scenes are solved the same way by their equations (elements/scene_system.hpp),
/// where their numbers are fractions and their unknowns few.
///
/// It is a measure of what a way to write a problem costs, and no strategy for hard scenes: multiple solutions, and those
/// at which a system has no regular zero (a flat octahedron has half angles at infinity), make the status partial.
/// Step control is a heuristic; where paths are taken for each other, regular ends coincide, and the status is partial.

#include "solvers/strategies/system_paths.hpp"

#include <algorithm>

#include "solvers/homotopies/complex_report.hpp"
#include "solvers/homotopies/general_report.hpp"
#include "solvers/homotopies/general_start.hpp"
#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/octahedron/octahedron.hpp"
#include "solvers/running/words.hpp"
#include "solvers/systems/octahedron_systems.hpp"
#include "solvers/systems/pyramid_systems.hpp"
#include "solvers/systems/scene_polynomials.hpp"
#include "solvers/systems/system_facts.hpp"

namespace gcs {
namespace {

using System = SystemPaths::System;
/// Of six points, all of them in it.
std::optional<Octahedron> whole_octahedron(const Scene& scene) {
  if (scene.dimension() != 3 || scene.has_lines() || scene.is_anchored() || scene.point_count() != 6)
    return std::nullopt;
  const auto octahedron = find_octahedron(scene.problem(), reduce_to_core(scene.problem(), {}));
  return octahedron ? std::optional(with_round_base(*octahedron, PairEntries(scene))) : std::nullopt;
}

SystemOrReason write(const Scene& scene, System system) {
  const auto octahedron = whole_octahedron(scene);
  const auto pyramid = octahedron ? std::nullopt : find_pyramid(scene);
  SystemOrReason written = system == System::quartics       ? octahedron_quartics(scene, *octahedron)
                           : system == System::parametrised ? pyramid_parametrised(scene, *pyramid)
                           : octahedron                     ? octahedron_quadrics(scene, *octahedron)
                                                            : pyramid_quadrics(scene, *pyramid);
  if (written.system && system == System::echelon)
    written.system->equations = echelon_form(written.system->equations);
  return written;
}

/// From the points of a zero, which are right to the condition of the system, to those of the distances: along the short
/// way from the lengths that they have to the given ones, in twice the precision where doubles do not do.
class Settling {
 public:
  Settling(const SolveRequest& request, const DistanceSystem& coordinates, const TrackingSetup& setup,
           std::mt19937_64& random, WorkCounters& work)
      : request_(request),
        coordinates_(coordinates),
        work_(work),
        system_(square_system(coordinates)),
        elimination_(order_elimination(system_, random)),
        tracking_(system_, elimination_, setup) {
    for (const DoubleDouble& square : target_squares(request.scene)) squares_.emplace_back(square.value());
  }

  /// In the free coordinates; nothing where the placement is next to no regular solution.
  std::optional<PathEnd> run(const ComplexPoints& placed) {
    const ComplexPoints points =
        request_.scene.has_lines() ? placed : in_frame(placed, 3, coordinates_.reference());
    if (!points.allFinite()) return std::nullopt;
    ComplexVectorX x(static_cast<std::size_t>(system_.unknowns));
    for (int p = 0; p < coordinates_.point_count(); ++p)
      for (int axis = 0; axis < 3; ++axis)
        if (const int i = coordinates_.unknown(p, axis); i >= 0)
          x[static_cast<std::size_t>(i)] = points(axis, p);
    const ComplexVectorX here = squares_at(system_, x);
    if (!are_near(here)) return std::nullopt;
    const std::vector<PathEnd> ends = follow_to_end(
        tracking_, {x}, here, squares_,
        [&](const ComplexVectorX& zero) { return is_zero_at(system_, squares_, zero); },
        [&] { return request_.stop.stop_requested(); }, [](double) {}, work_);
    const PathEnd& end = ends.front();
    if (end.kind != PathEnd::Kind::regular || distance(end.x, x) > nearby * (1 + largest(x)))
      return std::nullopt;
    return end;
  }

 private:
  static constexpr double nearby = 1e-3;  ///< further away it is the end of another zero
  /// Of a squared distance: what doubles leave of large coordinates must determine the solution that is meant.
  static constexpr double largest_miss = 1e-6;

  bool are_near(const ComplexVectorX& here) const {
    const double size = request_.scene.size();
    for (std::size_t e = 0; e < here.size(); ++e) {
      const double square = squares_[e] == 0.0 ? size * size : std::abs(squares_[e]);
      if (!(std::abs(here[e] - squares_[e]) <= largest_miss * square)) return false;
    }
    return true;
  }

  const SolveRequest& request_;
  const DistanceSystem& coordinates_;
  WorkCounters& work_;
  SquareSystem system_;
  Elimination elimination_;
  LegTracking tracking_;
  ComplexVectorX squares_;
};

/// What the ends of the paths are to the scene.
struct SortedEnds {
  std::vector<PathEnd> classes;  ///< regular ends, one for each class, in the frame of the system
  int extraneous = 0;            ///< finite ends that are none of the problem's
  int singular = 0;              ///< other finite ones that are not regular
  int misplaced = 0;             ///< regular ones that are no points
  int placed = 0;                ///< regular ones that are
};

SortedEnds sorted(const WrittenSystem& written, const std::vector<PathEnd>& ends, SolutionSet& classes,
                  Settling& settling) {
  SortedEnds result;
  for (const PathEnd& end : ends) {
    const bool is_regular = end.kind == PathEnd::Kind::regular;
    if (!is_regular && end.kind != PathEnd::Kind::singular) continue;
    if (written.is_extraneous && written.is_extraneous(end.x)) {
      ++result.extraneous;
    } else if (!is_regular) {
      ++result.singular;
    } else if (const auto settled = settling.run(written.place(end.x)); !settled) {
      ++result.misplaced;
    } else {
      ++result.placed;
      const int known = classes.size();
      classes.insert(settled->x, regular_uncertainty);
      if (classes.size() > known) result.classes.push_back(*settled);
    }
  }
  return result;
}

/// Those of a general scene: one for each class, in its unknowns.
SortedEnds sorted(const GeneralEquations& equations, const std::vector<PathEnd>& ends,
                  std::mt19937_64& random) {
  constexpr double same_zero = 1e-6;  // relative to 1 + the largest |x_i|
  SortedEnds result;
  RegularClasses classes(equations, {.nearby = same_zero}, random);
  for (const PathEnd& end : ends) {
    result.singular += end.kind == PathEnd::Kind::singular;
    if (end.kind == PathEnd::Kind::regular) ++(classes.add(end.x) ? result.placed : result.misplaced);
  }
  result.classes = classes.ends();
  return result;
}

class SystemPathsStrategy final : public Strategy {
 public:
  explicit SystemPathsStrategy(const SystemPaths& asked) : system_(asked.system), start_(asked.start) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    if (request.scene.problem().is_general()) return why_not_general_here(request.scene);
    const bool is_octahedron = whole_octahedron(request.scene).has_value();
    const bool is_pyramid = !is_octahedron && find_pyramid(request.scene).has_value();
    if (!is_octahedron && !is_pyramid) return "no system is written down but of octahedra and of 5p1L";
    if (system_ == System::quartics && is_pyramid)
      return "the quartics are of octahedra; 5p1L has system=quadrics, echelon and parametrised";
    if (system_ == System::parametrised && is_octahedron)
      return "the parametrised system is of 5p1L; octahedra have system=quartics, quadrics and echelon";
    return std::nullopt;
  }

  SolveReport solve(const SolveRequest& request) override {
    if (request.scene.problem().is_general()) return solve_general(request);
    const SystemOrReason written = write(request.scene, system_);
    if (!written.system) return not_solved(written.why_none);
    const PolynomialSystem& system = written.system->equations;
    if (std::string reason = why_not_square(system); !reason.empty()) return not_solved(reason);
    WorkCounters work;
    const TrackingSetup setup = setup_for(request);
    const FollowedSystem paths = follow(request, system, setup, work);
    return report_of(request, *written.system, paths, setup, work);
  }

 private:
  static std::string why_not_square(const PolynomialSystem& system) {
    if (static_cast<int>(system.equations.size()) < system.unknowns) return "the equations are dependent";
    const bool any_constant = std::ranges::any_of(
        system.equations, [](const RationalPolynomial& equation) { return equation.total_degree() < 1; });
    return any_constant ? "an equation of the system is constant" : "";
  }

  static SolveReport not_solved(const std::string& reason) {
    SolveReport report;
    report.claim = Claim::all_complex;
    report.reason = reason;
    return report;
  }

  static TrackingSetup setup_for(const SolveRequest& request) {
    TrackingSetup setup;
    setup.set = widest_instruction_set();
    setup.threads = request.threads;
    return setup;
  }

  FollowedSystem follow(const SolveRequest& request, const PolynomialSystem& system,
                        const TrackingSetup& setup, WorkCounters& work) const {
    const auto progress = [&request](std::string_view stage, double fraction) {
      if (request.monitor && !request.stop.stop_requested()) request.monitor->progress(stage, fraction);
    };
    return follow_system_paths({system, start_, setup, request.seed, request.stop, progress}, work);
  }

  std::optional<std::string> why_not_general_here(const Scene& scene) const {
    if (system_ == System::quartics || system_ == System::parametrised)
      return "the equations of a general scene are system=quadrics and echelon";
    if (auto reason = why_not_general(scene)) return reason;
    return why_no_polynomials(SceneSystem(scene).equations());
  }

  SolveReport solve_general(const SolveRequest& request) const {
    const SceneSystem scene(request.scene);
    PolynomialSystem system = polynomials_of(scene.equations());
    if (system_ == System::echelon) system = echelon_form(system);
    if (std::string reason = why_not_square(system); !reason.empty()) return not_solved(reason);
    WorkCounters work;
    const FollowedSystem paths = follow(request, system, setup_for(request), work);
    std::mt19937_64 random(request.seed);
    const GeneralEquations equations = general_equations(scene);
    const SortedEnds ends = sorted(equations, paths.ends, random);
    SolveReport report = general_report(scene, equations, ends.classes, work, random, request.stop);
    const std::vector<Particular> facts = system_facts(system, request);
    report.particulars.insert(report.particulars.begin(), facts.begin(), facts.end());
    finish(paths, what_is_missing(paths, ends, 1 << equations.signs.rank()), report);
    return report;
  }

  SolveReport report_of(const SolveRequest& request, const WrittenSystem& written,
                        const FollowedSystem& paths, const TrackingSetup& setup, WorkCounters& work) const {
    std::mt19937_64 random(request.seed);
    // Points in the scene's frame: a complex rotation into it would cost solutions their accuracy.
    const DistanceSystem coordinates = request.scene.has_lines()
                                           ? DistanceSystem(request.scene, written.reference)
                                           : DistanceSystem(request.scene);
    Settling settling(request, coordinates, setup, random, work);
    SolutionSet classes(mirror_axes(request.scene, coordinates), random);
    const SortedEnds ends = sorted(written, paths.ends, classes, settling);
    SolveReport report = complex_report(request.scene, coordinates, ends.classes, work, random, request);
    report.particulars = system_facts(written.equations, request);
    report.particulars.push_back({"extraneous_ends", ends.extraneous});
    std::string missing = what_is_missing(paths, ends, written.mirror_images);
    if (missing.empty() && has_infinite_half_angles(paths))
      missing = "half angles are infinite, as where points are flat";
    finish(paths, missing, report);
    return report;
  }

  /// The paths as they ended, and what that leaves open.
  static void finish(const FollowedSystem& paths, const std::string& missing, SolveReport& report) {
    report.paths.clear();
    for (const PathEnd& end : paths.ends) report.paths.push_back(path_record(end));
    if (paths.is_stopped) {
      report.status = SolveStatus::stopped;
      report.reason = "stopped on request";
    } else if (!missing.empty()) {
      report.reason = missing + (report.reason.empty() ? "" : "; " + report.reason);
      if (report.status != SolveStatus::stopped) report.status = SolveStatus::partial;
    }
  }

  /// `images`: zeros that every class has.
  static std::string what_is_missing(const FollowedSystem& paths, const SortedEnds& ends, int images) {
    if (!paths.why_none.empty()) return paths.why_none;
    const auto failed = std::ranges::count_if(
        paths.ends, [](const PathEnd& end) { return end.kind == PathEnd::Kind::failed; });
    if (failed > 0) return counted(failed, "path") + " failed";
    if (paths.jumps > 0) return counted(paths.jumps, "path") + " ended where another had: a step has jumped";
    if (ends.singular > 0)
      return counted(ends.singular, "path") + " ended at multiple solutions, which are not listed";
    if (ends.misplaced > 0)
      return counted(ends.misplaced, "regular end") +
             " give points at infinity, or so far away that doubles do not hold their distances";
    if (ends.placed != images * static_cast<int>(ends.classes.size()))
      return "regular ends of different paths are the same points, or their mirror images are missing";
    return "";
  }

  bool has_infinite_half_angles(const FollowedSystem& paths) const {
    return system_ == System::quartics && start_ == PathStart::mixed_cells &&
           std::ranges::any_of(paths.ends,
                               [](const PathEnd& end) { return end.kind == PathEnd::Kind::at_infinity; });
  }

  System system_;
  PathStart start_;
};

}  // namespace

StrategyEntry system_paths_entry() {
  StrategyEntry entry = entry_of<SystemPathsStrategy, SystemPaths>();
  entry.summary = "follows the paths of the polynomial systems that Hoffmann and Yuan write down";
  entry.citation = "Hoffmann, Yuan 2000, sections 4.1 and 4.2";
  entry.knows_general_scenes = true;
  return entry;
}

}  // namespace gcs
