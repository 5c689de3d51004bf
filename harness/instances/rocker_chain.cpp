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
/// No turn of S_k may lie in the gap, nor a figure at t = 1. In its figures y_1, …, y_(k−1) are near their smallest
/// values: by less than the gap in y_k times (dy_k/dy_j)^(−1), where each dx_(j+1)/dy_j is 1/2 or more there. Gaps
/// of `gap` · `shrink`^(k−1) of a rocker's swing are small in all of them. So at t = 1 all 2^n choices of branches
/// are figures, and all are on S.
///
/// Before a turn in t the plan, which has no driving parameter of its own, must exchange the instruction that comes
/// to its boundary configuration: 2^(n+1) − 2 exchanges, each undone when the plan is next changed.

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
constexpr double gap = 0.05;                    ///< of the first rocker's swing
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

/// x_1 in the sketch: the peak of |B p_1| is where bend · (1 − 2 t) + a(1) − a(0) = 0.
double first_sketched(double bar) {
  return -angle_between(pivots_apart, radius(1), bar + bend * (1 - 2 * peak_time));
}

/// x_(k+1) in the sketch, on the branch δ − φ, which is there for every y.
double next_sketched(int k, double y, double bar) {
  const double away = opposite(pivots_apart, inner_radius(k), y);
  return seen_angle(inner_radius(k), y) - angle_between(radius(k + 1), away, bar);
}

struct GivenDistance {
  int from = 0;
  double length = 0;
};

/// Places a point of the sketch, and says which one it is.
int place(Draft& draft, const std::array<double, 3>& at, const std::array<GivenDistance, 2>& distances) {
  for (const GivenDistance& given : distances) {
    draft.edges.push_back({given.from, draft.points});
    draft.squares.emplace_back(fmt::format("{:.9f}", given.length));
  }
  draft.sketch.push_back(at);
  return draft.points++;
}

/// With lengths in place of squares.
Draft draft_of(const std::vector<Rocker>& all) {
  Draft draft{.dimension = 2,
              .points = 2,
              .edges = {{0, 1}},
              .squares = {fmt::format("{}", pivots_apart)},
              .sketch = {{0, 0}, {pivots_apart, 0}},
              .interpolation = fmt::format(R"({{"bent": "a2", "bend": {}}})", bend)};
  double x = first_sketched(all.front().bar);
  int driver = 1;
  for (int k = 1;; ++k) {
    const Rocker& rocker = all[static_cast<std::size_t>(k - 1)];
    const int pivot = (k + 1) % 2;
    const int tip = place(draft, at_angle(k, radius(k), x), {{{driver, rocker.bar}, {pivot, radius(k)}}});
    if (k == static_cast<int>(all.size())) return draft;
    const double across = rounded(opposite(radius(k), inner_radius(k), rocker.offset));
    const double y = x + angle_between(radius(k), inner_radius(k), across);
    driver = place(draft, at_angle(k, inner_radius(k), y), {{{pivot, inner_radius(k)}, {tip, across}}});
    x = next_sketched(k, y, all[static_cast<std::size_t>(k)].bar);
  }
}

}  // namespace

std::string rocker_chain(const std::string& id, const std::string& n) {
  return text_of(id, draft_of(rockers(std::stoi(n))), "length");
}

}  // namespace gcs
