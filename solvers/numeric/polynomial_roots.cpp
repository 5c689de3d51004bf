#include "solvers/numeric/polynomial_roots.hpp"

#include <cmath>
#include <utility>

namespace gcs {
namespace {

using Coefficients = std::vector<double>;

/// Bernstein coefficients on [0, end]: b_j = Σ_{i ≤ j} C(j, i)/C(n, i) · c_i·end^i.
Coefficients to_bernstein(std::span<const double> c, double end) {
  const std::size_t n = c.size() - 1;
  Coefficients b(c.begin(), c.end());
  double power = 1;
  double binomial = 1;
  for (std::size_t i = 0; i <= n; ++i) {
    b[i] *= power / binomial;
    power *= end;
    binomial *= static_cast<double>(n - i) / static_cast<double>(i + 1);
  }
  for (std::size_t level = 1; level <= n; ++level)
    for (std::size_t j = n; j >= level; --j) b[j] += b[j - 1];
  return b;
}

int sign_variations(const Coefficients& b) {
  int variations = 0;
  double last = 0;
  for (double value : b) {
    if (value == 0) continue;
    if (last * value < 0 || (last != 0 && std::signbit(last) != std::signbit(value))) ++variations;
    last = value;
  }
  return variations;
}

/// Where an interval is divided: the golden section, which the roots of no tidy polynomial fall on. A root on
/// a division point would be seen from both sides, or from none.
constexpr double division = 0.6180339887498949;

/// de Casteljau at the division point: `b` becomes the left part, the right part is returned.
Coefficients split(Coefficients& b) {
  Coefficients right(b.size());
  const std::size_t n = b.size() - 1;
  for (std::size_t level = 0; level <= n; ++level) {
    right[n - level] = b[n];
    for (std::size_t j = n; j > level; --j) b[j] = division * b[j] + (1 - division) * b[j - 1];
  }
  return right;
}

/// Bisection between ends of opposite sign.
double bisect(std::span<const double> c, double low, double high) {
  const bool low_negative = polynomial_value(c, low) < 0;
  for (int i = 0; i < 64; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    ((polynomial_value(c, middle) < 0) == low_negative ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

struct Search {
  std::span<const double> c;
  double resolution;
  std::vector<double> roots;

  /// Roots in (low, high].
  void descend(Coefficients b, double low, double high) {
    const bool root_at_end = b.back() == 0;
    descend_open(std::move(b), low, high);
    if (root_at_end) add(high);
  }

 private:
  /// Roots in (low, high).
  void descend_open(Coefficients b, double low, double high) {
    const int variations = sign_variations(b);
    if (variations == 0) return;
    if (variations == 1 && b.front() != 0 && b.back() != 0) {
      add(bisect(c, low, high));
    } else if (high - low <= resolution) {
      add(low + (high - low) / 2);
    } else {
      Coefficients right = split(b);
      const double middle = low + division * (high - low);
      descend(std::move(b), low, middle);
      descend_open(std::move(right), middle, high);
    }
  }

  /// A multiple root may be seen in two neighbouring intervals.
  void add(double root) {
    if (roots.empty() || root - roots.back() > 4 * resolution) roots.push_back(root);
  }
};

}  // namespace

std::vector<double> real_roots(std::span<const double> c, double end) {
  double reach = 0;
  double power = 1;
  for (std::size_t i = 1; i < c.size(); ++i) reach += std::abs(c[i]) * (power *= end);
  if (std::abs(c[0]) > reach) return {};
  Search search{c, 1e-12 * end, {}};
  Coefficients b = to_bernstein(c, end);
  b.back() = polynomial_value(c, end);
  search.descend(std::move(b), 0, end);
  return search.roots;
}

double polynomial_value(std::span<const double> c, double s) {
  double value = 0;
  for (std::size_t i = c.size(); i-- > 0;) value = value * s + c[i];
  return value;
}

std::vector<double> derivative(std::span<const double> c) {
  std::vector<double> result;
  for (std::size_t i = 1; i < c.size(); ++i) result.push_back(static_cast<double>(i) * c[i]);
  return result;
}

bool may_vanish(std::span<const double> c, double end, double slack) {
  double rest = slack, power = end;
  for (std::size_t i = 1; i < c.size(); ++i, power *= end) rest += std::abs(c[i]) * power;
  return std::abs(c[0]) <= rest;
}

}  // namespace gcs
