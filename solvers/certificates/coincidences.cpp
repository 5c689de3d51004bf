#include "solvers/certificates/coincidences.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "solvers/numeric/interval.hpp"

namespace gcs {
namespace {

constexpr double margin = 1 + 8 * std::numeric_limits<double>::epsilon();

/// A function of the solution that no reflection changes: the squares of weighted sums over the unknowns that
/// change sign together, and the weighted sum of the others. It tells nearly all different solutions apart.
class Invariant {
 public:
  explicit Invariant(const SignMasks& mirror) : kind_(mirror.kind_numbers()), kinds_(mirror.kinds().size()) {}

  Interval of(const Enclosure& solution) const {
    std::vector<Sum> sums(kinds_);
    for (std::size_t i = 0; i < kind_.size(); ++i) sums[kind_[i]].add(weight(i), solution, i);
    double mid = sums[0].mid.real(), radius = sums[0].radius();
    for (std::size_t kind = 1; kind < kinds_; ++kind) {
      const Sum& sum = sums[kind];
      const double size = std::abs(sum.mid), spread = sum.radius();
      mid += (sum.mid * sum.mid).real();
      radius += (spread * (2 * size + spread) + rounding(sums.size()) * size * size) * margin;
    }
    return {mid - radius * margin, mid + radius * margin};
  }

 private:
  struct Sum {
    std::complex<double> mid = 0;
    double spread = 0;
    double terms = 0;  ///< Σ |weight·mid|

    void add(double weight, const Enclosure& solution, std::size_t i) {
      mid += weight * solution.mid[i];
      terms += weight * std::abs(solution.mid[i]);
      spread += weight * std::abs(solution.radius[i]);
      ++count;
    }
    double radius() const { return (spread + rounding(count) * terms) * margin * (1 + rounding(count)); }
    std::size_t count = 0;
  };

  /// Of a sum of that many terms, relative to their sizes.
  static double rounding(std::size_t count) {
    return 2 * static_cast<double>(count + 4) * std::numeric_limits<double>::epsilon();
  }
  /// Multiples of the golden ratio, modulo 1: nothing that lengths are likely to be in step with.
  static double weight(std::size_t i) {
    return 1 + std::fmod(0.6180339887498949 * static_cast<double>(i + 1), 1.0);
  }

  std::vector<std::size_t> kind_;  ///< of each unknown, 0: its sign stays
  std::size_t kinds_;
};

bool overlap(double a, double b, double reach) { return std::abs(a - b) <= reach * margin; }

/// Whether x_i and sign·y_i may be equal.
bool may_agree(const Enclosure& x, const Enclosure& y, std::size_t i, double sign) {
  const std::complex<double> reach = x.radius[i] + y.radius[i], image = sign * y.mid[i];
  return overlap(x.mid[i].real(), image.real(), reach.real()) &&
         overlap(x.mid[i].imag(), image.imag(), reach.imag());
}

/// Whether sign·y_i lies where x is the only solution.
bool is_within_unique(const Enclosure& x, const Enclosure& y, std::size_t i, double sign) {
  return (std::abs(x.mid[i] - sign * y.mid[i]) + std::abs(y.radius[i])) * margin < x.unique;
}

}  // namespace

std::vector<Coincidence> coincidences(std::size_t solutions,
                                      const std::function<Enclosure(std::size_t)>& box_of,
                                      const SignMasks& mirror) {
  const Invariant invariant(mirror);
  std::vector<Interval> keys;
  for (std::size_t i = 0; i < solutions; ++i) keys.push_back(invariant.of(box_of(i)));
  std::vector<int> order(solutions);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return keys[a].low < keys[b].low; });

  std::vector<Coincidence> found;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && !(keys[order[j]].low > keys[order[i]].high); ++j) {
      const auto [first, second] = std::minmax(order[i], order[j]);
      const Enclosure x = box_of(static_cast<std::size_t>(first)),
                      y = box_of(static_cast<std::size_t>(second));
      const auto agree = [&](std::size_t k, double sign) { return may_agree(x, y, k, sign); };
      const auto same = [&](std::size_t k, double sign) { return is_within_unique(x, y, k, sign); };
      if (!some_signs_fit(mirror, agree)) continue;
      found.push_back({first, second, some_signs_fit(mirror, same)});
    }
  std::sort(found.begin(), found.end(), [](const Coincidence& a, const Coincidence& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return found;
}

std::vector<Coincidence> coincidences(const std::vector<Enclosure>& solutions, const SignMasks& mirror) {
  return coincidences(
      solutions.size(), [&](std::size_t i) { return solutions[i]; }, mirror);
}

int meeting_images(const Enclosure& box, const SignMasks& mirror) {
  SignEquations apart;
  for (std::size_t i = 0; i < mirror.size(); ++i)
    if (!may_agree(box, box, i, -1)) apart.add(mirror[i], false);
  return 1 << (mirror.rank() - apart.rank());
}

}  // namespace gcs
