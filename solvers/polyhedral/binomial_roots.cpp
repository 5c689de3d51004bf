#include "solvers/polyhedral/binomial_roots.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gcs {
namespace {

/// Solutions are enumerated, and elements multiplied by less than the volume stay within 64 bits.
constexpr double largest_volume = 1 << 30;

std::int64_t modulo(std::int64_t value, std::int64_t modulus) {
  const std::int64_t rest = value % modulus;
  return rest < 0 ? rest + modulus : rest;
}

/// a − factor·b modulo the volume, in a.
void subtract(std::vector<std::int64_t>& a, std::int64_t factor, const std::vector<std::int64_t>& b,
              std::int64_t volume) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] = modulo(a[v] - factor * b[v], volume);
}

bool is_multiple_of_identity(const IntegerMatrix& exponents, const IntegerMatrix& inverse,
                             std::int64_t volume) {
  const std::size_t n = exponents.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      std::int64_t sum = 0;
      for (std::size_t v = 0; v < n; ++v) {
        std::int64_t product = 0;
        if (__builtin_mul_overflow(exponents[i][v], inverse[v][j], &product) ||
            __builtin_add_overflow(sum, product, &sum))
          return false;
      }
      if (sum != (i == j ? volume : 0)) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<BinomialRoots> BinomialRoots::of(const IntegerMatrix& exponents) {
  const Eigen::Index n = static_cast<Eigen::Index>(exponents.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index v = 0; v < n; ++v) matrix(i, v) = static_cast<double>(exponents[i][v]);
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix);
  const double volume = std::round(std::abs(lu.determinant()));
  if (!(volume >= 1 && volume <= largest_volume)) return std::nullopt;
  const Eigen::MatrixXd inverse = lu.inverse();
  IntegerMatrix adjugate(exponents.size());
  for (Eigen::Index v = 0; v < n; ++v)
    for (Eigen::Index i = 0; i < n; ++i) adjugate[v].push_back(std::llround(volume * inverse(v, i)));
  if (!is_multiple_of_identity(exponents, adjugate, static_cast<std::int64_t>(volume))) return std::nullopt;
  return BinomialRoots(static_cast<std::int64_t>(volume), std::move(adjugate));
}

/// Generators in echelon form: a gcd of the entries at one coordinate after the other.
BinomialRoots::BinomialRoots(std::int64_t volume, IntegerMatrix adjugate)
    : volume_(volume), adjugate_(std::move(adjugate)) {
  const std::size_t n = adjugate_.size();
  std::vector<std::vector<std::int64_t>> open;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<std::int64_t>& element = open.emplace_back();
    for (std::size_t v = 0; v < n; ++v) element.push_back(modulo(adjugate_[v][j], volume_));
  }
  for (std::size_t v = 0; v < n; ++v) {
    std::vector<std::int64_t> pivot(n, 0);
    for (auto& element : open) {
      while (element[v] != 0) {
        subtract(pivot, pivot[v] / element[v], element, volume_);
        std::swap(pivot, element);
      }
    }
    if (pivot[v] == 0) continue;
    const std::int64_t order = volume_ / std::gcd(pivot[v], volume_);
    generators_.push_back({pivot, order});
    subtract(pivot, 1 - order, pivot, volume_);  // its multiple that vanishes at v
    open.push_back(std::move(pivot));
    std::erase_if(open, [](const auto& element) {
      return std::all_of(element.begin(), element.end(), [](std::int64_t entry) { return entry == 0; });
    });
  }
}

std::vector<double> BinomialRoots::angles(const std::vector<double>& turns, std::int64_t i) const {
  std::vector<std::int64_t> element(adjugate_.size(), 0);
  for (const Generator& generator : generators_) {
    subtract(element, -(i % generator.order), generator.element, volume_);
    i /= generator.order;
  }
  std::vector<double> angles;
  for (std::size_t v = 0; v < element.size(); ++v) {
    double sum = static_cast<double>(element[v]);
    for (std::size_t j = 0; j < turns.size(); ++j) sum += static_cast<double>(adjugate_[v][j]) * turns[j];
    sum /= static_cast<double>(volume_);
    angles.push_back(sum - std::floor(sum));
  }
  return angles;
}

}  // namespace gcs
