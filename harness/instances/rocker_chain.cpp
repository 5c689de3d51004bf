/// A family for [I] §7.3.3: a construction plan whose changes double with every two points more.
///
/// Rocker k turns about the pivot P, which is A for odd k and B for even k, and is a rigid triangle P, p_k, r_k.
/// A bar from r_k to p_(k+1) drives the next rocker, about the other pivot Q. All angles are measured at the
/// pivot, from the line to the other pivot, towards the upper half plane: x_k is that of p_k, y_k = x_k + ω_k that
/// of r_k. The only length that depends on t is |B p_1|. It is concave, so that x_1 = ±φ(t), with a change of
/// sign at both ends of the times at which the triangle A, B, p_1 closes.
///
/// With u(y) = |r_k Q| and δ(y) the angle of r_k at Q, x_(k+1) = δ ± φ, where φ is the angle at Q of a triangle
/// with sides u, bar and |Q p_(k+1)|. u grows with y, and the bar is so long that φ = 0 (boundary
/// configuration, where S turns in t) a little before y reaches its end. What is left out of the loop S_k of the
/// first k rockers is one small gap, about the one figure in which y_k is largest. So S_(k+1) is the rest of S_k
/// twice, once on each branch, joined at both sides of the gap: a loop again, with twice the turns of S_k and two
/// more: 2, 6, 14, …, 2^(k+1) − 2. Since δ + φ falls with y and δ − φ grows, x_(k+1) has on it one largest and one
/// smallest value, both where y_k is smallest, and the next rocker finds what this one found.
///
/// The gap must hold no turn of S_k, and not t = 1. The figures in it have all rockers but the last one near their
/// smallest angle, the closer the later they are: as dx_(k+1)/dy_k = 1/2 or so there, gaps of a rocker's swing by
/// `gap` · `shrink`^(k−1) remain small in all x_j. Then every figure at t = 1 but the signs of n branches is one,
/// 2^n, and all lie on S. Every turn in t costs the plan, which has no driving parameter elsewhere, an exchange
/// and a restoration: 2^(n+2) − 4 changes.

#include "harness/instances/rocker_chain.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "harness/instances/family_draft.hpp"

namespace gcs {
namespace {

// Any near these do: with them y stays below 176°, where u ceases to grow.
constexpr double pivots_apart = 1.65;
constexpr double degree = 3.14159265358979323846 / 180;
constexpr double smallest_angle = 50 * degree;  ///< of y
constexpr double first_angle = 61.5 * degree;   ///< largest of x_1
constexpr double gap = 0.05;                    ///< in widths of the swing of the first rocker
constexpr double shrink = 0.55;
constexpr double bend = 2;          ///< of |B p_1|, the published one
constexpr double peak_time = 0.54;  ///< at which |B p_1| is longest

/// No two lengths are the same, (h3).
double radius(int k) { return 1 + 0.004 * (k - 1); }
double inner_radius(int k) { return 0.62 - 0.003 * (k - 1); }

/// To nine decimals: where the smallest gap is, bars differ by 1e-5.
double rounded(double length) { return std::round(length * 1e9) / 1e9; }

/// The third side of a triangle.
double opposite(double a, double b, double angle) {
  return std::sqrt(a * a + b * b - 2 * a * b * std::cos(angle));
}

/// The angle between the sides a and b.
double angle_between(double a, double b, double opposite_side) {
  return std::acos((a * a + b * b - opposite_side * opposite_side) / (2 * a * b));
}

/// At the other pivot, of a point at `radius` and `angle` about this one.
double seen_angle(double radius, double angle) {
  return std::atan2(radius * std::sin(angle), pivots_apart - radius * std::cos(angle));
}

/// What rocker k adds to the one before it.
struct Rocker {
  double bar = 0;     ///< |r_(k−1) p_k|; of the first one |B p_1| at t = 1
  double offset = 0;  ///< ω_k
};

/// Rockers that swing as the opening comment says.
std::vector<Rocker> rockers(int n) {
  const double longest = opposite(pivots_apart, radius(1), first_angle);
  double low = -first_angle, high = first_angle;
  std::vector<Rocker> all;
  double bar = longest - bend * (1 - peak_time) * (1 - peak_time);
  for (int k = 1; k <= n; ++k) {
    all.push_back({rounded(bar), smallest_angle - low});
    const double cut = smallest_angle + (high - low) * (1 - gap * std::pow(shrink, k - 1));
    bar = opposite(pivots_apart, inner_radius(k), cut) - radius(k + 1);
    const double direction = seen_angle(inner_radius(k), smallest_angle);
    const double swing =
        angle_between(radius(k + 1), opposite(pivots_apart, inner_radius(k), smallest_angle), rounded(bar));
    low = direction - swing;
    high = direction + swing;
  }
  return all;
}

/// A point of rocker k.
std::array<double, 3> at_angle(int k, double radius, double angle) {
  const double along = radius * std::cos(angle);
  return {k % 2 == 1 ? along : pivots_apart - along, radius * std::sin(angle), 0};
}

/// The angle of r at a distance `across` from p, both about one pivot.
double offset_of(int k, double across) { return angle_between(radius(k), inner_radius(k), across); }

Draft draft_of(const std::vector<Rocker>& all) {
  Draft draft{.dimension = 2, .points = 2, .edges = {{0, 1}}, .sketch = {{0, 0}, {pivots_apart, 0}}};
  std::vector<double> lengths{pivots_apart};
  const auto constrain = [&](int a, int b, double length) {
    draft.edges.push_back({a, b});
    lengths.push_back(length);
  };
  // What |B p_1| is at t = 0: its peak is where bend · (1 − 2 t) + a(1) − a(0) = 0.
  const double at_sketch = all.front().bar + bend * (1 - 2 * peak_time);
  double x = -angle_between(pivots_apart, radius(1), at_sketch);
  int driver = 1;  // p2 is B
  for (int k = 1; k <= static_cast<int>(all.size()); ++k) {
    const Rocker& rocker = all[static_cast<std::size_t>(k - 1)];
    const int pivot = (k + 1) % 2, tip = draft.points;
    constrain(driver, tip, rocker.bar);
    constrain(pivot, tip, radius(k));
    draft.sketch.push_back(at_angle(k, radius(k), x));
    ++draft.points;
    if (k == static_cast<int>(all.size())) break;
    const double across = rounded(opposite(radius(k), inner_radius(k), rocker.offset));
    driver = draft.points++;
    constrain(pivot, driver, inner_radius(k));
    constrain(tip, driver, across);
    const double y = x + offset_of(k, across);
    draft.sketch.push_back(at_angle(k, inner_radius(k), y));
    x = seen_angle(inner_radius(k), y) - angle_between(radius(k + 1),
                                                       opposite(pivots_apart, inner_radius(k), y),
                                                       all[static_cast<std::size_t>(k)].bar);
  }
  for (const double length : lengths) draft.squares.emplace_back(fmt::format("{:.9f}", length));
  draft.interpolation = fmt::format(R"({{"bent": "a2", "bend": {}}})", bend);
  return draft;
}

}  // namespace

std::string rocker_chain(const std::string& id, const std::string& n) {
  return text_of(id, draft_of(rockers(std::stoi(n))), "length");
}

}  // namespace gcs
