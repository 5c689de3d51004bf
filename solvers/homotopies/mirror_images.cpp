#include "solvers/homotopies/mirror_images.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/homotopies/endgame.hpp"

namespace gcs {
namespace {

/// What equal solutions may differ by beside their uncertainties, relative to 1 + the largest |x_i|:
/// rounding.
constexpr double equality = 1e-9;

/// An entry that is 0 may come out as this, likewise, where each is right to its own rounding.
constexpr double vanishing = 1e-60;

/// |z| ≤ most; the absolute value, which guards against overflow, is taken only where it decides.
bool is_within(std::complex<double> z, double most) {
  const double re = std::abs(z.real()), im = std::abs(z.imag());
  return re + im <= most || (std::max(re, im) <= most && std::abs(z) <= most);
}

}  // namespace

std::vector<int> divided_by_none(const std::vector<int>& axes) { return std::vector<int>(axes.size(), -1); }

int image_count(const std::vector<int>& axes) {
  int count = 1;
  for (int axis = 0; axis < 3; ++axis)
    if (std::find(axes.begin(), axes.end(), axis) != axes.end()) count *= 2;
  return count;
}

SolutionIndex::SolutionIndex(SignMasks signs, std::mt19937_64& random)
    : signs_(std::move(signs)), kind_(signs_.kind_numbers()), kinds_(signs_.kinds().size()) {
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < signs_.size(); ++i) weights_.push_back(normal(random));
}

/// Of the weighted sums over the unknowns of one mask the square is the same for all signs.
SolutionIndex::Key SolutionIndex::key_of(const ComplexVectorX& x, double uncertainty) const {
  std::vector<std::complex<double>> sums(kinds_);
  double size = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sums[kind_[i]] += weights_[i] * x[i];
    size += std::abs(weights_[i]) * (std::abs(x[i].real()) + std::abs(x[i].imag()));
  }
  Key key;
  key.value = sums[0].real() + sums[0].imag();
  for (std::size_t kind = 1; kind < kinds_; ++kind) {
    const std::complex<double> square = sums[kind] * sums[kind];
    key.value += static_cast<double>(kind) * (square.real() + square.imag());
  }
  // The derivative of the key is at most 4 (kinds − 1) size + 2 in each weighted unknown.
  const double slope = 4 * static_cast<double>(kinds_ - 1) * size + 2;
  key.window = (equality + uncertainty) * (1 + largest(x)) * static_cast<double>(x.size()) * slope;
  return key;
}

bool SolutionIndex::equal(const ComplexVectorX& x, const ComplexVectorX& y, const Accuracy& accuracy) const {
  const double most = 1 + std::max(largest(x), largest(y)), relative = equality + accuracy.uncertainty;
  const auto tolerance = [&](std::size_t i) {
    if (accuracy.size == RelativeTo::largest) return relative * most;
    return relative * std::max({std::abs(x[i]), std::abs(y[i]), vanishing * most});
  };
  return some_signs_fit(
      signs_, [&](std::size_t i, double sign) { return is_within(x[i] - sign * y[i], tolerance(i)); });
}

/// Both have to be known by each entry where that decides.
int SolutionIndex::find(const ComplexVectorX& x, double uncertainty, RelativeTo size,
                        const SolutionAt& at) const {
  // The index's own uncertainties are within the factor 2 of the window, or told apart by `equal`.
  const Key key = key_of(x, 2 * uncertainty);
  const auto end = by_key_.upper_bound(key.value + key.window);
  for (auto entry = by_key_.lower_bound(key.value - key.window); entry != end; ++entry) {
    const Accuracy& known = accuracies_[entry->second];
    const bool is_of_each = size == RelativeTo::each && known.size == RelativeTo::each;
    const Accuracy both{uncertainty + known.uncertainty, is_of_each ? RelativeTo::each : RelativeTo::largest};
    if (equal(x, at(entry->second), both)) return entry->second;
  }
  return -1;
}

void SolutionIndex::add(const ComplexVectorX& x, double uncertainty, RelativeTo size) {
  by_key_.emplace(key_of(x, uncertainty).value, this->size());
  accuracies_.push_back({uncertainty, size});
}

int SolutionSet::find(const ComplexVectorX& x, double uncertainty, RelativeTo size) const {
  return index_.find(x, uncertainty, size, [this](int i) -> const ComplexVectorX& { return solutions_[i]; });
}

int SolutionSet::insert(const ComplexVectorX& x, double uncertainty, RelativeTo size) {
  if (const int known = find(x, uncertainty, size); known >= 0) return known;
  index_.add(x, uncertainty, size);
  solutions_.push_back(x);
  return this->size() - 1;
}

std::vector<ComplexVectorX> one_of_each_class(const std::vector<ComplexVectorX>& solutions,
                                              const std::vector<int>& axes, std::mt19937_64& random) {
  SolutionSet classes(axes, random);
  for (const ComplexVectorX& x : solutions) classes.insert(x, regular_uncertainty);
  return classes.solutions();
}

}  // namespace gcs
