#include "solvers/tracking/path_tracker.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

using namespace gcs;

namespace {

using Complex = std::complex<double>;

const Complex gamma_on_circle = std::polar(1.0, 0.9);

/// From x² = y² = 1 to x² + y² = 2a, xy = b.
struct CircleAndHyperbola {
  static constexpr int unknowns = 2;
  double a = 0;
  double b = 0;

  HomotopyValue<2> at(const ComplexVector<2>& p, Complex t) const {
    const Complex x = p[0], y = p[1];
    SystemValue<2> start, target;
    start.value << x * x - 1.0, y * y - 1.0;
    start.jacobian << 2.0 * x, 0, 0, 2.0 * y;
    target.value << x * x + y * y - 2 * a, x * y - b;
    target.jacobian << 2.0 * x, 2.0 * y, y, x;
    return straight_line(start, target, gamma_on_circle, t);
  }
};

/// From x³ = 1 to (x − 2)³ = c.
struct Cube {
  static constexpr int unknowns = 1;
  double c = 0;

  HomotopyValue<1> at(const ComplexVector<1>& p, Complex t) const {
    const Complex x = p[0], from_root = x - 2.0;
    SystemValue<1> start, target;
    start.value << x * x * x - 1.0;
    start.jacobian << 3.0 * x * x;
    target.value << from_root * from_root * from_root - c;
    target.jacobian << 3.0 * from_root * from_root;
    return straight_line(start, target, gamma_on_circle, t);
  }
};

template <class H>
std::vector<TrackingEnd<H::unknowns>> ends_of(const H& homotopy,
                                              const std::vector<ComplexVector<H::unknowns>>& starts) {
  WorkCounters work;
  PathTracker<H> tracker(homotopy, work);
  std::vector<TrackingEnd<H::unknowns>> ends;
  for (const auto& start : starts) ends.push_back(tracker.follow(start));
  CHECK(work.iterations > 0);
  return ends;
}

/// How many of the ends are at `place`.
template <int n>
auto count_at(const std::vector<TrackingEnd<n>>& ends, const ComplexVector<n>& place, double tolerance) {
  return std::count_if(ends.begin(), ends.end(),
                       [&](const TrackingEnd<n>& end) { return (end.x - place).norm() <= tolerance; });
}

const std::vector<ComplexVector<2>> corners{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

}  // namespace

/// Counts how often it is evaluated.
struct Counting {
  static constexpr int unknowns = 2;
  CircleAndHyperbola homotopy;
  std::int64_t& evaluations;

  HomotopyValue<2> at(const ComplexVector<2>& p, Complex t) const {
    ++evaluations;
    return homotopy.at(p, t);
  }
};

TEST_CASE("every evaluation of a homotopy is counted, and every factorisation") {
  for (const double b : {2, 4}) {  // regular ends, and double ones
    std::int64_t evaluations = 0;
    WorkCounters work;
    const Counting homotopy{{b == 2 ? 2.5 : 4, b}, evaluations};
    PathTracker<Counting> tracker(homotopy, work);
    tracker.follow(corners.front());
    CHECK(work.evaluations == evaluations);
    CHECK(work.jacobians == evaluations);
    CHECK(work.factorisations >= work.newton_iterations + 4 * work.iterations);
    CHECK(work.factorisations <= evaluations);
  }
}

TEST_CASE("four paths end at the four roots") {
  const auto ends = ends_of(CircleAndHyperbola{2.5, 2}, corners);
  for (const auto& end : ends) CHECK(end.kind == TrackingEnd<2>::Kind::regular);
  for (const ComplexVector<2>& root : {ComplexVector<2>{1, 2}, {2, 1}, {-1, -2}, {-2, -1}})
    CHECK(count_at(ends, root, 1e-14) == 1);
}

TEST_CASE("two paths end at each of two double roots") {
  const auto ends = ends_of(CircleAndHyperbola{4, 4}, corners);
  for (const auto& end : ends) {
    CHECK(end.kind == TrackingEnd<2>::Kind::singular);
    CHECK(end.winding_number == 2);
  }
  CHECK(count_at(ends, {2, 2}, 1e-10) == 2);
  CHECK(count_at(ends, {-2, -2}, 1e-10) == 2);
}

TEST_CASE("a triple root has winding number 3, three near it have 1") {
  const std::vector<ComplexVector<1>> starts{ComplexVector<1>(1),
                                             ComplexVector<1>(std::polar(1.0, 2 * std::numbers::pi / 3)),
                                             ComplexVector<1>(std::polar(1.0, 4 * std::numbers::pi / 3))};
  for (const auto& end : ends_of(Cube{0}, starts)) {
    CHECK(end.kind == TrackingEnd<1>::Kind::singular);
    CHECK(end.winding_number == 3);
    CHECK(std::abs(end.x[0] - 2.0) <= 1e-10);
  }
  const auto near = ends_of(Cube{1e-9}, starts);
  for (int k = 0; k < 3; ++k) {
    const Complex root = 2.0 + std::polar(1e-3, 2 * std::numbers::pi * k / 3);
    CHECK(count_at(near, ComplexVector<1>(root), 1e-9) == 1);
  }
}
