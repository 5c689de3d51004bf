#include "solvers/numeric/polynomial_roots.hpp"

#include <cmath>

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

/// de Casteljau at the middle: `b` becomes the left half, the right half is returned.
Coefficients split(Coefficients& b) {
  Coefficients right(b.size());
  const std::size_t n = b.size() - 1;
  for (std::size_t level = 0; level <= n; ++level) {
    right[n - level] = b[n];
    for (std::size_t j = n; j > level; --j) b[j] = (b[j] + b[j - 1]) / 2;
  }
  return right;
}

double evaluate(std::span<const double> c, double s) {
  double value = 0;
  for (std::size_t i = c.size(); i-- > 0;) value = value * s + c[i];
  return value;
}

/// Bisection between ends of opposite sign.
double bisect(std::span<const double> c, double low, double high) {
  const bool low_negative = evaluate(c, low) < 0;
  for (int i = 0; i < 64; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    ((evaluate(c, middle) < 0) == low_negative ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

struct Search {
  std::span<const double> c;
  double resolution;
  std::vector<double> roots;

  void descend(Coefficients b, double low, double high) {
    const int variations = sign_variations(b);
    if (b.back() == 0) {
      descend_open(b, variations, low, high);
      roots.push_back(high);
    } else {
      descend_open(b, variations, low, high);
    }
  }

 private:
  void descend_open(Coefficients& b, int variations, double low, double high) {
    if (variations == 0) return;
    if (variations == 1 && b.front() != 0 && b.back() != 0) {
      roots.push_back(bisect(c, low, high));
    } else if (high - low <= resolution) {
      roots.push_back(low + (high - low) / 2);
    } else {
      const Coefficients right = split(b);
      const double middle = low + (high - low) / 2;
      descend(b, low, middle);
      descend(right, middle, high);
    }
  }
};

}  // namespace

std::vector<double> real_roots(std::span<const double> c, double end) {
  double reach = 0;
  double power = 1;
  for (std::size_t i = 1; i < c.size(); ++i) reach += std::abs(c[i]) * (power *= end);
  if (std::abs(c[0]) > reach) return {};
  Search search{c, 1e-12 * end, {}};
  search.descend(to_bernstein(c, end), 0, end);
  return search.roots;
}

}  // namespace gcs
