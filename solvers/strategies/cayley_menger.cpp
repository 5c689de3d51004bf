/// All solutions of an octahedron at once, by Cayley–Menger determinants.
///
/// Of six points with twelve distances the three non-edges are a perfect matching, (a, a'), (b, b'), (c, c').
/// The determinants of {a, a', b, b', c} and {a, a', b, b', c'} vanish: two equations in the squared
/// diagonals X = |aa'|² and Y = |bb'|², of degree 2 in each. numeric/biquadratic_pair.hpp finds all their 8
/// common zeros, without an initial guess. Each is turned into coordinates (three trilaterations; of the two
/// sides of a' one is the mirror image) and polished by Newton's method on the distances, in C or, for real
/// ones, in R; where doubles do not hold the distances, as those of an edge that is short beside the size of
/// its isotropic vector, in double-double. Where a, a', b, b' are coplanar two solutions share both diagonals
/// (c and c' on the same side or on opposite ones) and the pair is a double zero, which both find.
///
/// method=univariate finds the pairs of diagonals in another way: one unknown is eliminated from the two determinants
/// exactly, and the roots of the polynomial that is left are isolated in balls. How many real octahedra there are in
/// the fixed frame is then a theorem, where all are simple: as many as a polynomial of degree 16 has real roots, by
/// Sturm's theorem (octahedron/exact_elimination.hpp). The same section, 4.2; Hoffmann, Vermeer 1995. Its roots stand in for
/// eigenvalues that do not lead to all solutions, as of an octahedron that moves but for 1e-12.
///
/// In place of up to three of the points, no two of them opposite, there may be planes: the matrix of squared distances,
/// signed distances and cosines has the same rank (octahedron/pair_entries.hpp), the diagonals may be distances from
/// planes, and the two equations have degree 2 in each as before. A figure of each pair is settled by Newton's method on
/// the equations of the scene, and complete are eight that are simple, by the same Bézout number; what is multiple or at
/// infinity there is not told apart, and the status is partial.
///
/// Other points may hang on an octahedron of points: each is placed afterwards, on both sides.
///
/// Nearly singular solutions are settled at the end, with the file's own numbers
/// (certificates/nearly_singular.hpp): as several simple ones, proven to be different, or as a multiple
/// one. Where neither succeeds, or doubles do not tell them apart, the status is partial.
///
/// Of an octahedron alone, what neither leads to is placed in balls by the roots of that polynomial and proven
/// (octahedron/exact_placement.hpp).
///
/// How many solutions are at infinity is decided by the file's own numbers. The solutions are complete when
/// the multiplicities of those found and these sum to 8; otherwise the report says what is missing, or that
/// the octahedron is proven to flex (octahedron/exact_squares.hpp). Hoffmann, Yuan, On Spatial Constraint
/// Solving Approaches, 2000, section 4.1; Michelucci, Foufou 2004.

#include "solvers/strategies/cayley_menger.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/certificates/proven_error.hpp"
#include "solvers/elements/scene_frame.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/homotopies/general_report.hpp"
#include "solvers/homotopies/general_start.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/octahedron/core_solutions.hpp"
#include "solvers/octahedron/exact_determinants.hpp"
#include "solvers/octahedron/exact_placement.hpp"
#include "solvers/octahedron/octahedron.hpp"
#include "solvers/octahedron/octahedron_with_planes.hpp"
#include "solvers/running/words.hpp"
#include "solvers/systems/octahedron_systems.hpp"
#include "solvers/systems/system_facts.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

constexpr int pairs = CoreSolutions::pairs;

/// Coordinates of solutions that are sought together, relative to the figure.
constexpr double close_together = 1e-5;
/// Below this a face of the octahedron is flat: nothing can be placed on it.
constexpr double flattest = 1e-12;

std::vector<Particular> particulars(int total_degree, const std::optional<EliminationFacts>& elimination) {
  std::vector<Particular> counts{{"total_degree", total_degree}};
  if (!elimination) return counts;
  counts.push_back({"eliminated_degree", std::max(elimination->degree, 0)});
  counts.push_back({"eliminated_real_roots", elimination->distinct_real_roots});
  if (elimination->real_solutions) counts.push_back({"proven_real_solutions", *elimination->real_solutions});
  return counts;
}

/// What is said of an octahedron that moves, or nearly so.
void refuse(bool is_proven, SolveReport& report) {
  report.status = is_proven ? SolveStatus::infinite : SolveStatus::gave_up;
  report.reason = is_proven
                      ? "the octahedron flexes: its two equations have a common factor, proven with the "
                        "exact numbers, so that a curve of complex solutions satisfies them"
                      : "the two equations of the octahedron have a common factor to rounding: it is so "
                        "near one that flexes that doubles do not tell its solutions apart";
}

void mark_stopped(SolveReport& report) {
  report.status = SolveStatus::stopped;
  report.reason = "stopped on request";
}

SolveReport stopped() {
  SolveReport report;
  mark_stopped(report);
  return report;
}

bool has_degrees(const ProblemStatement& problem) {
  return std::ranges::any_of(
      problem.relations, [](const Relation& relation) { return relation.form == Relation::Form::degrees; });
}

/// Places the points that hang on the core, on both sides each, and reports what comes of it.
class Reporter {
 public:
  Reporter(const SolveRequest& request, const CoreReduction& reduction, const std::array<int, 3>& frame)
      : request_(request),
        scene_(request.scene),
        reduction_(reduction),
        frame_(frame),
        system_(scene_),
        squares_(target_squares(scene_)),
        lengths_(scene_) {
    for (int e = 0; e < scene_.constraint_count(); ++e) {
      const auto [p, q] = scene_.problem().constraints[e].between;
      equations_.push_back({p, q, squares_[e]});
    }
  }

  SolveReport run(const CoreSolutions& core, const WorkCounters& work) {
    report_.work = work;
    report_.claim = Claim::all_complex;
    report_.particulars = particulars(core.total_degree, core.elimination);
    if (core.flexible || core.common_factor) {
      refuse(core.flexible, report_);
      return std::move(report_);
    }
    for (const CoreSolution& solution : core.list) hang(0, solution.points, solution);
    settle_nearly_singular();
    report_.generic = std::uint64_t{pairs} << reduction_.placed.size();
    report_.at_infinity = static_cast<std::uint64_t>(core.at_infinity) << reduction_.placed.size();
    add_exactly_placed();
    if (accounted_for() != report_.generic) note_missing(core);
    if (some_are_too_far_) note("some coordinates are " + too_large_for_doubles());
    report_.status = report_.reason.empty() ? SolveStatus::complete : SolveStatus::partial;
    if (request_.stop.stop_requested()) mark_stopped(report_);
    return std::move(report_);
  }

 private:
  /// Solutions in one place, as far as doubles tell.
  struct Deferred {
    ComplexPoints points;
    int solutions = 0;
  };

  static std::string what_is_missing(const CoreSolutions& core) {
    const std::string found = "of the " + std::to_string(pairs) + " pairs of diagonals " +
                              std::to_string(core.accounted_for()) +
                              " are accounted for, those at infinity and multiplicities included";
    return found +
           (core.far_away > core.at_infinity
                ? "; others have coordinates " + too_large_for_doubles()
                : "; from others Newton's method did not settle, as where solutions are ill-conditioned");
  }

  void note_missing(const CoreSolutions& core) {
    if (core.accounted_for() != pairs)
      note(what_is_missing(core));
    else if (report_.reason.empty())
      note(std::string(too_near));
  }

  void note(const std::string& reason) { report_.reason += (report_.reason.empty() ? "" : "; ") + reason; }

  void hang(std::size_t next, const ComplexPoints& points, const CoreSolution& core) {
    if (request_.stop.stop_requested()) return;
    if (next == reduction_.placed.size()) return add(points, core);
    const auto& [point, from] = reduction_.placed[next];
    const auto both =
        trilaterate({points.col(from[0]), points.col(from[1]), points.col(from[2])},
                    {lengths_(point, from[0]), lengths_(point, from[1]), lengths_(point, from[2])});
    if (!both) return note("the points that " + scene_.problem().points[point] + " hangs on are collinear");
    for (const Eigen::Vector3cd& position : *both) {
      ComplexPoints more = points;
      more.col(point) = position;
      hang(next + 1, more, core);
    }
  }

  void add(ComplexPoints points, const CoreSolution& core) {
    if (core.wide.empty()) {
      if (move_to_frame(points) || core.is_singular) return defer(points, core.multiplicity);
    } else if (!move_to_frame(points, core.wide)) {
      return note("Newton's method did not settle at a solution whose distances doubles do not hold");
    }
    const double tolerance = core.tolerance() * points.cwiseAbs().maxCoeff();
    Figure real{points.real(), {}, {}};
    const bool is_real = points.imag().cwiseAbs().maxCoeff() <= tolerance && make_real(real, tolerance);
    Candidate candidate{is_real ? real : complex_figure(points), 1};
    if (!core.wide.empty()) candidate.error = proven_error(scene_, squares_, candidate.figure);
    list(std::move(candidate));
  }

  void list(Candidate candidate) {
    if (loses_distances(scene_, candidate.figure)) {
      std::optional<Candidate> proven = proven_next_to(scene_, {&candidate.figure}, {}).front();
      some_are_too_far_ |= !proven;
      if (proven) candidate = *std::move(proven);
    }
    report_.candidates.push_back(std::move(candidate));
  }

  /// Where solutions of an octahedron alone are missing: by the roots of its exact polynomial, and proven.
  void add_exactly_placed() {
    if (!reduction_.placed.empty()) return;
    Octahedron octahedron = *find_octahedron(scene_.problem(), reduction_);
    for (int choice = 0; choice < 3 && accounted_for() < *report_.generic; ++choice) {
      for (const ComplexPoints& points : exactly_placed(scene_, octahedron)) {
        if (is_listed(points)) continue;
        const ResolvedCandidates found =
            resolve_nearly_singular(scene_, {{complex_figure(points)}}, report_.candidates, 1, request_.stop);
        std::ranges::copy(found.list, std::back_inserter(report_.candidates));
      }
      std::rotate(octahedron.pair.begin(), octahedron.pair.begin() + 1, octahedron.pair.end());
    }
  }

  /// As it is or as its mirror image.
  bool is_listed(const ComplexPoints& points) const {
    ComplexPoints mirrored = points;
    mirrored.row(2) *= -1;
    return std::ranges::any_of(report_.candidates, [&](const Candidate& candidate) {
      const ComplexPoints other = complex_points(candidate.figure);
      return std::min(apart(points, other), apart(mirrored, other)) <= close_together;
    });
  }

  /// Those at infinity and multiplicities included.
  std::uint64_t accounted_for() const {
    std::uint64_t count = *report_.at_infinity;
    for (const Candidate& candidate : report_.candidates)
      count += static_cast<std::uint64_t>(candidate.multiplicity);
    return count;
  }

  /// Into the scene's frame, polished there: turning by a complex rotation has cost accuracy. True where the
  /// solution is nearly singular; then it is not polished where that leads away.
  bool move_to_frame(ComplexPoints& points) const {
    const Reference& reference = scene_.reference();
    const ComplexPoints framed = in_frame(points, 3, reference);
    const bool turned = framed.allFinite();
    if (turned) points = framed;
    ComplexPoints polished = points;
    const ComplexRefinement refinement =
        refine(equations_, turned ? std::array{reference.origin, reference.axis, reference.plane} : frame_,
               polished);
    const bool is_singular = !(refinement.reciprocal_condition >= nearly_singular);
    if (!is_singular || apart(points, polished) <= close_together) points = polished;
    return is_singular;
  }

  /// The largest difference of coordinates, relative to the figure's size.
  static double apart(const ComplexPoints& a, const ComplexPoints& b) {
    return (a - b).cwiseAbs().maxCoeff() / std::max(1.0, a.cwiseAbs().maxCoeff());
  }

  void defer(const ComplexPoints& points, int solutions) {
    for (Deferred& other : nearly_singular_)
      if (apart(other.points, points) <= close_together) {
        other.solutions += solutions;
        return;
      }
    nearly_singular_.push_back({points, solutions});
  }

  void settle_nearly_singular() {
    std::vector<Candidate> candidates;
    int expected = 0;
    for (const auto& [points, solutions] : nearly_singular_) {
      candidates.push_back({complex_figure(points), solutions});
      expected += solutions;
    }
    ResolvedCandidates found =
        resolve_nearly_singular(scene_, candidates, report_.candidates, expected, request_.stop);
    for (Candidate& candidate : found.list) list(std::move(candidate));
    if (!found.are_told_apart) note(std::string(too_near));
  }

  /// Into the scene's frame in double-double, rounded at the end.
  bool move_to_frame(ComplexPoints& points, const WidePoints& core) const {
    WidePoints wide = widened(points);
    for (const int p : reduction_.core) wide[p] = core[p];
    if (!refine(equations_, frame_, wide).converged) return false;
    points = narrowed(in_frame(wide, scene_.reference()));
    return true;
  }

  /// Newton's method on real coordinates, with residuals in double-double. False when it leaves the figure.
  bool make_real(Figure& figure, double tolerance) const {
    const Figure framed = scene_.in_frame(figure);
    const Eigen::VectorXd start = system_.coordinates(framed);
    Eigen::VectorXd x = start;
    if (!refine(system_, squares_, x).converged || !((x - start).norm() <= 1e3 * tolerance)) return false;
    figure = system_.figure(x);
    return true;
  }

  const SolveRequest& request_;
  const Scene& scene_;
  const CoreReduction& reduction_;
  std::array<int, 3> frame_;
  DistanceSystem system_;
  std::vector<DoubleDouble> squares_;
  PairEntries lengths_;
  std::vector<DistanceEquation> equations_;
  SolveReport report_;
  std::vector<Deferred> nearly_singular_;
  bool some_are_too_far_ = false;  ///< candidates
};

/// Octahedra with planes: their figures settled on the equations of the scene.
class PlanesSolver {
 public:
  PlanesSolver(const SolveRequest& request, DiagonalMethod method)
      : request_(request),
        method_(method),
        system_(request.scene),
        equations_(general_equations(system_)),
        random_(request.seed),
        classes_(equations_, {.nearby = nearby, .same = nearly_singular}, random_) {}

  SolveReport run() {
    Octahedron octahedron = *find_octahedron_with_planes(request_.scene.problem());
    const PlacedOctahedra first = settle(octahedron);
    for (int choice = 1; choice < 3 && !are_all() && !request_.stop.stop_requested(); ++choice) {
      std::rotate(octahedron.pair.begin(), octahedron.pair.begin() + 1, octahedron.pair.end());
      settle(octahedron);
    }
    if (request_.stop.stop_requested()) return stopped();
    SolveReport report = general_report(system_, equations_, classes_.ends(), {}, random_, request_.stop);
    report.paths.clear();
    report.particulars = particulars(first.total_degree, first.elimination);
    report.generic = pairs;
    if (!are_all()) note_missing(octahedron, first.common_factor, report);
    return report;
  }

 private:
  /// Of a triple zero an eigenvalue is right to 1e-5.
  static constexpr double nearby = 1e-2;

  bool are_all() const { return classes_.ends().size() == pairs; }

  PlacedOctahedra settle(const Octahedron& octahedron) {
    PlacedOctahedra placed = place_with_planes(request_.scene, octahedron, method_);
    for (const Figure& figure : placed.figures) classes_.add(system_.coordinates(figure));
    return placed;
  }

  void note_missing(const Octahedron& octahedron, bool common_factor, SolveReport& report) const {
    const Scene& scene = request_.scene;
    const bool flexible = !has_degrees(scene.problem()) && is_proven_to_flex(scene, octahedron);
    if (flexible || common_factor) return refuse(flexible, report);
    report.status = SolveStatus::partial;
    report.reason = "of the " + std::to_string(pairs) + " pairs of diagonals " +
                    std::to_string(classes_.ends().size()) +
                    " lead to solutions that doubles tell apart; the others are at infinity, multiple or "
                    "ill-conditioned";
  }

  const SolveRequest& request_;
  DiagonalMethod method_;
  SceneSystem system_;
  GeneralEquations equations_;
  std::mt19937_64 random_;
  RegularClasses classes_;
};

class CayleyMengerStrategy final : public Strategy {
 public:
  explicit CayleyMengerStrategy(const CayleyMenger& asked) : method_(asked.method) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (scene.problem().is_general()) return why_not_with_planes(scene);
    if (scene.dimension() != 3 || scene.has_lines()) return "it solves octahedra: six points in space";
    if (scene.is_anchored()) return "it places the octahedron itself, and the instance fixes positions";
    const auto octahedron = find_octahedron(scene.problem(), reduce_to_core(scene.problem(), {}));
    if (!octahedron)
      return "the core is not an octahedron (six points, all distances but three disjoint ones)";
    return why_no_base(scene, *octahedron);
  }

  SolveReport solve(const SolveRequest& request) override {
    if (request.stop.stop_requested()) return stopped();
    if (request.scene.problem().is_general()) return solve_with_planes(request);
    const CoreReduction reduction = reduce_to_core(request.scene.problem(), {});
    WorkCounters work;
    const CoreSolutions core = solve_core(request.scene, reduction, method_, work);
    SolveReport report = Reporter(request, reduction, core.frame).run(core, work);
    if (method_ == DiagonalMethod::univariate)
      add_facts(request, *find_octahedron(request.scene.problem(), reduction), report);
    return report;
  }

 private:
  static std::optional<std::string> why_no_base(const Scene& scene, const Octahedron& octahedron) {
    const PairEntries entries(scene);
    if (roundness_of_base(entries, with_round_base(octahedron, entries)) < flattest)
      return "every face of the octahedron is flat";
    return std::nullopt;
  }

  std::optional<std::string> why_not_with_planes(const Scene& scene) const {
    const ProblemStatement& problem = scene.problem();
    if (scene.dimension() != 3 || problem.has_fixed() || problem.planes.empty())
      return "of general scenes it solves octahedra of points and planes in space, without given positions";
    const auto octahedron = find_octahedron_with_planes(scene.problem());
    if (!octahedron)
      return "it is no octahedron of points and planes (six of them, a distance or an angle of all pairs but "
             "three disjoint ones, each of a point and another element)";
    const Turnings turnings(problem);
    for (int plane = 0; plane < static_cast<int>(problem.planes.size()); ++plane)
      if (turnings.of_plane(plane) >= 0)
        return "no constraint sees a side of plane '" + problem.planes[static_cast<std::size_t>(plane)] + "'";
    if (has_degrees(problem) && method_ == DiagonalMethod::univariate)
      return "method=univariate eliminates exactly, and the cosine of an angle in degrees is no fraction";
    if (auto reason = why_no_base(scene, *octahedron)) return reason;
    return why_not_general(scene);
  }

  SolveReport solve_with_planes(const SolveRequest& request) const {
    SolveReport report = PlanesSolver(request, method_).run();
    if (method_ == DiagonalMethod::univariate)
      add_facts(request, *find_octahedron_with_planes(request.scene.problem()), report);
    return report;
  }

  /// Of the two determinants, exactly; their total degree is there.
  static void add_facts(const SolveRequest& request, const Octahedron& octahedron, SolveReport& report) {
    for (Particular& fact : system_facts(octahedron_determinants(request.scene, octahedron), request))
      if (fact.name != "total_degree") report.particulars.push_back(std::move(fact));
  }

  DiagonalMethod method_;
};

}  // namespace

StrategyEntry cayley_menger_entry() {
  StrategyEntry entry = entry_of<CayleyMengerStrategy, CayleyMenger>();
  entry.summary =
      "solves an octahedron by two Cayley-Menger determinants, all eight pairs of diagonals at once";
  entry.citation = "Hoffmann, Yuan 2000, section 4.1";
  entry.knows_general_scenes = true;
  return entry;
}

}  // namespace gcs
