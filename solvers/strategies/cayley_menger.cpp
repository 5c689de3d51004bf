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
/// Other points may hang on the octahedron: each is placed afterwards, on both sides.
///
/// How many solutions are at infinity is decided by the file's own numbers. The solutions are complete when
/// the multiplicities of those found and these sum to 8; otherwise the report says what is missing, or that
/// the octahedron is proven to flex (octahedron/exact_squares.hpp). Hoffmann, Yuan, On Spatial Constraint
/// Solving Approaches, 2000, section 3; Michelucci, Foufou 2004.

#include <algorithm>
#include <cmath>

#include "solvers/certification/proven_error.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/quality.hpp"
#include "solvers/octahedron/exact_squares.hpp"
#include "solvers/octahedron/octahedron_placer.hpp"
#include "solvers/strategy.hpp"
#include "solvers/words.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

constexpr int pairs = 8;  // common zeros of two polynomials of bidegree (2, 2): Bézout on P¹ × P¹

/// Coordinates beyond this (times the longest edge) leave less than six digits of the squared lengths in
/// doubles.
constexpr double far_away = 1e5;
/// Below this reciprocal condition a solution is singular: Newton's method then stops about this far from it.
constexpr double singular = 1e-6;
/// Below this a face of the octahedron is flat: nothing can be placed on it.
constexpr double flattest = 1e-12;

/// A solution of the core: all its distances follow from the three diagonals.
struct CoreSolution {
  ComplexPoints points;
  std::array<Complex, 3> diagonals;
  WidePoints wide;  ///< the same points where rounding them to doubles loses some distances; or empty
  bool is_singular = false;
  int multiplicity = 1;

  double tolerance() const { return is_singular ? 1e-5 : 1e-9; }  ///< relative to the figure's squared size
};

bool same(const CoreSolution& p, const CoreSolution& q) {
  const double tolerance = std::max(p.tolerance(), q.tolerance());
  double size = 1;
  double difference = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    size = std::max(size, std::abs(p.diagonals[i]));
    difference = std::max(difference, std::abs(p.diagonals[i] - q.diagonals[i]));
  }
  return difference <= tolerance * size;
}

/// What the eight eigenvalues came to.
struct CoreSolutions {
  std::vector<CoreSolution> list;
  std::array<int, 3> frame{};  ///< points at the origin, on the x-axis and in the xy-plane
  int at_infinity = 0;
  int far_away = 0;            ///< eigenvalues that led to no solution but far away
  bool common_factor = false;  ///< to rounding
  bool flexible = false;       ///< proven

  int accounted_for() const {
    int count = at_infinity;
    for (const CoreSolution& solution : list) count += solution.multiplicity;
    return count;
  }
  /// Nothing that a curve of solutions may have left behind.
  bool are_all_isolated() const {
    return accounted_for() == pairs &&
           std::none_of(list.begin(), list.end(),
                        [](const CoreSolution& solution) { return solution.is_singular; });
  }
};

class CoreSolver {
 public:
  CoreSolver(const Scene& scene, const CoreReduction& reduction, const Octahedron& octahedron)
      : lengths_(scene),
        octahedron_(with_round_base(octahedron, lengths_)),
        placer_(scene.point_count(), lengths_, octahedron_) {
    const std::vector<DoubleDouble> squares = target_squares(scene);
    for (int e : reduction.core_constraints) {
      const auto [p, q] = scene.problem().constraints[e].between;
      equations_.push_back({p, q, squares[e]});
      scale_ = std::max(scale_, lengths_(p, q));
    }
  }

  CoreSolutions run(WorkCounters& work) {
    const DiagonalEquations equations(lengths_, octahedron_);
    const CommonZeros zeros = equations.solve();
    CoreSolutions solutions;
    solutions.frame = placer_.base();
    solutions.common_factor = zeros.common_factor;
    std::vector<int> hits;  // eigenvalues that lead to each solution
    for (const std::vector<CommonZero>& zeros_here : zeros.of_eigenvalue) {
      const std::vector<int> reached = follow(equations, zeros_here, solutions.list, work);
      hits.resize(solutions.list.size(), 0);
      for (int solution : reached) ++hits[solution];
      if (reached.empty() && is_far_away(equations, zeros_here)) ++solutions.far_away;
    }
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (solutions.list[i].is_singular) solutions.list[i].multiplicity = hits[i];
    return solutions;
  }

 private:
  /// All that is placed with these diagonals, if anything is.
  bool is_far_away(const DiagonalEquations& equations, const std::vector<CommonZero>& zeros) {
    return std::all_of(zeros.begin(), zeros.end(), [&](const CommonZero& zero) {
      const std::vector<ComplexPoints> placed = placer_.place(equations.diagonals(zero));
      return std::all_of(placed.begin(), placed.end(), [&](const ComplexPoints& points) {
        return !(points.cwiseAbs().maxCoeff() <= far_away * std::sqrt(scale_));
      });
    });
  }

  /// The solutions that an eigenvalue leads to, by index; new ones are appended.
  std::vector<int> follow(const DiagonalEquations& equations, const std::vector<CommonZero>& zeros,
                          std::vector<CoreSolution>& list, WorkCounters& work) {
    std::vector<int> reached;
    for (const CommonZero& zero : zeros)
      for (ComplexPoints& points : placer_.place(equations.diagonals(zero))) {
        const auto solution = polished(std::move(points), work);
        if (!solution || !comes_from(*solution, equations.diagonals(zero))) continue;
        const auto known = std::find_if(list.begin(), list.end(),
                                        [&](const CoreSolution& other) { return same(*solution, other); });
        const int index = static_cast<int>(known - list.begin());
        if (known == list.end()) list.push_back(*solution);
        if (std::find(reached.begin(), reached.end(), index) == reached.end()) reached.push_back(index);
      }
    return reached;
  }

  /// Newton's method has not wandered off. Of a triple zero an eigenvalue is right to 1e-5.
  bool comes_from(const CoreSolution& solution, const Diagonals& diagonals) const {
    const auto is_near = [this](Complex found, Complex wanted) {
      return std::abs(found - wanted) <= 1e-2 * (scale_ + std::abs(wanted));
    };
    return is_near(solution.diagonals[0], diagonals.x) && is_near(solution.diagonals[1], diagonals.y);
  }

  /// Not so where Newton's method stalled on the way to infinity, or on a curve of near solutions that leads
  /// there: the rounding of coordinates so large leaves less than six digits of a squared length.
  bool satisfies_distances(const ComplexPoints& points) const { return satisfies_distances(widened(points)); }
  bool satisfies_distances(const WidePoints& points) const {
    return std::all_of(equations_.begin(), equations_.end(), [&](const DistanceEquation& e) {
      return std::abs(squared_distance_excess(points[e.a], points[e.b], e.square)) <= 1e-6 * e.square.value();
    });
  }

  std::optional<CoreSolution> polished(ComplexPoints points, WorkCounters& work) const {
    if (!points.allFinite()) return std::nullopt;
    const ComplexRefinement refinement = refine(equations_, placer_.base(), points);
    work.newton_iterations += refinement.iterations;
    if (!refinement.converged) return std::nullopt;
    if (!satisfies_distances(points)) return widely_polished(points, work);
    CoreSolution solution{points, diagonals(points), {}};
    solution.is_singular = refinement.reciprocal_condition < singular;
    return solution;
  }

  std::optional<CoreSolution> widely_polished(const ComplexPoints& points, WorkCounters& work) const {
    WidePoints wide = widened(points);
    const ComplexRefinement refinement = refine(equations_, placer_.base(), wide);
    work.newton_iterations += refinement.iterations;
    if (!refinement.converged || !satisfies_distances(wide)) return std::nullopt;
    return CoreSolution{narrowed(wide), diagonals(wide), wide};
  }

  template <class Points>
  std::array<Complex, 3> diagonals(const Points& points) const {
    const auto square = [&](const std::array<int, 2>& pair) {
      return squared_distance(points, pair[0], pair[1]);
    };
    return {square(octahedron_.pair[0]), square(octahedron_.pair[1]), square(octahedron_.pair[2])};
  }

  SquaredLengths lengths_;
  Octahedron octahedron_;
  OctahedronPlacer placer_;
  std::vector<DistanceEquation> equations_;
  double scale_ = 0;  ///< the largest squared length
};

/// With each choice of two diagonals until nothing is missing: of a, a', b, b' that are coplanar, or nearly,
/// at solutions the diagonals say little of where c and c' are.
CoreSolutions solve_core(const Scene& scene, const CoreReduction& reduction, WorkCounters& work) {
  Octahedron octahedron = *find_octahedron(scene, reduction);
  CoreSolutions best = CoreSolver(scene, reduction, octahedron).run(work);
  if (best.accounted_for() != pairs) best.at_infinity = stretched_walks(scene, octahedron);
  for (int choice = 1; choice < 3 && best.accounted_for() != pairs; ++choice) {
    std::rotate(octahedron.pair.begin(), octahedron.pair.begin() + 1, octahedron.pair.end());
    CoreSolutions found = CoreSolver(scene, reduction, octahedron).run(work);
    found.at_infinity = best.at_infinity;
    if (found.accounted_for() > best.accounted_for()) best = std::move(found);
  }
  best.flexible = !best.are_all_isolated() && is_proven_to_flex(scene, octahedron);
  return best;
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
    if (core.flexible || core.common_factor) return refused(core.flexible);
    for (const CoreSolution& solution : core.list) hang(0, solution.points, solution);
    report_.generic = std::uint64_t{pairs} << reduction_.placed.size();
    report_.at_infinity = static_cast<std::uint64_t>(core.at_infinity) << reduction_.placed.size();
    if (core.accounted_for() != pairs) note(what_is_missing(core));
    if (some_are_too_far_) note("some coordinates are " + too_large_for_doubles());
    report_.status = report_.reason.empty() ? SolveStatus::complete : SolveStatus::partial;
    if (request_.stop.stop_requested()) {
      report_.status = SolveStatus::stopped;
      report_.reason = "stopped on request";
    }
    return std::move(report_);
  }

 private:
  SolveReport refused(bool is_proven) {
    report_.status = is_proven ? SolveStatus::infinite : SolveStatus::gave_up;
    report_.reason = is_proven
                         ? "the octahedron flexes: its two equations have a common factor, proven with the "
                           "exact lengths, so that a curve of complex solutions satisfies them"
                         : "the two equations of the octahedron have a common factor to rounding: it is so "
                           "near one that flexes that doubles do not tell its solutions apart";
    return std::move(report_);
  }

  static std::string what_is_missing(const CoreSolutions& core) {
    const std::string found = "of the " + std::to_string(pairs) + " pairs of diagonals " +
                              std::to_string(core.accounted_for()) +
                              " are accounted for, those at infinity and multiplicities included";
    return found +
           (core.far_away > core.at_infinity
                ? "; others have coordinates " + too_large_for_doubles()
                : "; from others Newton's method did not settle, as where solutions are ill-conditioned");
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
    if (core.wide.empty())
      move_to_frame(points);
    else if (!move_to_frame(points, core.wide))
      return note("Newton's method did not settle at a solution whose distances doubles do not hold");
    const double tolerance = core.tolerance() * points.cwiseAbs().maxCoeff();
    Figure real{points.real(), {}, {}};
    const bool is_real = points.imag().cwiseAbs().maxCoeff() <= tolerance && make_real(real, tolerance);
    Candidate candidate{is_real ? real : complex_figure(points), core.multiplicity};
    if (!core.wide.empty()) candidate.error = proven_error(scene_, squares_, candidate.figure);
    some_are_too_far_ |= loses_distances(scene_, candidate.figure);
    report_.candidates.push_back(std::move(candidate));
  }

  /// Into the scene's frame, polished there: turning by a complex rotation has cost accuracy.
  void move_to_frame(ComplexPoints& points) const {
    const Reference& reference = scene_.reference();
    ComplexPoints framed = in_frame(points, 3, reference);
    const bool turned = framed.allFinite();
    ComplexPoints& polished = turned ? framed : points;
    refine(equations_, turned ? std::array{reference.origin, reference.axis, reference.plane} : frame_,
           polished);
    points = polished;
  }

  /// The same in double-double with the points of the core, rounded at the end.
  bool move_to_frame(ComplexPoints& points, const WidePoints& core) const {
    WidePoints wide = widened(points);
    for (const int p : reduction_.core) wide[p] = core[p];
    if (!refine(equations_, frame_, wide).converged) return false;
    points = narrowed(in_frame(wide, scene_.reference()));
    return true;
  }

  /// Newton's method on real coordinates, with residuals in double-double. False when it leaves the figure
  /// and this is no solution as it stands (a double one is).
  bool make_real(Figure& figure, double tolerance) const {
    const Figure framed = scene_.in_frame(figure);
    const Eigen::VectorXd start = system_.coordinates(framed);
    Eigen::VectorXd x = start;
    if (refine(system_, squares_, x).converged && (x - start).norm() <= 1e3 * tolerance) {
      figure = system_.figure(x);
      return true;
    }
    return relative_residual(scene_, figure) <= double_root_residual;
  }

  const SolveRequest& request_;
  const Scene& scene_;
  const CoreReduction& reduction_;
  std::array<int, 3> frame_;
  DistanceSystem system_;
  std::vector<DoubleDouble> squares_;
  SquaredLengths lengths_;
  std::vector<DistanceEquation> equations_;
  SolveReport report_;
  bool some_are_too_far_ = false;  ///< candidates
};

SolveReport stopped() {
  SolveReport report;
  report.status = SolveStatus::stopped;
  report.reason = "stopped on request";
  return report;
}

class CayleyMenger final : public Strategy {
 public:
  std::optional<std::string> why_unsupported(const Scene& scene) const override {
    if (scene.dimension() != 3 || scene.has_lines()) return "it solves octahedra: six points in space";
    if (scene.is_anchored()) return "it places the octahedron itself, and the instance fixes positions";
    const auto octahedron = find_octahedron(scene, reduce_to_core(scene.problem(), {}));
    if (!octahedron)
      return "the core is not an octahedron (six points, all distances but three disjoint ones)";
    const SquaredLengths lengths(scene);
    if (roundness_of_base(lengths, with_round_base(*octahedron, lengths)) < flattest)
      return "every face of the octahedron is flat";
    return std::nullopt;
  }

  SolveReport solve(const SolveRequest& request) override {
    if (request.stop.stop_requested()) return stopped();
    const CoreReduction reduction = reduce_to_core(request.scene.problem(), {});
    WorkCounters work;
    const CoreSolutions core = solve_core(request.scene, reduction, work);
    return Reporter(request, reduction, core.frame).run(core, work);
  }
};

}  // namespace

StrategyEntry cayley_menger_entry() {
  StrategyEntry entry;
  entry.name = "cayley-menger";
  entry.summary =
      "solves an octahedron by two Cayley-Menger determinants, all eight pairs of diagonals at once";
  entry.citation = "Hoffmann, Yuan 2000, section 3";
  entry.make = [](const OptionMap&) -> std::unique_ptr<Strategy> { return std::make_unique<CayleyMenger>(); };
  return entry;
}

}  // namespace gcs
