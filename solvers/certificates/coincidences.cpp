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
  explicit Invariant(const std::vector<int>& mirror)
      : mirror_(mirror), groups_(mirror.empty() ? 0 : 1 + *std::max_element(mirror.begin(), mirror.end())) {}

  Interval of(const Enclosure& solution) const {
    std::vector<Sum> sums(static_cast<std::size_t>(groups_));
    Sum fixed;
    for (std::size_t i = 0; i < mirror_.size(); ++i)
      (mirror_[i] < 0 ? fixed : sums[static_cast<std::size_t>(mirror_[i])]).add(weight(i), solution, i);
    double mid = fixed.mid.real(), radius = fixed.radius();
    for (const Sum& sum : sums) {
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

  const std::vector<int>& mirror_;
  int groups_;
};

/// The unknowns that change sign together.
std::vector<std::vector<std::size_t>> sign_groups(const std::vector<int>& mirror) {
  std::vector<std::vector<std::size_t>> groups(1);  // the first one's signs stay
  for (std::size_t i = 0; i < mirror.size(); ++i) {
    const auto group = static_cast<std::size_t>(mirror[i] + 1);
    if (group >= groups.size()) groups.resize(group + 1);
    groups[group].push_back(i);
  }
  return groups;
}

bool overlap(double a, double b, double reach) { return std::abs(a - b) <= reach * margin; }

/// Whether x_i and sign·y_i may be equal for all i of a group.
bool may_agree(const Enclosure& x, const Enclosure& y, const std::vector<std::size_t>& group, double sign) {
  return std::all_of(group.begin(), group.end(), [&](std::size_t i) {
    const std::complex<double> reach = x.radius[i] + y.radius[i], image = sign * y.mid[i];
    return overlap(x.mid[i].real(), image.real(), reach.real()) &&
           overlap(x.mid[i].imag(), image.imag(), reach.imag());
  });
}

/// Whether sign·y lies where x is the only solution.
bool is_within_unique(const Enclosure& x, const Enclosure& y, const std::vector<std::size_t>& group,
                      double sign) {
  return std::all_of(group.begin(), group.end(), [&](std::size_t i) {
    return (std::abs(x.mid[i] - sign * y.mid[i]) + std::abs(y.radius[i])) * margin < x.unique;
  });
}

/// Reflections in different groups are independent, so each group is looked at alone.
template <typename Test>
bool holds_for_an_image(const std::vector<std::vector<std::size_t>>& groups, const Test& test) {
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (!test(groups[g], 1.0) && !(g > 0 && test(groups[g], -1.0))) return false;
  return true;
}

}  // namespace

std::vector<Coincidence> coincidences(const std::vector<Enclosure>& solutions,
                                      const std::vector<int>& mirror) {
  const Invariant invariant(mirror);
  const auto groups = sign_groups(mirror);
  std::vector<Interval> keys;
  for (const Enclosure& solution : solutions) keys.push_back(invariant.of(solution));
  std::vector<int> order(solutions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return keys[a].low < keys[b].low; });

  std::vector<Coincidence> found;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && !(keys[order[j]].low > keys[order[i]].high); ++j) {
      const auto [first, second] = std::minmax(order[i], order[j]);
      const Enclosure &x = solutions[static_cast<std::size_t>(first)],
                      &y = solutions[static_cast<std::size_t>(second)];
      const auto agree = [&](const auto& group, double sign) { return may_agree(x, y, group, sign); };
      const auto same = [&](const auto& group, double sign) { return is_within_unique(x, y, group, sign); };
      if (!holds_for_an_image(groups, agree)) continue;
      found.push_back({first, second, holds_for_an_image(groups, same)});
    }
  std::sort(found.begin(), found.end(), [](const Coincidence& a, const Coincidence& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return found;
}

int meeting_images(const Enclosure& box, const std::vector<int>& mirror) {
  const auto groups = sign_groups(mirror);
  int images = 1;
  for (auto group = groups.begin() + 1; group != groups.end(); ++group)
    if (!group->empty() && may_agree(box, box, *group, -1)) images *= 2;
  return images;
}

}  // namespace gcs
