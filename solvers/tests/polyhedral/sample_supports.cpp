#include "solvers/tests/polyhedral/sample_supports.hpp"

#include <algorithm>
#include <cstdlib>

namespace gcs::samples {
namespace {

Exponents product(int unknowns, const std::vector<int>& factors) {
  Exponents exponents(static_cast<std::size_t>(unknowns), 0);
  for (const int factor : factors) ++exponents[factor];
  return exponents;
}

void append_new(Support& support, const Exponents& point) {
  if (std::find(support.begin(), support.end(), point) == support.end()) support.push_back(point);
}

void append_up_to(int degree, Exponents& point, std::size_t v, Support& support) {
  if (v == point.size()) {
    support.push_back(point);
    return;
  }
  for (point[v] = 0; point[v] <= degree; ++point[v]) append_up_to(degree - point[v], point, v + 1, support);
}

}  // namespace

Supports cyclic_roots(int n) {
  Supports supports;
  for (int k = 1; k < n; ++k) {
    Support& support = supports.emplace_back();
    for (int i = 0; i < n; ++i) {
      std::vector<int> factors;
      for (int j = 0; j < k; ++j) factors.push_back((i + j) % n);
      support.push_back(product(n, factors));
    }
  }
  supports.push_back({Exponents(static_cast<std::size_t>(n), 1), product(n, {})});
  return supports;
}

Supports noon(int n) {
  Supports supports;
  for (int i = 0; i < n; ++i) {
    Support& support = supports.emplace_back(Support{product(n, {}), product(n, {i})});
    for (int j = 0; j < n; ++j)
      if (j != i) support.push_back(product(n, {i, j, j}));
  }
  return supports;
}

Supports katsura(int n) {
  Supports supports;
  for (int k = 0; k < n; ++k) {
    Support& support = supports.emplace_back(Support{product(n + 1, {k})});
    for (int l = k - n; l <= n; ++l) append_new(support, product(n + 1, {std::abs(l), std::abs(k - l)}));
  }
  Support& sum = supports.emplace_back(Support{product(n + 1, {})});
  for (int l = 0; l <= n; ++l) sum.push_back(product(n + 1, {l}));
  return supports;
}

Supports dense(const std::vector<int>& degrees) {
  Supports supports;
  for (const int degree : degrees) {
    Exponents point(degrees.size());
    append_up_to(degree, point, 0, supports.emplace_back());
  }
  return supports;
}

Supports random_supports(int n, int points, int low, int high, RandomNumbers& random) {
  Supports supports(static_cast<std::size_t>(n));
  for (Support& support : supports) {
    while (static_cast<int>(support.size()) < points) {
      Exponents point;
      for (int v = 0; v < n; ++v) point.push_back(low + random.index(high - low + 1));
      append_new(support, point);
    }
  }
  return supports;
}

}  // namespace gcs::samples
