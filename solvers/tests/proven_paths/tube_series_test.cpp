/// The parts of a tube's proof: the hyperplane's coordinates, the bounds along a polynomial, and the exact
/// decimals, each against 113 bits.

#include "solvers/proven_paths/tube_series.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/proven_paths/curve_section.hpp"
#include "solvers/tests/quad.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tracking/distance_curve.hpp"

using namespace gcs;
using samples::magnitude;
using samples::Quad;
using samples::RandomNumbers;

namespace {

constexpr int order = 12;

struct AtSketch {
  explicit AtSketch(const ProblemStatement& problem)
      : scene(problem),
        system(scene),
        data(enclose_path_data(scene, system)),
        series(distance_equations(system), data.lengths, order) {
    DistanceCurve curve(scene, order, 1e-7);
    ArcSeries arc(curve.coordinates(), order);
    REQUIRE(curve.start(1, arc));
    series.expand(arc);
  }

  Scene scene;
  DistanceSystem system;
  PathData data;
  TubeSeries series;
};

std::vector<ProblemStatement> problems() {
  std::vector<ProblemStatement> result{samples::k33(), samples::octahedron()};
  RandomNumbers random(3);
  result.push_back(samples::random_problem(2, 8, random));
  result.push_back(samples::random_problem(3, 7, random));
  result.push_back(samples::k33());
  result.back().interpolation.bends = {{2, {1.5, -0.75, 0.4}}, {5, {-0.3, 0.2}}};
  result.push_back(samples::octahedron());
  result.back().interpolation.bends = {{3, {0.5, 0.1, 0, 0.7, -0.2}}, {4, {2}}, {11, {0, 0, 1.25}}};
  return result;
}

/// Row j of the polynomial c at s.
Quad at(const Eigen::MatrixXd& c, Eigen::Index j, Quad s) {
  Quad value = 0;
  for (Eigen::Index n = c.cols() - 1; n >= 0; --n) value = value * s + c(j, n);
  return value;
}

/// (|Δ|² − a²)/2 of an edge at c(s), with parameters anywhere within their errors.
Quad residual(const AtSketch& test, int e, Quad s, RandomNumbers& random) {
  const Eigen::MatrixXd& c = test.series.curve().coefficients();
  const auto within = [&](double value, double error) {
    return Quad(value) + Quad(random.uniform(-1, 1)) * Quad(error);
  };
  const EnclosedLength& length = test.data.lengths[static_cast<std::size_t>(e)];
  const Quad t = at(c, c.rows() - 1, s), start = within(length.path.at_sketch, length.sketch_error),
             end = within(length.path.at_target, length.target_error),
             bend = within(length.path.bend, length.bend_error);
  Quad a = (1 - t) * start + t * end + bend * t * (1 - t), power = t;
  for (std::size_t i = 0; i < length.path.higher.size(); ++i, power *= t)
    a += within(length.path.higher[i], length.higher_errors[i]) * power * t * (1 - t);
  Quad sum = -a * a;
  const auto [a_end, b_end] = test.system.edges()[static_cast<std::size_t>(e)];
  for (int axis = 0; axis < test.system.dimension(); ++axis) {
    const int i = test.system.unknown(a_end, axis), j = test.system.unknown(b_end, axis);
    const Quad difference = (i >= 0 ? at(c, i, s) : 0) - (j >= 0 ? at(c, j, s) : 0);
    sum += difference * difference;
  }
  return sum / 2;
}

Quad square_root(Quad x) {
  Quad root = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 3; ++i) root = (root + x / root) / 2;
  return root;
}

using QuadPoint = std::array<Quad, 3>;

QuadPoint sketched(const Scene& scene, int point) {
  const auto given = scene.problem().sketch->points.col(point);
  return {std::ldexp(given[0], -scene.unit_exponent()), std::ldexp(given[1], -scene.unit_exponent()),
          std::ldexp(given[2], -scene.unit_exponent())};
}

Quad distance(const QuadPoint& a, const QuadPoint& b) {
  Quad sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return square_root(sum);
}

}  // namespace

TEST_CASE("a section's rows are exactly in the hyperplane and invert the Jacobian") {
  for (const ProblemStatement& problem : problems()) {
    const AtSketch test(problem);
    const Eigen::MatrixXd jacobian = test.series.jacobian();
    CurveSection section;
    REQUIRE(set_section(jacobian, test.series.curve().coefficient(1), true, section));
    const Eigen::Index m = section.equations();
    for (Eigen::Index i = 0; i < m; ++i) {
      Quad along = 0;
      for (Eigen::Index j = 0; j <= m; ++j) along += Quad(section.normal[j]) * Quad(section.rows(i, j));
      CHECK(along == 0);
      for (Eigen::Index j = 0; j <= m; ++j)
        for (Eigen::Index k = 0; k <= m; ++k)
          CHECK(Quad(section.rows(i, j)) - Quad(section.rows(i, k)) ==
                Quad(section.rows(i, j) - section.rows(i, k)));
    }
    const Eigen::MatrixXd defect = jacobian * section.rows.transpose() - Eigen::MatrixXd::Identity(m, m);
    CHECK(defect.cwiseAbs().maxCoeff() <= 1e-6);
    const Eigen::VectorXd tangent = test.series.curve().coefficient(1);
    CHECK((section.normal.normalized() - tangent).norm() <= 0.01);
  }
}

TEST_CASE("a singular Jacobian has no section") {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(2, 3);
  jacobian.row(0) << 1, 2, 3;
  jacobian.row(1) << 2, 4, 6;
  CurveSection section;
  CHECK_FALSE(set_section(jacobian, Eigen::Vector3d(0, 0, 1), true, section));
}

TEST_CASE("bounds along a polynomial hold for samples, and are sharp") {
  RandomNumbers random(7);
  for (const ProblemStatement& problem : problems()) {
    const AtSketch test(problem);
    const ArcSeries& arc = test.series.curve();
    for (const double tolerance : {1e-12, 1e-7, 1e-3}) {
      TubeBounds bounds;
      const double h = arc.step_for(tolerance);
      test.series.bound(h, bounds);
      for (int e = 0; e < test.series.count(); ++e) {
        CAPTURE(e, h);
        Quad largest = 0;
        for (int i = -8; i <= 8; ++i) {
          const Quad s = Quad(h) * i / 8;
          const Quad f = magnitude(residual(test, e, s, random));
          CHECK(f <= Quad(bounds.residual[e]));
          largest = std::max(largest, f);
        }
        // Of the bound on rounding little is ever used. What powers of t have beyond the order is bounded by the sizes
        // of its terms.
        const bool is_cut = !test.data.lengths[static_cast<std::size_t>(e)].path.higher.empty();
        CHECK(Quad(bounds.residual[e]) <= (is_cut ? 64 : 8) * largest + Quad(1e-12));
      }
    }
  }
}

TEST_CASE("the bound on the residual's slope holds between samples") {
  RandomNumbers random(8);
  for (const ProblemStatement& problem : problems()) {
    const AtSketch test(problem);
    TubeBounds bounds;
    const double h = test.series.curve().step_for(1e-4);
    test.series.bound(h, bounds);
    for (int e = 0; e < test.series.count(); ++e)
      for (int i = -8; i < 8; ++i) {
        // The same lengths at both ends.
        RandomNumbers same(static_cast<std::uint64_t>(i + 100)), again(static_cast<std::uint64_t>(i + 100));
        const Quad rise =
            residual(test, e, Quad(h) * (i + 1) / 8, same) - residual(test, e, Quad(h) * i / 8, again);
        CHECK(magnitude(rise) <= Quad(bounds.residual_speed[e]) * Quad(h) / 8);
      }
  }
}

TEST_CASE("the enclosed start has the sketch's exact distances, far from the origin too") {
  for (const double far : {0.0, 1e6}) {
    for (ProblemStatement problem : problems()) {
      for (int axis = 0; axis < problem.dimension; ++axis)
        problem.sketch->points.row(axis).array() += far * (axis + 1);
      const Scene scene(problem);
      const DistanceSystem system(scene);
      const PathData data = enclose_path_data(scene, system);
      REQUIRE(data.is_finite());
      const Figure start = system.figure(data.start.mid.head(system.unknowns()));
      const double radius = data.start.radius.maxCoeff();
      CHECK(radius <= 1e-14 * (1 + far) * 100);
      for (int e = 0; e < system.equations(); ++e) {
        const auto [a, b] = system.edges()[e];
        const Quad exact = distance(sketched(scene, a), sketched(scene, b));
        const EnclosedLength& length = data.lengths[static_cast<std::size_t>(e)];
        CHECK(magnitude(exact - Quad(length.path.at_sketch)) <= Quad(length.sketch_error));
        CHECK(length.sketch_error <= 1e-13 * (1 + far));
        const auto in_quad = [&](int p) {
          return QuadPoint{start.points(0, p), start.points(1, p), start.points(2, p)};
        };
        CHECK(magnitude(exact - distance(in_quad(a), in_quad(b))) <= Quad(4 * radius));
      }
    }
  }
}

TEST_CASE("a sketch that does not determine the frame has no finite start") {
  ProblemStatement problem = samples::octahedron();
  problem.sketch->points.col(2) = 2 * problem.sketch->points.col(1);
  const Scene scene(problem);
  CHECK_FALSE(enclose_path_data(scene, DistanceSystem(scene)).is_finite());
}
