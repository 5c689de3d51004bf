#include "solvers/model/interpolation.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/numeric/polynomial_roots.hpp"

namespace gcs {
namespace {

/// The coefficients of Σ c[i]·(t + τ)^i in powers of τ, by repeated synthetic division.
std::vector<double> shifted(std::vector<double> c, double t) {
  for (std::size_t level = 0; level + 1 < c.size(); ++level)
    for (std::size_t i = c.size() - 1; i-- > level;) c[i] += t * c[i + 1];
  return c;
}

/// at·c_k + slope·c_{k−1} + curve·c_{k−2}: a product with a quadratic.
std::vector<double> times_quadratic(const std::vector<double>& c, double at, double slope, double curve) {
  std::vector<double> product(c.size() + 2, 0);
  for (std::size_t k = 0; k < c.size(); ++k) {
    product[k] += at * c[k];
    product[k + 1] += slope * c[k];
    product[k + 2] += curve * c[k];
  }
  return product;
}

/// The lengths of a sketch are right to a few roundings: a smaller difference is none.
bool is_constant(const LengthPath& path) {
  constexpr double few_roundings = 64 * std::numeric_limits<double>::epsilon();
  return path.higher.empty() && path.bend == 0 &&
         std::abs(path.at_target - path.at_sketch) <= few_roundings * (path.at_target + path.at_sketch);
}

/// In powers of t, without leading zeros: at least two unless it is constant.
std::vector<double> powers_of_t(const LengthPath& path) {
  if (is_constant(path)) return {path.at_sketch};
  std::vector<double> powers = path.expansion(0);
  while (powers.back() == 0) powers.pop_back();
  return powers;
}

/// The least t > `from` ≥ 0 at which the polynomial changes its sign; infinite: none.
double first_root(const std::vector<double>& powers, double from) {
  std::vector<double> reversed(powers.rbegin(), powers.rend());  // of 1/t
  double first = std::numeric_limits<double>::infinity();
  for (const double root : real_roots(powers, 1))
    if (root > from) first = std::min(first, root);
  if (std::isfinite(first)) return first;
  const std::vector<double> beyond = real_roots(reversed, 1);
  return beyond.empty() || beyond.back() <= 0 ? first : 1 / beyond.back();
}

std::vector<double> mirrored(std::vector<double> powers) {
  for (std::size_t i = 1; i < powers.size(); i += 2) powers[i] = -powers[i];
  return powers;
}

/// Fujiwara's bound on the sizes of all complex roots.
double root_bound(const std::vector<double>& powers) {
  double bound = 0;
  const std::size_t n = powers.size() - 1;
  for (std::size_t k = 1; k <= n; ++k)
    bound = std::max(bound, std::pow(std::abs(powers[n - k] / powers[n]), 1 / static_cast<double>(k)));
  return 2 * bound;
}

}  // namespace

DoubleDouble LengthPath::wide_value(double t) const {
  const DoubleDouble at{t}, left = two_sum(1.0, -t);
  DoubleDouble bends;
  for (std::size_t i = higher.size(); i-- > 0;) bends = (bends + DoubleDouble{higher[i]}) * at;
  bends = (bends + DoubleDouble{bend}) * at * left;
  return left * DoubleDouble{at_sketch} + at * DoubleDouble{at_target} + bends;
}

double LengthPath::higher_value(double t) const { return t * t * (1 - t) * polynomial_value(higher, t); }

double LengthPath::higher_slope(double t) const {
  double at = 0, rise = 0;
  for (std::size_t i = higher.size(); i-- > 0;) {
    rise = rise * t + at;
    at = at * t + higher[i];
  }
  return t * (2 - 3 * t) * at + t * t * (1 - t) * rise;
}

std::vector<double> LengthPath::expansion(double t) const {
  std::vector<double> bends{bend};
  bends.insert(bends.end(), higher.begin(), higher.end());
  std::vector<double> result = times_quadratic(shifted(std::move(bends), t), t * (1 - t), 1 - 2 * t, -1);
  result[0] = value(t);
  result[1] = slope(t);
  return result;
}

std::vector<double> LengthPath::expansion_sizes(double t) const {
  const double size = std::abs(t);
  std::vector<double> bends{std::abs(bend)};
  for (const double c : higher) bends.push_back(std::abs(c));
  std::vector<double> result =
      times_quadratic(shifted(std::move(bends), size), size * (1 + size), 1 + 2 * size, 1);
  result[0] += (1 + size) * std::abs(at_sketch) + size * std::abs(at_target);
  result[1] += std::abs(at_sketch) + std::abs(at_target);
  return result;
}

TimeRange positive_support(const std::vector<LengthPath>& lengths) {
  TimeRange range;
  for (const LengthPath& path : lengths) {
    const std::vector<double> powers = powers_of_t(path);
    if (powers.size() < 2) continue;
    range.high = std::min(range.high, first_root(powers, 1));
    range.low = std::max(range.low, -first_root(mirrored(powers), 0));
  }
  return range;
}

TimeRange times_far_away(const std::vector<LengthPath>& lengths) {
  constexpr double far = 1000;
  const TimeRange support = positive_support(lengths);
  double largest = 1;
  for (const LengthPath& path : lengths)
    if (const std::vector<double> powers = powers_of_t(path); powers.size() > 1)
      largest = std::max(largest, root_bound(powers));
  TimeRange range;
  if (!std::isfinite(support.low)) range.low = -far * largest;
  if (!std::isfinite(support.high)) range.high = far * largest;
  return range;
}

}  // namespace gcs
