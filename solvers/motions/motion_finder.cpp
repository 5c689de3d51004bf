#include "solvers/motions/motion_finder.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "solvers/certificates/scene_equations.hpp"
#include "solvers/elements/dense_equations.hpp"
#include "solvers/figures/complex_distances.hpp"
#include "solvers/motions/apparent_motion.hpp"
#include "solvers/motions/figure_motion.hpp"
#include "solvers/running/words.hpp"

namespace gcs {
namespace {

using Point = std::vector<std::complex<double>>;

Eigen::Map<const Eigen::VectorXcd> as_vector(const Point& x) {
  return {x.data(), static_cast<Eigen::Index>(x.size())};
}

Eigen::VectorXd real_parts_of(const Point& x) { return as_vector(x).real(); }

Point as_complex(const Eigen::VectorXd& x) { return {x.begin(), x.end()}; }

std::vector<int> all_of(const QuadraticSystem& system) {
  std::vector<int> numbers(system.equations.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// Whether no matrix whose entries differ from these by at most `radius` is singular: |1 − BA| < 1 for a B near the
/// inverse, with the rounding of the product.
bool is_proven_regular(const Eigen::MatrixXcd& a, double radius) {
  const Eigen::Index n = a.rows();
  const Eigen::MatrixXcd inverse = a.partialPivLu().inverse();
  if (!inverse.allFinite()) return false;
  const double rounding = 8 * static_cast<double>(n + 2) * std::numeric_limits<double>::epsilon();
  const Eigen::MatrixXd size = inverse.cwiseAbs();
  const Eigen::MatrixXd off = (Eigen::MatrixXcd::Identity(n, n) - inverse * a).cwiseAbs() +
                              rounding * (size * a.cwiseAbs()) +
                              size * Eigen::MatrixXd::Constant(n, n, radius);
  return off.rowwise().sum().maxCoeff() < 0.5;
}

/// Pairs that share something, together.
std::vector<std::vector<int>> groups_of(const std::vector<std::array<int, 2>>& pairs) {
  std::vector<std::vector<int>> groups;
  for (const auto& [a, b] : pairs) {
    const auto holds = [](int one) {
      return [one](const auto& group) { return std::ranges::count(group, one) > 0; };
    };
    const auto found = std::ranges::find_if(groups, holds(a));
    std::vector<int>& group = found == groups.end() ? groups.emplace_back(1, a) : *found;
    if (std::ranges::count(group, b) == 0) group.push_back(b);
  }
  return groups;
}

std::string kind_in_words(const Motion& motion) {
  const std::string least = motion.is_exact ? "" : " or more";
  if (motion.dimension == 1) return "a curve" + least;
  return motion.dimension == 2 ? "a surface" + least
                               : "dimension " + std::to_string(motion.dimension) + least;
}

}  // namespace

MotionFinder::MotionFinder(const Scene& scene, const DistanceSystem& system, std::mt19937_64& random)
    : scene_(scene), system_(system), random_(random) {
  if (!scene.problem().is_general() && !scene.has_lines() && !scene.is_anchored())
    search_.emplace(scene, system, SceneEquations(scene).system());
}

std::optional<Collapse> MotionFinder::loose_at(const Point& x, double uncertainty) const {
  if (!search_) return std::nullopt;
  const double tolerance = uncertainty * (1 + as_vector(x).cwiseAbs().maxCoeff());
  const ComplexPoints points = complex_points(complex_figure(system_, Eigen::VectorXcd(as_vector(x))));
  for (const bool with_parallel_bars : {false, true}) {
    auto collapse = search_->at(points, tolerance, with_parallel_bars);
    if (collapse && collapse->looseness() > 0) return collapse;
  }
  return std::nullopt;
}

bool MotionFinder::lies_on_motion(const Collapse& loose, const Point& x) {
  const auto is_same = [&](const Motion& motion) {
    return motion.coincident == loose.coincident && motion.parallel == loose.parallel;
  };
  const std::optional<LoosePoint> near = proven_near(loose.equations, x);
  if (near && std::ranges::none_of(motions_, is_same)) add_motion(loose, *near);
  return near.has_value();
}

std::optional<MotionFinder::LoosePoint> MotionFinder::proven(const QuadraticSystem& loose,
                                                             const Point& start) const {
  const auto zero = zero_near(DenseEquations(loose), all_of(loose), start);
  if (!zero) return std::nullopt;
  const Certificate certificate = Certifier(held_at(loose, *zero, 0)).certify(*zero);
  if (!certificate.is_proven) return std::nullopt;
  return LoosePoint{*zero, certificate.enclosure, certificate.realness == Certificate::Realness::real};
}

/// At x, or as near to it as another component that goes through x lets be.
std::optional<MotionFinder::LoosePoint> MotionFinder::proven_near(const QuadraticSystem& loose,
                                                                  const Point& x) {
  constexpr int tries = 4;
  constexpr double nearby = 1e-2;
  std::normal_distribution<double> normal(0, 0.1 * nearby);
  Point start = x;
  for (int i = 0; i < tries; ++i) {
    const auto point = proven(loose, start);
    if (point && (as_vector(point->x) - as_vector(x)).cwiseAbs().maxCoeff() <=
                     nearby * (1 + as_vector(x).cwiseAbs().maxCoeff()))
      return point;
    start = x;
    for (std::complex<double>& entry : start) {
      const double re = normal(random_), im = normal(random_);
      entry += std::complex(re, im);
    }
  }
  return std::nullopt;
}

std::optional<MotionFinder::LoosePoint> MotionFinder::proven_real(const QuadraticSystem& loose) {
  constexpr int tries = 20;
  std::normal_distribution<double> normal(0, scene_.size());
  for (int i = 0; i < tries; ++i) {
    Point start(static_cast<std::size_t>(loose.unknowns));
    for (std::complex<double>& entry : start) entry = normal(random_);
    if (auto point = proven(loose, start); point && point->is_real) return point;
  }
  return std::nullopt;
}

/// Whether the scene's Jacobian is proven to have a rank of at least unknowns − dimension at the solution: no component
/// through it is larger.
bool MotionFinder::has_corank(const LoosePoint& point, int dimension) const {
  const Eigen::MatrixXcd jacobian = DenseEquations(search_->distances()).jacobian(point.enclosure.mid);
  const Eigen::FullPivLU<Eigen::MatrixXcd> factors(jacobian);
  const Eigen::Index order = jacobian.cols() - dimension;
  const Eigen::PermutationMatrix<Eigen::Dynamic> order_of_rows(factors.permutationP().inverse());
  const Eigen::VectorXi rows = order_of_rows.indices().head(order),
                        columns = factors.permutationQ().indices().head(order);
  double radius = 0;
  for (const std::complex<double>& r : point.enclosure.radius)
    radius = std::max({radius, r.real(), r.imag()});
  // An entry is twice a difference of two coordinates, each off by at most √2 radius, and rounded.
  const double off = 6 * radius + 4 * std::numeric_limits<double>::epsilon() * jacobian.cwiseAbs().maxCoeff();
  return is_proven_regular(jacobian(rows, columns), off);
}

void MotionFinder::add_motion(const Collapse& collapse, const LoosePoint& near) {
  const std::optional<LoosePoint> real = near.is_real ? near : proven_real(collapse.equations);
  const LoosePoint& shown = real ? *real : near;
  const int dimension = collapse.looseness();
  Figure figure = complex_figure(system_, Eigen::VectorXcd(as_vector(shown.enclosure.mid)));
  FigureCurve curve;
  if (shown.is_real) {
    const Eigen::VectorXd x = real_parts_of(shown.enclosure.mid);
    figure = system_.figure(x);
    const RealEquations held = real_equations(held_at(collapse.equations, as_complex(x), 1));
    curve = motion_from(
        scene_, held, held, x, [this](const Eigen::VectorXd& at) { return system_.figure(at); },
        most_motion_steps);
  }
  motions_.push_back({collapse.coincident, collapse.parallel, dimension, has_corank(shown, dimension), true,
                      std::move(figure), std::move(curve)});
}

void MotionFinder::look_for_apparent_motion(const Point& x) {
  if (!search_) return;
  auto motion = apparent_motion(
      scene_, real_equations(search_->distances()), real_parts_of(x),
      [this](const Eigen::VectorXd& at) { return system_.figure(at); }, random_);
  if (motion) motions_.push_back(*std::move(motion));
}

std::string place_in_words(const ProblemStatement& problem, const Motion& motion) {
  std::string text;
  for (const std::vector<int>& group : groups_of(motion.coincident)) {
    text += text.empty() ? "" : ", ";
    for (const int point : group)
      text += (point == group.front() ? "" : " = ") + problem.points[static_cast<std::size_t>(point)];
  }
  for (const auto& [one, other] : motion.parallel)
    text += (text.empty() ? "" : ", ") + problem.constraints[static_cast<std::size_t>(one)].id + " ∥ " +
            problem.constraints[static_cast<std::size_t>(other)].id;
  return text;
}

std::string in_words(const ProblemStatement& problem, const std::vector<Motion>& all) {
  std::vector<Motion> motions;
  std::ranges::copy_if(all, std::back_inserter(motions), &Motion::is_proven);
  if (motions.empty()) return "";
  constexpr std::size_t most_named = 3;
  std::string text = "infinitely many solutions, proven: ";
  for (std::size_t i = 0; i < std::min(motions.size(), most_named); ++i)
    text += (i == 0 ? "" : "; ") + kind_in_words(motions[i]) +
            (motions[i].figure.is_real() ? "" : " of complex ones") + " where " +
            place_in_words(problem, motions[i]);
  if (motions.size() > most_named) text += "; and " + counted(std::ssize(motions) - 3, "motion") + " more";
  return text;
}

}  // namespace gcs
