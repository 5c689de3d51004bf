#include "solvers/tracking/path_tracker.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

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

/// Equations (1)–(6) of Hoffmann, Yuan 2000, section 4.1, homogeneous in (e, p, u) and on a random patch,
/// from squares that are e².
class SixQuadrics {
 public:
  static constexpr int unknowns = 7;
  using Vector = ComplexVector<unknowns>;
  using Row = Eigen::Matrix<Complex, 1, unknowns>;

  explicit SixQuadrics(RandomNumbers& random) {
    center_[1] = {random.uniform(1, 2), 0, 0};
    center_[2] = {random.uniform(-1, 1), random.uniform(1, 2), 0};
    center_[3] = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(1, 2)};
    for (double& radius : radius_) radius = random.uniform(0.3, 1.2);
    for (int i = 0; i < unknowns; ++i) patch_[i] = std::polar(1.0, random.uniform(-3, 3));
    gamma_ = std::polar(1.0, random.uniform(-3, 3));
  }

  HomotopyValue<unknowns> at(const Vector& x, Complex t) const {
    return straight_line(start(x), target(x), gamma_, t);
  }

  std::vector<Vector> starts() const {
    std::vector<Vector> result;
    for (int signs = 0; signs < 64; ++signs) {
      Vector x = Vector::Ones();
      for (int i = 0; i < 6; ++i)
        if ((signs >> i & 1) != 0) x[i + 1] = -1;
      result.push_back(x / on_patch(x));
    }
    return result;
  }

  /// The largest difference of a centre's distance from the line and its radius, by the cross product.
  double error(const Eigen::Vector3cd& point, const Eigen::Vector3cd& direction) const {
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3cd w = point - center_[i], area = w.cross(direction).conjugate();
      const Complex square = (area.transpose() * area).value();
      largest = std::max(largest, std::abs(square - radius_[i] * radius_[i]));
    }
    return largest;
  }

 private:
  Complex on_patch(const Vector& x) const { return (patch_.transpose() * x).value(); }

  void add_patch(const Vector& x, SystemValue<unknowns>& system) const {
    system.value[6] = on_patch(x) - 1.0;
    system.jacobian.row(6) = patch_.transpose();
  }

  SystemValue<unknowns> start(const Vector& x) const {
    SystemValue<unknowns> system;
    system.jacobian.setZero();
    for (int i = 0; i < 6; ++i) {
      system.value[i] = x[i + 1] * x[i + 1] - x[0] * x[0];
      system.jacobian(i, 0) = -2.0 * x[0];
      system.jacobian(i, i + 1) = 2.0 * x[i + 1];
    }
    add_patch(x, system);
    return system;
  }

  SystemValue<unknowns> target(const Vector& x) const {
    const Complex e = x[0];
    const Eigen::Vector3cd p = x.segment<3>(1), u = x.tail<3>();
    SystemValue<unknowns> system;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3cd c = center_[i].cast<Complex>(), w = e * c - p;
      const Complex along = (c.transpose() * u).value(), square = radius_[i] * radius_[i];
      system.value[i] = (w.transpose() * w).value() - along * along - square * e * e;
      system.jacobian.row(i) << 2.0 * (w.transpose() * c).value() - 2.0 * square * e, -2.0 * w.transpose(),
          -2.0 * along * c.transpose();
    }
    system.value[4] = (p.transpose() * u).value();
    system.jacobian.row(4) << 0, u.transpose(), p.transpose();
    system.value[5] = (u.transpose() * u).value() - e * e;
    system.jacobian.row(5) << -2.0 * e, Eigen::RowVector3cd::Zero(), 2.0 * u.transpose();
    add_patch(x, system);
    return system;
  }

  std::array<Eigen::Vector3d, 4> center_{Eigen::Vector3d::Zero()};
  std::array<double, 4> radius_{};
  Vector patch_;
  Complex gamma_;
};

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

TEST_CASE("of the 64 paths of the published six quadrics 24 have finite ends") {
  RandomNumbers random(2000);
  const SixQuadrics quadrics(random);
  std::vector<SixQuadrics::Vector> finite;
  int at_infinity = 0;
  for (const auto& end : ends_of(quadrics, quadrics.starts())) {
    INFO(end.cause << ", first coordinate " << std::abs(end.x[0]));
    CHECK(end.kind != TrackingEnd<7>::Kind::failed);
    // The ends at infinity are singular and their coordinates right to 1e-8.
    if (std::abs(end.x[0]) <= 1e-6 * end.x.norm()) {
      ++at_infinity;
      continue;
    }
    CHECK(end.kind == TrackingEnd<7>::Kind::regular);
    finite.push_back(end.x / end.x[0]);
  }
  CHECK(at_infinity == 40);
  REQUIRE(finite.size() == 24);
  for (const auto& line : finite) {
    CHECK(quadrics.error(line.segment<3>(1), line.tail<3>()) <= 1e-9 * line.squaredNorm());
    // Both orientations are among them, each once.
    SixQuadrics::Vector opposite = line;
    opposite.tail<3>() *= -1;
    const auto count = [&](const SixQuadrics::Vector& place) {
      return std::count_if(finite.begin(), finite.end(), [&](const SixQuadrics::Vector& other) {
        return (other - place).norm() <= 1e-8 * place.norm();
      });
    };
    CHECK(count(line) == 1);
    CHECK(count(opposite) == 1);
  }
}
