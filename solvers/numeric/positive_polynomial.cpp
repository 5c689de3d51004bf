#include "solvers/numeric/positive_polynomial.hpp"

#include <algorithm>
#include <utility>

namespace gcs {
namespace {

using Coefficients = std::vector<Rational>;

/// b_j = Σ_{i ≤ j} C(j, i)/C(n, i)·c_i on [0, 1].
Coefficients to_bernstein(Coefficients c) {
  const std::size_t n = c.size() - 1;
  Rational binomial(1);
  for (std::size_t i = 0; i <= n; ++i) {
    c[i] = c[i] / binomial;
    binomial = binomial * Rational(static_cast<long>(n - i)) / Rational(static_cast<long>(i + 1));
  }
  for (std::size_t level = 1; level <= n; ++level)
    for (std::size_t j = n; j >= level; --j) c[j] = c[j] + c[j - 1];
  return c;
}

/// de Casteljau at the middle: `b` becomes the left half, the right half is returned.
Coefficients halve(Coefficients& b) {
  Coefficients right(b.size());
  const std::size_t n = b.size() - 1;
  for (std::size_t level = 0; level <= n; ++level) {
    right[n - level] = b[n];
    for (std::size_t j = n; j > level; --j) b[j] = (b[j] + b[j - 1]).times_power_of_two(-1);
  }
  return right;
}

std::optional<double> not_positive_in(Coefficients b, double low, double width, int halvings) {
  if (b.front().sign() <= 0) return low;
  if (b.back().sign() <= 0) return low + width;
  if (std::ranges::all_of(b, [](const Rational& value) { return value.sign() > 0; })) return std::nullopt;
  if (halvings == 0) return low;
  Coefficients right = halve(b);
  if (const auto found = not_positive_in(std::move(b), low, width / 2, halvings - 1)) return found;
  return not_positive_in(std::move(right), low + width / 2, width / 2, halvings - 1);
}

}  // namespace

std::optional<double> where_not_positive(const std::vector<Rational>& c) {
  constexpr int halvings = 64;
  return not_positive_in(to_bernstein(c), 0, 1, halvings);
}

}  // namespace gcs
