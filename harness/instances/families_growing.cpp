/// Scenes that grow: by what a solver need not solve for, hung points and parts that can be solved apart, or by the
/// turns of S.

#include <fmt/format.h>

#include <cmath>

#include "harness/instances/family_draft.hpp"
#include "harness/instances/family_lists.hpp"
#include "harness/instances/rocker_chain.hpp"

namespace gcs {
namespace {

/// In [0, 1), as irregular as need be, and the same everywhere: multiples of the golden ratio, to four
/// decimals.
double irregular(int number) {
  const double multiple = 0.6180339887 * number;
  return std::round((multiple - std::floor(multiple)) * 1e4) / 1e4;
}

/// In decimals: low + width · irregular(number).
std::string irregular_decimal(double low, double width, int number) {
  return fmt::format("{:.4f}", low + width * irregular(number));
}

/// Triangles 3k, 3k + 1, 3k + 2 over one another, each twisted against the next, with which it makes an
/// octahedron.
Draft tower(int octahedra) {
  Draft draft{.points = 3 * (octahedra + 1)};
  std::vector<ExactPoint> points;
  for (int point = 0; point < draft.points; ++point) {
    const int layer = point / 3, first = point - point % 3;
    const double angle = 2.0944 * (point % 3) + 1.05 * layer;
    const auto coordinate = [&](double value, int salt) {
      return irregular_decimal(value - 0.25, 0.5, 3 * point + salt);
    };
    points.push_back({coordinate(std::cos(angle), 0), coordinate(std::sin(angle), 1), coordinate(layer, 2)});
    draft.sketch.push_back({std::cos(angle), std::sin(angle), 1.2 * layer});
    for (int other = first; other < point; ++other) draft.edges.push_back({other, point});
    for (int other = first - 3; layer > 0 && other < first; ++other)
      if (other % 3 != point % 3) draft.edges.push_back({other, point});
  }
  return measured_at(points, draft);
}

std::string octahedra(const std::string& id, const std::string& count) {
  return text_of(id, tower(std::stoi(count)));
}

/// Hangs points on all of `simplices` in turn, at distances that are long beside those in the scene and
/// nearly the same, so that there are places for them.
std::string with_hung_points(const std::string& id, Draft draft,
                             const std::vector<std::vector<int>>& simplices, int count) {
  for (int i = 0; i < count; ++i) {
    const int point = draft.points++;
    for (const int other : simplices[static_cast<std::size_t>(i) % simplices.size()]) {
      draft.edges.push_back({other, point});
      draft.squares.emplace_back(irregular_decimal(16, 2, static_cast<int>(draft.edges.size())));
    }
    draft.sketch.push_back(
        {4 * std::cos(1.0 * i), 4 * std::sin(1.0 * i), draft.dimension == 3 ? std::cos(0.3 * i) : 0});
  }
  return text_of(id, draft);
}

std::string octahedron_hung(const std::string& id, const std::string& count) {
  return with_hung_points(id, tower(1), {{0, 1, 2}, {0, 1, 5}, {1, 2, 3}, {0, 2, 4}, {0, 4, 5}, {3, 4, 5}},
                          std::stoi(count));
}

std::string k33_hung(const std::string& id, const std::string& count) {
  Draft draft{
      .dimension = 2,
      .points = 6,
      .edges = {{0, 1}, {0, 3}, {0, 5}, {2, 1}, {2, 3}, {2, 5}, {4, 1}, {4, 3}, {4, 5}},
      .sketch = {{0.1, 0, 0}, {2.2, 0.4, 0}, {2.8, 1.7, 0}, {1.9, 3.1, 0}, {0.4, 2.7, 0}, {-0.7, 1.2, 0}}};
  draft = measured_at({{"0", "0", "0"},
                       {"2.1", "0.3", "0"},
                       {"3", "1.9", "0"},
                       {"1.7", "3.2", "0"},
                       {"0.2", "2.9", "0"},
                       {"-0.9", "1.1", "0"}},
                      draft);
  return with_hung_points(id, draft, {{0, 1}, {2, 3}, {4, 5}, {0, 2}, {1, 4}}, std::stoi(count));
}

}  // namespace

std::span<const InstanceFamily> growing_families() {
  static const std::vector<InstanceFamily> all{
      {"octahedron-hung",
       "an octahedron with points that hang on it",
       {"0", "3", "10", "100", "1000"},
       octahedron_hung},
      {"k33-hung", "K3,3 with points that hang on it", {"0", "3", "10", "100", "1000"}, k33_hung},
      {"octahedra",
       "a tower of octahedra, each with a triangle in common with the next",
       {"1", "2", "3", "10"},
       octahedra},
      {"rocker-chain",
       "n rockers, each driven by the one before: S turns twice as often with each",
       {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"},
       rocker_chain}};
  return all;
}

}  // namespace gcs
