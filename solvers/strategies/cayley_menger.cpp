/// All solutions of an octahedron at once, by Cayley–Menger determinants.
///
/// Of six points with twelve distances the three non-edges are a perfect matching, (a, a'), (b, b'), (c, c').
/// The determinants of {a, a', b, b', c} and {a, a', b, b', c'} vanish: two equations in the squared
/// diagonals X = |aa'|² and Y = |bb'|², of degree 2 in each. numeric/biquadratic_pair.hpp finds all their 8
/// common zeros, without an initial guess. Each is turned into coordinates (three trilaterations; of the two
/// sides of a' one is the mirror image) and polished by Newton's method on the distances, in C or, for real
/// ones, in R. Where a, a', b, b' are coplanar two solutions share both diagonals (c and c' on the same side
/// or on opposite ones) and the pair is a double zero, which both find.
///
/// Other points may hang on the octahedron: each is placed afterwards, on both sides.
///
/// A pair that escapes to infinity (a closed walk of four lengths with signs sums to zero) is counted as
/// such. The solutions are complete when the multiplicities of those found and the escaped pairs sum to 8;
/// otherwise the report says what is missing. Octahedra that flex (a common factor of the two equations) are
/// named and refused. Hoffmann, Yuan, On Spatial Constraint Solving Approaches, 2000, section 3; Michelucci,
/// Foufou 2004.

#include <algorithm>
#include <cmath>

#include "solvers/model/complex_points.hpp"
#include "solvers/model/core_reduction.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/quality.hpp"
#include "solvers/numeric/biquadratic_pair.hpp"
#include "solvers/strategy.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

constexpr int pairs = 8;  // common zeros of two polynomials of bidegree (2, 2): Bézout on P¹ × P¹

/// Beyond this a diagonal is at infinity if nothing finite comes of it.
constexpr double near_infinity = 1e-6;
/// A candidate that misses a distance which it did not use by more (relative, squared) is none: the error of
/// a double zero is the square root of rounding, that of the height over a plane which it decides the fourth.
constexpr double largest_miss = 1e-2;
/// Below this reciprocal condition a solution is singular: Newton's method then stops about this far from it.
constexpr double singular = 1e-6;
/// Near a double solution, 1e-8 away from it, distances are right to rounding.
constexpr double double_root_residual = 1e-13;
/// Below this a face of the octahedron is flat: nothing can be placed on it.
constexpr double flattest = 1e-12;

/// Squared target lengths between the points of the core; 0 for the non-edges.
class SquaredLengths {
 public:
  SquaredLengths(const Scene& scene)
      : matrix_(Eigen::MatrixXd::Zero(scene.point_count(), scene.point_count())) {
    for (int e = 0; e < scene.constraint_count(); ++e) {
      const auto [p, q] = scene.problem().constraints[e].between;
      matrix_(p, q) = matrix_(q, p) = scene.target_lengths()[e] * scene.target_lengths()[e];
    }
  }
  double operator()(int p, int q) const { return matrix_(p, q); }

 private:
  Eigen::MatrixXd matrix_;
};

/// The six points in three opposite pairs: (a, a'), (b, b'), (c, c').
struct Octahedron {
  std::array<std::array<int, 2>, 3> pair;
};

std::optional<Octahedron> find_octahedron(const Scene& scene, const CoreReduction& reduction) {
  if (reduction.core.size() != 6 || reduction.core_constraints.size() != 12) return std::nullopt;
  std::vector<std::vector<bool>> edge(
      static_cast<std::size_t>(scene.point_count()),
      std::vector<bool>(static_cast<std::size_t>(scene.point_count()), false));
  for (int e : reduction.core_constraints) {
    const auto [p, q] = scene.problem().constraints[e].between;
    edge[p][q] = edge[q][p] = true;
  }
  Octahedron octahedron;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i + 1; j < 6; ++j)
      if (!edge[reduction.core[i]][reduction.core[j]]) {
        if (found == 3) return std::nullopt;
        octahedron.pair[found++] = {reduction.core[i], reduction.core[j]};
      }
  std::vector<int> matched;
  for (const auto& [p, q] : octahedron.pair) matched.insert(matched.end(), {p, q});
  std::sort(matched.begin(), matched.end());
  const bool distinct = std::adjacent_find(matched.begin(), matched.end()) == matched.end();
  return found == 3 && distinct ? std::optional(octahedron) : std::nullopt;
}

/// 16 area² over the fourth power of the longest side.
double roundness(const SquaredLengths& d, int p, int q, int r) {
  const double longest = std::max({d(p, q), d(q, r), d(r, p)});
  const double u = d(p, q) / longest;
  const double v = d(q, r) / longest;
  const double w = d(r, p) / longest;
  return 2 * (u * v + v * w + w * u) - (u * u + v * v + w * w);
}

/// Swaps points within pairs so that the triangle abc, on which all else is placed, is as round as can be.
Octahedron with_round_base(Octahedron octahedron, const SquaredLengths& d) {
  Octahedron best = octahedron;
  double roundest = -1;
  for (int swaps = 0; swaps < 8; ++swaps) {
    Octahedron other = octahedron;
    for (int i = 0; i < 3; ++i)
      if (swaps >> i & 1) std::swap(other.pair[i][0], other.pair[i][1]);
    const double value = roundness(d, other.pair[0][0], other.pair[1][0], other.pair[2][0]);
    if (value <= roundest) continue;
    roundest = value;
    best = other;
  }
  return best;
}

/// The determinant of {a, a', b, b', apex} in the products ξ = (a − apex)·(a' − apex) and
/// η = (b − apex)·(b' − apex), by which X = |a apex|² + |a' apex|² − 2ξ and Y likewise: the 4 × 4 Gram
/// determinant of the vectors from the apex, [P, Q; Qᵀ, R] with ξ in P and η in R,
///   det P · det R − tr(adj P · Q · adj R · Qᵀ) + det² Q.
Biquadratic gram_determinant(const SquaredLengths& d, const Octahedron& o, int apex) {
  const auto [a, a2] = o.pair[0];
  const auto [b, b2] = o.pair[1];
  const auto product = [&](int p, int q) { return (d(p, apex) + d(q, apex) - d(p, q)) / 2; };
  const double aa = d(a, apex);
  const double a2a2 = d(a2, apex);
  const double bb = d(b, apex);
  const double b2b2 = d(b2, apex);
  const double p = product(a, b);
  const double q = product(a, b2);
  const double r = product(a2, b);
  const double s = product(a2, b2);
  const double determinant = p * s - q * r;
  Biquadratic c = Biquadratic::Zero();
  c(2, 2) = 1;
  c(2, 0) = -bb * b2b2;
  c(0, 2) = -aa * a2a2;
  c(1, 1) = -2 * (p * s + q * r);
  c(1, 0) = 2 * (p * r * b2b2 + q * s * bb);
  c(0, 1) = 2 * (a2a2 * p * q + aa * r * s);
  c(0, 0) = aa * a2a2 * bb * b2b2 - a2a2 * (p * p * b2b2 + q * q * bb) - aa * (r * r * b2b2 + s * s * bb) +
            determinant * determinant;
  return c;
}

/// The squared diagonals X and Y as a common zero has them: X = shift − 2ξ.
struct Diagonals {
  Complex x, y;
};

/// Both determinants in the variables of the first apex, and the way back to the diagonals.
class DiagonalEquations {
 public:
  DiagonalEquations(const SquaredLengths& d, const Octahedron& o)
      : shift_x_(sum(d, o.pair[0], o.pair[2][0])), shift_y_(sum(d, o.pair[1], o.pair[2][0])) {
    const double dx = (sum(d, o.pair[0], o.pair[2][1]) - shift_x_) / 2;
    const double dy = (sum(d, o.pair[1], o.pair[2][1]) - shift_y_) / 2;
    first_ = gram_determinant(d, o, o.pair[2][0]);
    second_ = shifted(gram_determinant(d, o, o.pair[2][1]), dx, dy);
  }

  CommonZeros solve() const { return common_zeros(first_, second_); }
  Diagonals diagonals(const CommonZero& zero) const {
    return {shift_x_ - 2.0 * zero.x.value(), shift_y_ - 2.0 * zero.y.value()};
  }

 private:
  static double sum(const SquaredLengths& d, const std::array<int, 2>& pair, int apex) {
    return d(pair[0], apex) + d(pair[1], apex);
  }
  double shift_x_, shift_y_;
  Biquadratic first_, second_;
};

/// Keeps what misses a distance that it did not use by little, the best in any case.
template <class Miss>
std::vector<Eigen::Vector3cd> plausible(const std::array<Eigen::Vector3cd, 2>& both, const Miss& miss) {
  const double first = miss(both[0]);
  const double second = miss(both[1]);
  std::vector<Eigen::Vector3cd> kept;
  if (first <= second || first <= largest_miss) kept.push_back(both[0]);
  if (!(first <= second) || second <= largest_miss) kept.push_back(both[1]);
  return kept;
}

/// Coordinates of the core for a pair of diagonals: up to two figures, four where all is nearly flat.
class CorePlacer {
 public:
  CorePlacer(const Scene& scene, const SquaredLengths& d, const Octahedron& o) : d_(d), o_(o) {
    points_ = ComplexPoints::Zero(3, scene.point_count());
    const auto [a, b, c] = base();
    const double length = std::sqrt(d(a, b));
    const double x = (d(a, b) + d(a, c) - d(b, c)) / (2 * length);
    points_(0, b) = length;
    points_(0, c) = x;
    points_(1, c) = std::sqrt(std::max(0.0, d(a, c) - x * x));
    scale_ = std::max({d(a, b), d(a, c), d(b, c)});
  }

  /// a, b, c: at the origin, on the x-axis and in the xy-plane.
  std::array<int, 3> base() const { return {o_.pair[0][0], o_.pair[1][0], o_.pair[2][0]}; }

  std::vector<ComplexPoints> place(const Diagonals& diagonals) {
    const auto [a, b, c] = base();
    const int a2 = o_.pair[0][1];
    const int b2 = o_.pair[1][1];
    const int c2 = o_.pair[2][1];
    std::vector<ComplexPoints> figures;
    const auto first = on({a, b, c}, {diagonals.x, d_(a2, b), d_(a2, c)});
    const auto second = on({a, b, c}, {d_(b2, a), diagonals.y, d_(b2, c)});
    if (!first || !second) return figures;
    points_.col(a2) = (*first)[0];
    const auto miss_b2 = [&](const Eigen::Vector3cd& p) { return miss(p, a2, d_(a2, b2)); };
    for (const Eigen::Vector3cd& p : plausible(*second, miss_b2)) {
      points_.col(b2) = p;
      const bool use_a2 = height(a2) >= height(b2);
      const int third = use_a2 ? a2 : b2;
      const int other = use_a2 ? b2 : a2;
      const auto last = on({a, b, third}, {d_(c2, a), d_(c2, b), d_(c2, third)});
      if (!last) continue;
      const auto miss_c2 = [&](const Eigen::Vector3cd& q) { return miss(q, other, d_(c2, other)); };
      for (const Eigen::Vector3cd& q : plausible(*last, miss_c2)) {
        points_.col(c2) = q;
        figures.push_back(points_);
      }
    }
    return figures;
  }

 private:
  std::optional<std::array<Eigen::Vector3cd, 2>> on(const std::array<int, 3>& centers,
                                                    const std::array<Complex, 3>& squares) const {
    return trilaterate({points_.col(centers[0]), points_.col(centers[1]), points_.col(centers[2])}, squares);
  }
  double miss(const Eigen::Vector3cd& p, int q, double square) const {
    const Eigen::Vector3cd difference = p - points_.col(q);
    return std::abs((difference.transpose() * difference).value() - square) /
           std::max(scale_, difference.squaredNorm());
  }
  /// Distance from the x-axis, on which a and b lie.
  double height(int p) const { return points_.col(p).tail<2>().norm(); }

  const SquaredLengths& d_;
  const Octahedron& o_;
  ComplexPoints points_;
  double scale_;
};

/// A solution of the core: all its distances follow from the three diagonals.
struct CoreSolution {
  ComplexPoints points;
  std::array<Complex, 3> diagonals;
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
  int escaped = 0;
  int lost = 0;  ///< eigenvalues without any end
  bool flexible = false;
};

class CoreSolver {
 public:
  CoreSolver(const Scene& scene, const CoreReduction& reduction, const Octahedron& octahedron)
      : lengths_(scene),
        octahedron_(with_round_base(octahedron, lengths_)),
        placer_(scene, lengths_, octahedron_) {
    const std::vector<DoubleDouble> squares = target_squares(scene);
    for (int e : reduction.core_constraints) {
      const auto [p, q] = scene.problem().constraints[e].between;
      equations_.push_back({p, q, squares[e]});
      scale_ = std::max(scale_, lengths_(p, q));
    }
  }

  std::array<int, 3> frame() const { return placer_.base(); }

  CoreSolutions run(WorkCounters& work) {
    const DiagonalEquations equations(lengths_, octahedron_);
    const CommonZeros zeros = equations.solve();
    CoreSolutions solutions;
    solutions.flexible = zeros.common_factor;
    if (solutions.flexible) return solutions;
    std::vector<int> hits;  // eigenvalues that lead to each solution
    for (const std::vector<CommonZero>& zeros_here : zeros.of_eigenvalue) {
      const std::vector<int> reached = follow(equations, zeros_here, solutions.list, work);
      hits.resize(solutions.list.size(), 0);
      for (int solution : reached) ++hits[solution];
      if (reached.empty()) ++(is_near_infinity(zeros_here) ? solutions.escaped : solutions.lost);
    }
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (solutions.list[i].is_singular) solutions.list[i].multiplicity = hits[i];
    return solutions;
  }

 private:
  static bool is_near_infinity(const std::vector<CommonZero>& zeros) {
    return std::any_of(zeros.begin(), zeros.end(), [](const CommonZero& zero) {
      return std::min(zero.x.nearness_to_infinity(), zero.y.nearness_to_infinity()) <= near_infinity;
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

  /// Not so where Newton's method stalled on the way to infinity, coordinates being too large for the
  /// lengths.
  bool satisfies_distances(const ComplexPoints& points) const {
    return std::all_of(equations_.begin(), equations_.end(), [&](const DistanceEquation& e) {
      return std::abs(squared_distance_excess(points.col(e.a), points.col(e.b), e.square)) <=
             1e-6 * e.square.value();
    });
  }

  std::optional<CoreSolution> polished(ComplexPoints points, WorkCounters& work) const {
    if (!points.allFinite()) return std::nullopt;
    const ComplexRefinement refinement = refine(equations_, frame(), points);
    work.newton_iterations += refinement.iterations;
    if (!refinement.converged || !satisfies_distances(points)) return std::nullopt;
    CoreSolution solution;
    for (std::size_t i = 0; i < 3; ++i)
      solution.diagonals[i] = squared_distance(points, octahedron_.pair[i][0], octahedron_.pair[i][1]);
    solution.is_singular = refinement.reciprocal_condition < singular;
    solution.points = std::move(points);
    return solution;
  }

  SquaredLengths lengths_;
  Octahedron octahedron_;
  CorePlacer placer_;
  std::vector<DistanceEquation> equations_;
  double scale_ = 0;  ///< the largest squared length
};

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
    if (core.flexible) {
      report_.reason =
          "the octahedron flexes: its two equations have a common factor, so that infinitely many pairs "
          "of diagonals satisfy both";
      return std::move(report_);
    }
    int found = core.escaped;
    for (const CoreSolution& solution : core.list) {
      found += solution.multiplicity;
      hang(0, solution.points, solution);
    }
    report_.generic = std::uint64_t{pairs} << reduction_.placed.size();
    report_.at_infinity = static_cast<std::uint64_t>(core.escaped) << reduction_.placed.size();
    if (found != pairs)
      note("of the " + std::to_string(pairs) + " pairs of diagonals " + std::to_string(found) +
           " are accounted for, escaped ones and multiplicities included");
    report_.status = report_.reason.empty() ? SolveStatus::complete : SolveStatus::partial;
    if (request_.stop.stop_requested()) {
      report_.status = SolveStatus::stopped;
      report_.reason = "stopped on request";
    }
    return std::move(report_);
  }

 private:
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
    move_to_frame(points);
    const double tolerance = core.tolerance() * points.cwiseAbs().maxCoeff();
    Figure real{points.real(), {}, {}};
    const bool is_real = points.imag().cwiseAbs().maxCoeff() <= tolerance && make_real(real, tolerance);
    report_.candidates.push_back({is_real ? real : complex_figure(points), core.multiplicity});
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
    const auto base = with_round_base(*octahedron, lengths);
    if (roundness(lengths, base.pair[0][0], base.pair[1][0], base.pair[2][0]) < flattest)
      return "every face of the octahedron is flat";
    return std::nullopt;
  }

  SolveReport solve(const SolveRequest& request) override {
    if (request.stop.stop_requested()) return stopped();
    const CoreReduction reduction = reduce_to_core(request.scene.problem(), {});
    CoreSolver solver(request.scene, reduction, *find_octahedron(request.scene, reduction));
    WorkCounters work;
    const CoreSolutions core = solver.run(work);
    return Reporter(request, reduction, solver.frame()).run(core, work);
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
