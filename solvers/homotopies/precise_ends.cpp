#include "solvers/homotopies/precise_ends.hpp"

#include <algorithm>
#include <atomic>
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
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

constexpr double last_sigma = 1e-80;
/// Unknowns³ of all ends together: seconds.
constexpr double most_work = 5e4;

/// Of σ: there doubles hold most paths whose ends they do not hold.
constexpr double beside_the_end = 1e-6;
/// Of a general scene's paths: an end takes as long as some hundred of them, whatever their number.
constexpr double most_of_paths = 0.05;

constexpr double sigma_bits = 266;  // of last_sigma

/// Coordinates like σ^(−p) are squared, and the condition number grows as fast: four times their bits, beside those of σ
/// itself and a margin.
slong bits_for(double power) { return static_cast<slong>(512 + 4 * power * sigma_bits); }

/// A point of a path.
struct Station {
  double log_sigma = 0;
  BallMatrix x;
};

/// A path like τ^(−order) times a power series in τ = σ^(1/winding).
struct Pole {
  int winding = 1;
  int order = 1;
};

/// Follows one path by the equations f(x) − A − σ·way of a scene of distances.
class PreciseEnd {
 public:
  PreciseEnd(const QuadraticSystem& system, slong bits, const ComplexVectorX& way)
      : system_(system), way_(BallKrawczyk::vector(way)) {
    for (slong fewer = fewest_bits; 4 * fewer < 3 * bits; fewer += fewer / 2)
      equations_.emplace_back(system, fewer);
    equations_.emplace_back(system, bits);
  }

  /// The end, from x at a σ next to it; one that failed where Newton's method does not get there.
  PathEnd run(const ComplexVectorX& start, double sigma, const std::stop_token& stop) {
    BallMatrix x = BallKrawczyk::vector(start);
    if (!missed(sigma, 0.1, near_path, x)) return {};
    std::deque<Station> stations{{std::log(sigma), x}};
    double step = 1e-3, next_test = 0;
    while (stations.back().log_sigma > std::log(last_sigma)) {
      const std::optional<Pole> pole = pole_between(stations.back(), stations.front());
      if (!pole && stations.back().log_sigma < next_test) {
        const auto [zero, alpha] = settled(stations.back());
        if (alpha < most_alpha) return end_next_to(zero);
        next_test = stations.back().log_sigma - way_to_test(alpha);
      }
      choose_precision(stations.back());
      Station next =
          extrapolated(stations, std::max(stations.back().log_sigma - step, std::log(last_sigma)), pole);
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
  static constexpr std::size_t most_stations = 14;
  /// Beside edges: a path that is a tenth of its edges away is taken for this one now and then.
  static constexpr double most_missed = 1e-3;
  /// To it stations are on the path: far below most_missed, so that a polynomial through them tells.
  static constexpr double near_path = 1e-14;
  static constexpr double shortest_step = 1e-8;
  static constexpr double most_alpha = 0.157;
  static constexpr slong fewest_bits = 192;

  const BallKrawczyk& equations() const { return equations_[level_]; }
  slong bits() const { return equations().bits(); }

  /// What bits_for asks for at the last σ, at this one, and at least for coordinates of this size.
  void choose_precision(const Station& station) {
    const double share = station.log_sigma / std::log(last_sigma);
    const double needed = fewest_bits / 2.0 + std::max(share * static_cast<double>(equations_.back().bits()),
                                                       4 * std::log2(largest(rounded(station.x))));
    while (level_ + 1 < equations_.size() && static_cast<double>(bits()) < needed) ++level_;
  }

  /// A polynomial through n stations misses by the n-th power of the step; next to singular points Newton's method bears much
  /// less than the aim, and the step goes up and down.
  static double change_of_step(const std::optional<double>& off, std::size_t stations) {
    constexpr double least = 0.6, aim = 0.1 * most_missed;
    const double most = stations < most_stations ? 1.5 : 1.2;
    if (!off) return least;
    return std::min(most, std::pow(aim / *off, 1.0 / static_cast<double>(stations)));
  }

  /// By Lagrange's polynomial through all stations: of x in log σ, or of τ^order·x in τ. The weights have the bits of x: those
  /// of a pole are far from 1.
  Station extrapolated(const std::deque<Station>& stations, double log_sigma,
                       const std::optional<Pole>& pole) const {
    Station result{log_sigma, BallMatrix(way_.rows(), 1)};
    const auto count = static_cast<slong>(stations.size());
    BallMatrix places(count, 1);  // from 0, or as multiples of 1
    for (slong j = 0; j < count; ++j) {
      acb_set_d(places(j, 0), stations[static_cast<std::size_t>(j)].log_sigma - log_sigma);
      if (!pole) continue;
      acb_div_si(places(j, 0), places(j, 0), pole->winding, bits());
      acb_exp(places(j, 0), places(j, 0), bits());
    }
    Ball weight, part;
    for (slong j = 0; j < count; ++j) {
      acb_pow_ui(weight, places(j, 0), pole ? static_cast<ulong>(pole->order) : 0, bits());
      for (slong k = 0; k < count; ++k) {
        if (k == j) continue;
        acb_sub_si(part, places(k, 0), pole ? 1 : 0, bits());
        acb_mul(weight, weight, part, bits());
        acb_sub(part, places(k, 0), places(j, 0), bits());
        acb_div(weight, weight, part, bits());
      }
      for (slong i = 0; i < way_.rows(); ++i)
        acb_addmul(result.x(i, 0), weight, stations[static_cast<std::size_t>(j)].x(i, 0), bits());
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
      const double length = beside_factors(correction, x);
      if (!(length <= allowed)) return std::nullopt;
      if (!first) first = length;
      acb_mat_sub(x.get(), x.get(), correction.get(), bits());
      acb_mat_get_mid(x.get(), x.get());
      if (length <= last) return first;
      allowed = contraction * length;
    }
    return std::nullopt;
  }

  /// The largest |l(x)| and |r(x)| of an equation's products l·r.
  struct Factors {
    double left = 0;
    double right = 0;
  };

  /// Where all are 0, what rounding makes of that.
  Factors factors(const QuadraticEquation& equation, const BallMatrix& x) const {
    const double zero = std::ldexp(largest(rounded(x)), static_cast<int>(-bits() / 3));
    Factors most{zero, zero};
    for (const FormProduct& product : equation.products) {
      most.left = std::max(most.left, size(product.left, x) + magnitude_of(product.left.constant));
      most.right = std::max(most.right, size(product.right, x) + magnitude_of(product.right.constant));
    }
    return most;
  }

  static double magnitude_of(const ExactNumber& number) { return std::abs(rounded_to_double(number)); }

  /// |form(x)|, without its constant.
  double size(const LinearForm& form, const BallMatrix& x) const {
    const BallMatrix value = along(form, x, 1);
    return magnitude(value(0, 0));
  }

  /// A form without its constant, of each column. Its coefficients are as good as doubles are, which of edges is exactly.
  BallMatrix along(const LinearForm& form, const BallMatrix& columns, slong count) const {
    BallMatrix sum(1, count);
    Ball coefficient;
    for (const ScaledUnknown& term : form.terms) {
      const std::complex<double> factor = rounded_to_double(term.coefficient);
      acb_set_d_d(coefficient, factor.real(), factor.imag());
      for (slong c = 0; c < count; ++c) acb_addmul(sum(0, c), coefficient, columns(term.unknown, c), bits());
    }
    return sum;
  }

  double beside_factors(const BallMatrix& correction, const BallMatrix& x) const {
    double largest = 0;
    for (const QuadraticEquation& equation : system_.equations) {
      const Factors of = factors(equation, x);
      for (const FormProduct& product : equation.products)
        largest = std::max({largest, beside(size(product.left, correction), of.left),
                            beside(size(product.right, correction), of.right)});
    }
    return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
  }

  static double beside(double change, double size) { return change == 0 ? 0 : change / size; }

  /// A point of the path to a fourth of the bits, as next to curves along which equations hardly change γ is 1e18 and more,
  /// and its α at σ = 0, or β where that is more.
  struct Settled {
    BallMatrix x;
    double alpha = std::numeric_limits<double>::infinity();
  };

  Settled settled(const Station& station) const {
    Settled point{station.x};
    if (missed(std::exp(station.log_sigma), most_missed, fourth_of_bits(), point.x))
      point.alpha = alpha(point.x);
    return point;
  }

  double fourth_of_bits() const { return std::ldexp(1.0, static_cast<int>(-bits() / 4)); }

  double alpha(const BallMatrix& x) const {
    const BallMatrix jacobian = equations().jacobian(x);
    BallMatrix inverse(x.rows(), x.rows());
    if (!acb_mat_approx_inv(inverse.get(), jacobian.get(), bits()))
      return std::numeric_limits<double>::infinity();
    BallMatrix correction(x.rows(), 1);
    acb_mat_approx_mul(correction.get(), inverse.get(), residual(x, 0).get(), bits());
    return beside_factors(correction, x) * std::max(1.0, gamma(inverse, x));
  }

  /// In log σ, beside which β goes down like σ at an end that is simple, and γ may go down too.
  static double way_to_test(double alpha) {
    constexpr double least = 0.5;
    return std::isfinite(alpha) ? std::max(least, std::log(alpha / most_alpha) / 2) : least;
  }

  /// |D²f_e(h, h)| is at most 2·(its products)·(its factors) for |h| ≤ 1.
  double gamma(const BallMatrix& inverse, const BallMatrix& x) const {
    std::vector<Factors> of;
    std::vector<double> bends;
    for (const QuadraticEquation& equation : system_.equations) {
      of.push_back(factors(equation, x));
      bends.push_back(2 * static_cast<double>(equation.products.size()) * of.back().left * of.back().right);
    }
    const auto bend = [&](const LinearForm& form) {
      const BallMatrix row = along(form, inverse, inverse.columns());
      double sum = 0;
      for (std::size_t e = 0; e < bends.size(); ++e)
        sum += magnitude(row(0, static_cast<slong>(e))) * bends[e];
      return sum;
    };
    double largest = 0;
    for (std::size_t i = 0; i < of.size(); ++i)
      for (const FormProduct& product : system_.equations[i].products)
        largest = std::max({largest, beside(bend(product.left), of[i].left) / 2,
                            beside(bend(product.right), of[i].right) / 2});
    return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
  }

  static ComplexVectorX rounded(const BallMatrix& x) {
    ComplexVectorX result;
    for (slong i = 0; i < x.rows(); ++i) result.push_back(rounded_midpoint(x(i, 0)));
    return result;
  }

  PathEnd end_next_to(BallMatrix x) {
    level_ = equations_.size() - 1;
    if (!missed(0, 0.1, fourth_of_bits(), x)) return {};
    return {PathEnd::Kind::regular, rounded(x), 1, 0, true, "", {}, true};
  }

  /// Where x grows like a power of 1/σ, k/w with a small w.
  static std::optional<Pole> pole_between(const Station& last, const Station& before) {
    constexpr double close = 0.02;
    constexpr int most_winding = 8;
    const double power =
        std::log(largest(rounded(last.x)) / largest(rounded(before.x))) / (before.log_sigma - last.log_sigma);
    for (int w = 1; w <= most_winding; ++w) {
      const double order = std::round(w * power);
      if (order >= 1 && std::abs(w * power - order) <= close) return Pole{w, static_cast<int>(order)};
    }
    return std::nullopt;
  }

  /// Where it is a pole; else the end is a multiple one, or none.
  static PathEnd end_at_infinity(const Station& last, const Station& before) {
    constexpr double beyond_doubles = 1e14;
    const std::optional<Pole> pole = pole_between(last, before);
    if (!pole || largest(rounded(last.x)) < beyond_doubles) return {};
    return {PathEnd::Kind::at_infinity, rounded(last.x), pole->winding, pole->order, true, "", {}, true};
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

/// All of some equations, while their right-hand sides go straight from some to others.
class PreciseEnds {
 public:
  /// `way`: the first ones minus the last.
  PreciseEnds(QuadraticSystem system, ComplexVectorX way)
      : system_(std::move(system)), way_(std::move(way)) {}

  const QuadraticSystem& system() const { return system_; }
  double work(std::ptrdiff_t ends) const { return static_cast<double>(ends) * std::pow(system_.unknowns, 3); }

  /// From x at σ. `power`: it may run away so fast, in 1/σ.
  PathEnd end_of(const ComplexVectorX& x, double sigma, double power, const std::stop_token& stop) const {
    return PreciseEnd(system_, bits_for(power), way_).run(x, sigma, stop);
  }

 private:
  QuadraticSystem system_;
  ComplexVectorX way_;
};

ComplexVectorX difference(const ComplexVectorX& a, const ComplexVectorX& b) {
  ComplexVectorX result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] -= b[i];
  return result;
}

/// Of a scene, on their way between two lists of squared lengths.
class DistanceEnds {
 public:
  DistanceEnds(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to)
      : scene_(scene), to_(to), precise_(SceneEquations(scene).system(), difference(from, to)) {}

  /// Whether the squared lengths in doubles are the file's.
  bool are_exact() const { return !are_rounded(BallKrawczyk(precise_.system(), bits_for(1)), to_); }
  /// Whether points may be at infinity: in space where the file's lengths let them escape.
  bool may_escape() const { return scene_.dimension() == 2 || !closed_walks(scene_).empty(); }
  bool are_few(std::ptrdiff_t ends) const { return precise_.work(ends) <= most_work; }

  /// Whether the path has an end, which replaces `end`. `power`: it may run away so fast, in 1/σ.
  bool follow(const ComplexVectorX& before, double power, const std::stop_token& stop, PathEnd& end) const {
    PathEnd precise = precise_.end_of(before, first_radius, power, stop);
    const bool is_end = precise.kind == PathEnd::Kind::regular ||
                        (precise.kind == PathEnd::Kind::at_infinity && may_escape());
    if (is_end) end = std::move(precise);
    return is_end;
  }

 private:
  const Scene& scene_;
  const ComplexVectorX& to_;
  PreciseEnds precise_;
};

bool is_doubtful(const Scene& scene, const PathEnd& end) {
  if (end.is_precise) return false;
  if (end.kind == PathEnd::Kind::regular)
    return is_stiff(scene, complex_figure(DistanceSystem(scene), Eigen::Map<const Eigen::VectorXcd>(
                                                                     end.x.data(), std::ssize(end.x))));
  return end.kind == PathEnd::Kind::singular;
}

void doubt(PathEnd& end) {
  if (end.kind != PathEnd::Kind::at_infinity) return;
  end.kind = PathEnd::Kind::failed;
  end.cause = "rounding of the lengths does not tell whether they end at infinity";
}

}  // namespace

bool has_precise_ends(const Scene& scene) {
  return !scene.problem().is_general() && !scene.has_lines() && !scene.is_anchored();
}

void continue_ends(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to, int threads,
                   std::vector<PathEnd>& ends, const std::stop_token& stop) {
  if (std::ranges::all_of(ends, [](const PathEnd& end) { return end.before.empty(); })) return;
  const DistanceEnds precise(scene, from, to);
  const bool is_explained = precise.are_exact() || (scene.dimension() == 3 && precise.may_escape());
  const auto is_open = [&](const PathEnd& end) {
    return !end.before.empty() &&
           (end.kind == PathEnd::Kind::failed || (end.kind == PathEnd::Kind::at_infinity && !is_explained));
  };
  std::vector<PathEnd*> open;
  for (PathEnd& end : ends)
    if (is_open(end)) open.push_back(&end);
  if (!precise.are_few(std::ssize(open))) {
    if (scene.dimension() == 3 && !is_explained) std::ranges::for_each(ends, doubt);
    return;
  }
  share_on_threads(open.size(), threads, [&](std::size_t k) {
    PathEnd& end = *open[k];
    if (!stop.stop_requested()) precise.follow(end.before, power_of(end), stop, end);
  });
}

bool determine_ends(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to,
                    const EndsBefore& before, int threads, std::vector<PathEnd>& ends,
                    const std::stop_token& stop) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (is_doubtful(scene, ends[i])) open.push_back(i);
  const DistanceEnds precise(scene, from, to);
  if (!precise.are_few(std::ssize(open))) return false;
  const std::vector<ComplexVectorX> starts = before(open, first_radius);
  // Whatever the threads, all before the first one that has no end are followed, and replaced.
  std::atomic<std::size_t> first_without = open.size();
  std::vector<PathEnd> found(open.size());
  share_on_threads(open.size(), threads, [&](std::size_t k) {
    if (k > first_without) return;
    found[k] = ends[open[k]];
    const double power = 1.0 / std::max(1, found[k].winding_number);
    if (!starts[k].empty() && precise.follow(starts[k], power, stop, found[k])) return;
    for (std::size_t known = first_without; k < known && !first_without.compare_exchange_weak(known, k);) {
    }
  });
  for (std::size_t k = 0; k < first_without; ++k) ends[open[k]] = std::move(found[k]);
  return !open.empty() && first_without == open.size();
}

bool determine_ends(const GeneralEquations& given, const ComplexVectorX& from,
                    const std::function<bool(const PathEnd&)>& is_open, const EndsBefore& before, int threads,
                    std::vector<PathEnd>& ends, const std::stop_token& stop) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (!ends[i].is_precise && is_open(ends[i])) open.push_back(i);
  if (open.empty()) return false;
  ComplexVectorX way;
  for (const int j : given.value_monomial) way.push_back(j < 0 ? 0 : given.coefficients[j] - from[j]);
  const PreciseEnds precise(given.exact, std::move(way));
  const bool are_few = precise.work(std::ssize(open)) <= most_work ||
                       static_cast<double>(open.size()) <= most_of_paths * static_cast<double>(ends.size());
  if (!are_few) return false;
  for (const double sigma : {beside_the_end, first_radius, 1.0}) {
    const std::vector<ComplexVectorX> starts = before(open, sigma);
    std::vector<PathEnd> found(open.size());
    share_on_threads(open.size(), threads, [&](std::size_t k) {
      if (!starts[k].empty() && !stop.stop_requested())
        found[k] = precise.end_of(starts[k], sigma, power_of(ends[open[k]]), stop);
    });
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (found[k].kind == PathEnd::Kind::failed)
        left.push_back(open[k]);
      else
        ends[open[k]] = std::move(found[k]);
    }
    open = std::move(left);
  }
  for (const std::size_t i : open) doubt(ends[i]);
  return true;
}

}  // namespace gcs
