#include "solvers/homotopies/precise_ends.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/certificates/escapes.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/figures/complex_distances.hpp"
#include "solvers/figures/residual_and_condition.hpp"

namespace gcs {
namespace {

constexpr double last_sigma = 1e-60;
/// Unknowns³ of all ends together: seconds.
constexpr double most_work = 5e4;

constexpr double sigma_bits = 200;  // of last_sigma

/// Coordinates like σ^(−p) are squared, and the condition number grows as fast: four times their bits, beside those of σ
/// itself and a margin.
slong bits_for(double power) { return static_cast<slong>(512 + 4 * power * sigma_bits); }

/// A point of a path.
struct Station {
  double log_sigma = 0;
  BallMatrix x;
};

/// Follows one path by the equations f(x) − A − σ·way of a scene of distances.
class PreciseEnd {
 public:
  PreciseEnd(const QuadraticSystem& system, slong bits, const ComplexVectorX& way)
      : system_(system), way_(BallKrawczyk::vector(way)) {
    for (slong fewer = fewest_bits; fewer < bits; fewer *= 2) equations_.emplace_back(system, fewer);
    equations_.emplace_back(system, bits);
  }

  /// The end, from x at the beginning of the endgame; one that failed where Newton's method does not get there.
  PathEnd run(const ComplexVectorX& start, const std::stop_token& stop) {
    BallMatrix x = BallKrawczyk::vector(start);
    if (!missed(first_radius, 0.1, near_path, x)) return {};
    std::deque<Station> stations{{std::log(first_radius), x}};
    double step = 1e-3, last_tested = 0;
    while (stations.back().log_sigma > std::log(last_sigma)) {
      if (stations.back().log_sigma < last_tested - worth_a_test) {
        if (is_approximate_zero(stations.back().x)) return end_next_to(stations.back().x);
        last_tested = stations.back().log_sigma;
      }
      choose_precision(stations.back().log_sigma);
      Station next = extrapolated(stations, stations.back().log_sigma - step);
      const auto off = missed(std::exp(next.log_sigma), most_missed, near_path, next.x);
      step *= change_of_step(off, stations.size());
      if (!(step > shortest_step) || stop.stop_requested()) return {};
      if (!off) continue;
      stations.push_back(std::move(next));
      if (stations.size() > most_stations) stations.pop_front();
    }
    return end_at_infinity(stations.back(), stations.front());
  }

 private:
  static constexpr std::size_t most_stations = 12;
  /// Beside edges: a path that is a tenth of its edges away is taken for this one now and then.
  static constexpr double most_missed = 1e-3;
  /// To it stations are on the path: far below most_missed, so that a polynomial through them tells.
  static constexpr double near_path = 1e-12;
  static constexpr double shortest_step = 1e-8;
  static constexpr double worth_a_test = 0.5;  ///< of log σ: a test costs as much as a step
  static constexpr slong fewest_bits = 192;

  const BallKrawczyk& equations() const { return equations_[level_]; }
  slong bits() const { return equations().bits(); }

  /// What bits_for asks for at the last σ, at this one.
  void choose_precision(double log_sigma) {
    const double share = log_sigma / std::log(last_sigma);
    const double needed = fewest_bits / 2.0 + share * static_cast<double>(equations_.back().bits());
    while (level_ + 1 < equations_.size() && static_cast<double>(bits()) < needed) ++level_;
  }

  /// A polynomial through n stations misses by the n-th power of the step.
  static double change_of_step(const std::optional<double>& off, std::size_t stations) {
    constexpr double most = 1.5, aim = 0.1 * most_missed;
    if (!off) return 0.5;
    return std::min(most, std::pow(aim / *off, 1.0 / static_cast<double>(stations)));
  }

  /// By Lagrange's polynomial through all stations.
  Station extrapolated(const std::deque<Station>& stations, double log_sigma) const {
    Station result{log_sigma, BallMatrix(way_.rows(), 1)};
    Ball factor;
    for (const Station& station : stations) {
      double weight = 1;
      for (const Station& other : stations)
        if (&other != &station)
          weight *= (log_sigma - other.log_sigma) / (station.log_sigma - other.log_sigma);
      acb_set_d(factor, weight);
      for (slong i = 0; i < way_.rows(); ++i) acb_addmul(result.x(i, 0), factor, station.x(i, 0), bits());
    }
    acb_mat_get_mid(result.x.get(), result.x.get());
    return result;
  }

  BallMatrix residual(const BallMatrix& x, double sigma) const {
    BallMatrix value = equations().value(x);
    Ball factor;
    acb_set_d(factor, -sigma);
    for (slong e = 0; e < value.rows(); ++e) acb_addmul(value(e, 0), factor, way_(e, 0), bits());
    return value;
  }

  /// Newton's method until a correction is at most `last` beside every edge, where each is far below the one before. The
  /// first one, if it is at most `allowed`.
  std::optional<double> missed(double sigma, double allowed, double last, BallMatrix& x) const {
    constexpr int most_steps = 20;
    constexpr double contraction = 0.25;
    BallMatrix correction(x.rows(), 1);
    std::optional<double> first;
    for (int step = 0; step < most_steps; ++step) {
      if (!acb_mat_approx_solve(correction.get(), equations().jacobian(x).get(), residual(x, sigma).get(),
                                bits()))
        return std::nullopt;
      const double length = beside_edges(correction, x);
      if (!(length <= allowed)) return std::nullopt;
      if (!first) first = length;
      acb_mat_sub(x.get(), x.get(), correction.get(), bits());
      acb_mat_get_mid(x.get(), x.get());
      if (length <= last) return first;
      allowed = contraction * length;
    }
    return std::nullopt;
  }

  /// The largest |form(x)| of an equation's squares: of an edge, its longest part along an axis.
  double edge(const QuadraticEquation& equation, const BallMatrix& x) const {
    double longest = 0;
    for (const FormProduct& product : equation.products) {
      const BallMatrix value = along(product.left, x, 1);
      longest = std::max(longest, magnitude(value(0, 0)));
    }
    return longest;
  }

  /// A form without its constant, of each column.
  BallMatrix along(const LinearForm& form, const BallMatrix& columns, slong count) const {
    BallMatrix sum(1, count);
    for (const auto& [unknown, coefficient] : form.terms)
      for (slong c = 0; c < count; ++c)
        acb_addmul_si(sum(0, c), columns(unknown, c), coefficient.value.real() < 0 ? -1 : 1, bits());
    return sum;
  }

  double beside_edges(const BallMatrix& correction, const BallMatrix& x) const {
    double largest = 0;
    for (const QuadraticEquation& equation : system_.equations)
      largest = std::max(largest, edge(equation, correction) / edge(equation, x));
    return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
  }

  /// Whether α < (13 − 3·√17)/4 at σ = 0.
  bool is_approximate_zero(const BallMatrix& x) const {
    constexpr double most_alpha = 0.157;
    const BallMatrix jacobian = equations().jacobian(x);
    BallMatrix inverse(x.rows(), x.rows()), correction(x.rows(), 1);
    if (!acb_mat_approx_solve(correction.get(), jacobian.get(), residual(x, 0).get(), bits())) return false;
    const double beta = beside_edges(correction, x);
    return beta < most_alpha && acb_mat_approx_inv(inverse.get(), jacobian.get(), bits()) != 0 &&
           beta * gamma(inverse, x) < most_alpha;
  }

  /// |D²f_e(h, h)| is at most 2·(its squares)·|x_a − x_b|² for |h| ≤ 1.
  double gamma(const BallMatrix& inverse, const BallMatrix& x) const {
    std::vector<double> edges, bends;
    for (const QuadraticEquation& equation : system_.equations) {
      edges.push_back(edge(equation, x));
      bends.push_back(2 * static_cast<double>(equation.products.size()) * edges.back() * edges.back());
    }
    double largest = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (const FormProduct& product : system_.equations[i].products) {
        const BallMatrix row = along(product.left, inverse, inverse.columns());
        double sum = 0;
        for (std::size_t e = 0; e < edges.size(); ++e)
          sum += magnitude(row(0, static_cast<slong>(e))) * bends[e];
        largest = std::max(largest, sum / edges[i] / 2);
      }
    return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
  }

  static ComplexVectorX rounded(const BallMatrix& x) {
    ComplexVectorX result;
    for (slong i = 0; i < x.rows(); ++i) result.push_back(rounded_midpoint(x(i, 0)));
    return result;
  }

  PathEnd end_next_to(BallMatrix x) {
    level_ = equations_.size() - 1;
    const double settled = std::ldexp(1.0, static_cast<int>(-bits() / 4));
    if (!missed(0, 0.1, settled, x)) return {};
    return {PathEnd::Kind::regular, rounded(x), 1, 0, true, "", {}, true};
  }

  /// Where x grows like a power of 1/σ, k/w with a small w; else the end is a multiple one, or none.
  static PathEnd end_at_infinity(const Station& last, const Station& before) {
    constexpr double beyond_doubles = 1e14, close = 0.02;
    constexpr int most_winding = 8;
    const double power =
        std::log(largest(rounded(last.x)) / largest(rounded(before.x))) / (before.log_sigma - last.log_sigma);
    for (int w = 1; w <= most_winding; ++w) {
      const double order = std::round(w * power);
      if (order < 1 || std::abs(w * power - order) > close || largest(rounded(last.x)) < beyond_doubles)
        continue;
      return {PathEnd::Kind::at_infinity, rounded(last.x), w, static_cast<int>(order), true, "", {}, true};
    }
    return {};
  }

  const QuadraticSystem& system_;
  std::vector<BallKrawczyk> equations_;  ///< in rising precision
  std::size_t level_ = 0;                ///< of those
  BallMatrix way_;
};

/// Whether the squared lengths in doubles, at which x = 0 misses the system's, are not exactly the file's.
bool are_rounded(const BallKrawczyk& equations, const ComplexVectorX& squares) {
  const BallMatrix missed = equations.value(BallMatrix(static_cast<slong>(squares.size()), 1));
  Ball sum;
  for (std::size_t e = 0; e < squares.size(); ++e) {
    acb_set_d_d(sum, squares[e].real(), squares[e].imag());
    acb_add(sum, sum, missed(static_cast<slong>(e), 0), bits_for(1));
    if (!acb_is_zero(sum)) return true;
  }
  return false;
}

/// Of one that failed that of most poles.
double power_of(const PathEnd& end) {
  return end.pole_order > 0 ? static_cast<double>(end.pole_order) / end.winding_number : 1;
}

/// All of a scene, on their way between two lists of squared lengths.
class PreciseEnds {
 public:
  PreciseEnds(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to)
      : scene_(scene), to_(to), system_(SceneEquations(scene).system()) {
    for (std::size_t e = 0; e < to.size(); ++e) way_.push_back(from[e] - to[e]);
  }

  /// Whether the squared lengths in doubles are the file's.
  bool are_exact() const { return !are_rounded(BallKrawczyk(system_, bits_for(1)), to_); }
  /// Whether points may be at infinity: in space where the file's lengths let them escape.
  bool may_escape() const { return scene_.dimension() == 2 || !closed_walks(scene_).empty(); }
  bool are_few(std::ptrdiff_t ends) const {
    return static_cast<double>(ends) * std::pow(system_.unknowns, 3) <= most_work;
  }

  /// Whether the path has an end, which replaces `end`. `power`: it may run away so fast, in 1/σ.
  bool follow(const ComplexVectorX& before, double power, const std::stop_token& stop, PathEnd& end) const {
    PathEnd precise = PreciseEnd(system_, bits_for(power), way_).run(before, stop);
    const bool is_end = precise.kind == PathEnd::Kind::regular ||
                        (precise.kind == PathEnd::Kind::at_infinity && may_escape());
    if (is_end) end = std::move(precise);
    return is_end;
  }

 private:
  const Scene& scene_;
  const ComplexVectorX& to_;
  QuadraticSystem system_;
  ComplexVectorX way_;
};

bool is_doubtful(const Scene& scene, const PathEnd& end) {
  if (end.is_precise) return false;
  if (end.kind == PathEnd::Kind::regular)
    return is_stiff(scene, complex_figure(DistanceSystem(scene), Eigen::Map<const Eigen::VectorXcd>(
                                                                     end.x.data(), std::ssize(end.x))));
  return end.kind == PathEnd::Kind::singular;
}

void doubt(std::vector<PathEnd>& ends) {
  for (PathEnd& end : ends) {
    if (end.kind != PathEnd::Kind::at_infinity) continue;
    end.kind = PathEnd::Kind::failed;
    end.cause = "rounding of the lengths does not tell whether they end at infinity";
  }
}

}  // namespace

bool has_precise_ends(const Scene& scene) {
  return !scene.problem().is_general() && !scene.has_lines() && !scene.is_anchored();
}

void continue_ends(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to,
                   std::vector<PathEnd>& ends, const std::stop_token& stop) {
  if (std::ranges::all_of(ends, [](const PathEnd& end) { return end.before.empty(); })) return;
  const PreciseEnds precise(scene, from, to);
  const bool is_explained = precise.are_exact() || (scene.dimension() == 3 && precise.may_escape());
  const auto is_open = [&](const PathEnd& end) {
    return !end.before.empty() &&
           (end.kind == PathEnd::Kind::failed || (end.kind == PathEnd::Kind::at_infinity && !is_explained));
  };
  if (!precise.are_few(std::ranges::count_if(ends, is_open))) {
    if (scene.dimension() == 3 && !is_explained) doubt(ends);
    return;
  }
  for (PathEnd& end : ends)
    if (is_open(end) && !stop.stop_requested()) precise.follow(end.before, power_of(end), stop, end);
}

bool determine_ends(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to,
                    const std::function<std::vector<ComplexVectorX>(const std::vector<std::size_t>&)>& before,
                    std::vector<PathEnd>& ends, const std::stop_token& stop) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (is_doubtful(scene, ends[i])) open.push_back(i);
  const PreciseEnds precise(scene, from, to);
  if (!precise.are_few(std::ssize(open))) return false;
  const std::vector<ComplexVectorX> starts = before(open);
  bool are_determined = !open.empty();
  for (std::size_t k = 0; k < open.size() && are_determined; ++k) {
    PathEnd& end = ends[open[k]];
    are_determined =
        !starts[k].empty() && precise.follow(starts[k], 1.0 / std::max(1, end.winding_number), stop, end);
  }
  return are_determined;
}

}  // namespace gcs
