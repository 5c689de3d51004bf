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

namespace gcs {
namespace {

constexpr double last_sigma = 1e-60;
/// Unknowns³ of all ends together: seconds.
constexpr double most_work = 5e4;

/// Coordinates like σ^(−p) are squared, and the condition number grows as fast: four times their bits, beside those of σ
/// itself and a margin.
slong bits_for(double power) {
  constexpr double sigma_bits = 200;  // of last_sigma
  return static_cast<slong>(512 + 4 * power * sigma_bits);
}

/// A point of a path.
struct Station {
  double log_sigma = 0;
  BallMatrix x;
};

/// Follows one path by the equations f(x) − A − σ·way of a scene of distances.
class PreciseEnd {
 public:
  PreciseEnd(const QuadraticSystem& system, slong bits, const ComplexVectorX& way)
      : system_(system), equations_(system, bits), bits_(bits), way_(BallKrawczyk::vector(way)) {}

  /// The finite end, from x at the beginning of the endgame; nothing where there is none, or where Newton's method does not get there.
  std::optional<ComplexVectorX> run(const ComplexVectorX& start) const {
    constexpr double shortest_step = 1e-4;
    constexpr std::size_t most_stations = 12;
    BallMatrix x = BallKrawczyk::vector(start);
    if (!settle(first_radius, x)) return std::nullopt;
    std::deque<Station> stations{{std::log(first_radius), x}};
    double step = 0.1;
    while (stations.back().log_sigma > std::log(last_sigma) && step > shortest_step) {
      if (is_approximate_zero(stations.back().x)) return end_next_to(stations.back().x);
      Station next = extrapolated(stations, stations.back().log_sigma - step);
      if (!settle(std::exp(next.log_sigma), next.x)) {
        step /= 2;
        continue;
      }
      stations.push_back(std::move(next));
      if (stations.size() > most_stations) stations.pop_front();
      step *= 1.25;
    }
    return std::nullopt;
  }

 private:
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
      for (slong i = 0; i < way_.rows(); ++i) acb_addmul(result.x(i, 0), factor, station.x(i, 0), bits_);
    }
    acb_mat_get_mid(result.x.get(), result.x.get());
    return result;
  }

  BallMatrix residual(const BallMatrix& x, double sigma) const {
    BallMatrix value = equations_.value(x);
    Ball factor;
    acb_set_d(factor, -sigma);
    for (slong e = 0; e < value.rows(); ++e) acb_addmul(value(e, 0), factor, way_(e, 0), bits_);
    return value;
  }

  /// Newton's method, where each correction is far below the last and the first is small beside every edge.
  bool settle(double sigma, BallMatrix& x) const {
    constexpr int most_steps = 20;
    constexpr double first = 0.1, contraction = 0.25;
    const double settled = std::ldexp(1.0, static_cast<int>(-bits_ / 4));
    BallMatrix correction(x.rows(), 1);
    double allowed = first;
    for (int step = 0; step < most_steps; ++step) {
      if (!acb_mat_approx_solve(correction.get(), equations_.jacobian(x).get(), residual(x, sigma).get(),
                                bits_))
        return false;
      const double length = beside_edges(correction, x);
      if (!(length <= allowed)) return false;
      acb_mat_sub(x.get(), x.get(), correction.get(), bits_);
      acb_mat_get_mid(x.get(), x.get());
      if (length <= settled) return true;
      allowed = contraction * length;
    }
    return false;
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
        acb_addmul_si(sum(0, c), columns(unknown, c), coefficient.value.real() < 0 ? -1 : 1, bits_);
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
    const BallMatrix jacobian = equations_.jacobian(x);
    BallMatrix inverse(x.rows(), x.rows()), correction(x.rows(), 1);
    if (!acb_mat_approx_solve(correction.get(), jacobian.get(), residual(x, 0).get(), bits_)) return false;
    const double beta = beside_edges(correction, x);
    return beta < most_alpha && acb_mat_approx_inv(inverse.get(), jacobian.get(), bits_) != 0 &&
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

  std::optional<ComplexVectorX> end_next_to(BallMatrix x) const {
    if (!settle(0, x)) return std::nullopt;
    ComplexVectorX end;
    for (slong i = 0; i < x.rows(); ++i) end.push_back(rounded_midpoint(x(i, 0)));
    return end;
  }

  const QuadraticSystem& system_;
  BallKrawczyk equations_;
  slong bits_;
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
  const QuadraticSystem system = SceneEquations(scene).system();
  const bool in_space = scene.dimension() == 3;
  const bool is_explained =
      !are_rounded(BallKrawczyk(system, bits_for(1)), to) || (in_space && !closed_walks(scene).empty());
  const auto is_open = [&](const PathEnd& end) {
    return !end.before.empty() &&
           (end.kind == PathEnd::Kind::failed || (end.kind == PathEnd::Kind::at_infinity && !is_explained));
  };
  const auto open = static_cast<double>(std::ranges::count_if(ends, is_open));
  if (open * std::pow(system.unknowns, 3) > most_work) {
    if (in_space && !is_explained) doubt(ends);
    return;
  }
  ComplexVectorX way;
  for (std::size_t e = 0; e < to.size(); ++e) way.push_back(from[e] - to[e]);
  for (PathEnd& end : ends) {
    if (!is_open(end) || stop.stop_requested()) continue;
    const auto finite = PreciseEnd(system, bits_for(power_of(end)), way).run(end.before);
    if (finite) end = {PathEnd::Kind::regular, *finite, 1, 0, true, "", {}, true};
  }
}

}  // namespace gcs
