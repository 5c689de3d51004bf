#include "solvers/subdivision/start_box.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double upper_length(const Scene& scene, int constraint) {
  return sqrt(enclosing(nearest_double_double(given_square(scene, constraint)))).high;
}

/// Of all pairs of entities at least their distance in every solution; infinite where nothing is known of it.
class Ways {
 public:
  explicit Ways(const Scene& scene)
      : count_(scene.point_count() + static_cast<int>(scene.problem().lines.size())),
        way_(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_), infinity) {
    for (int point = 0; point < scene.point_count(); ++point) at(point, point) = 0;
    for (int i = 0; i < scene.constraint_count(); ++i) {
      const auto [a, b] = scene.problem().constraints[static_cast<std::size_t>(i)].between;
      at(a, b) = at(b, a) = upper_length(scene, i);
    }
    // Floyd, Warshall; no way leads over a line.
    for (int over = 0; over < scene.point_count(); ++over)
      for (int a = 0; a < count_; ++a)
        for (int b = 0; b < count_; ++b) {
          const double way = rounded_up(at(a, over) + at(over, b));
          if (way < at(a, b)) at(a, b) = way;
        }
  }

  double between(int a, int b) const { return way_[index(a, b)]; }

 private:
  std::size_t index(int a, int b) const {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(b);
  }
  double& at(int a, int b) { return way_[index(a, b)]; }

  int count_;
  std::vector<double> way_;
};

class StartBox {
 public:
  StartBox(const Scene& scene, const SceneEquations& equations)
      : scene_(scene),
        equations_(equations),
        ways_(scene),
        box_(static_cast<std::size_t>(equations.system().unknowns), Interval{-infinity, infinity}) {}

  IntervalBox run() {
    for (int point = 0; point < scene_.point_count(); ++point)
      for (int axis = 0; axis < scene_.dimension(); ++axis) bound_point(point, axis);
    for (int line = 0; line < static_cast<int>(scene_.problem().lines.size()); ++line) bound_line(line);
    for (const int unknown : signed_unknowns(scene_, equations_)) narrow(unknown, {0, infinity});
    return std::move(box_);
  }

 private:
  void narrow(int unknown, const Interval& values) {
    Interval& known = box_[static_cast<std::size_t>(unknown)];
    known = intersection(known, values);
  }

  Interval given(int point, int axis) const {
    return enclosing(nearest_double_double(given_coordinate(scene_, point, axis)));
  }

  void bound_point(int point, int axis) {
    const int unknown = equations_.point_unknown(point, axis);
    if (unknown < 0) return;
    for (int other = 0; other < scene_.point_count(); ++other) {
      const double way = ways_.between(point, other);
      if (way < infinity && equations_.point_unknown(other, axis) < 0)
        narrow(unknown, given(other, axis) + interval_around_zero(way));
    }
    const bool is_line_on_axis = scene_.has_lines() && !scene_.is_anchored();
    if (is_line_on_axis && axis > 0)
      narrow(unknown, interval_around_zero(ways_.between(point, scene_.point_count())));
  }

  void bound_line(int line) {
    if (equations_.line_unknown(line, 0, 0) < 0) return;
    double farthest = infinity;
    for (int point = 0; point < scene_.point_count(); ++point) {
      Interval sum{0, 0};
      for (int axis = 0; axis < scene_.dimension(); ++axis) sum = sum + square(given(point, axis));
      farthest =
          std::min(farthest, rounded_up(sqrt(sum).high + ways_.between(point, scene_.point_count() + line)));
    }
    for (int axis = 0; axis < 3; ++axis)
      for (const auto& [part, radius] : {std::pair(0, farthest), std::pair(1, 1.0)})
        narrow(equations_.line_unknown(line, part, axis), interval_around_zero(radius));
  }

  const Scene& scene_;
  const SceneEquations& equations_;
  Ways ways_;
  IntervalBox box_;
};

}  // namespace

std::vector<int> signed_unknowns(const Scene& scene, const SceneEquations& equations) {
  const DistanceSystem points(scene);
  const Reference& frame = points.reference();
  const SignMasks mirror = equations.system().mirror;
  std::map<SignMask, int> chosen;  // by kind of mirror image
  for (int unknown = 0; unknown < static_cast<int>(mirror.size()); ++unknown)
    if (const SignMask kind = mirror[static_cast<std::size_t>(unknown)]; kind != 0)
      chosen.try_emplace(kind, unknown);
  const auto prefer = [&](int point, int axis) {
    const int unknown = point < 0 || scene.is_anchored() ? -1 : equations.point_unknown(point, axis);
    if (unknown >= 0) chosen[mirror[static_cast<std::size_t>(unknown)]] = unknown;
  };
  prefer(frame.axis, 0);
  prefer(frame.plane, 1);
  prefer(frame.height, 2);
  std::vector<int> result;
  for (const auto& [kind, unknown] : chosen) result.push_back(unknown);
  return result;
}

IntervalBox start_box(const Scene& scene, const SceneEquations& equations) {
  return StartBox(scene, equations).run();
}

}  // namespace gcs
