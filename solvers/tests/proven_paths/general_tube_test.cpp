/// The parts of a tube's proof for general scenes, against 113 bits: enclosures of the file's numbers, the start, bounds
/// along a polynomial, and points of the arc.

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/proven_paths/general_path_data.hpp"
#include "solvers/proven_paths/path_tube.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/quad.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tests/tracking/general_path_samples.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

constexpr int order = 12;

using QuadVector = std::vector<Quad>;

/// Errors that are as they are, or so large that a bound without them fails.
struct GeneralStart {
  explicit GeneralStart(const ProblemStatement& problem, double more_error = 0)
      : scene(Scene::unchecked(problem)),
        system(scene),
        sketched(sketched_unknowns(scene, system).value().x),
        family(scene, system, sketched, order),
        equations(general_equations(system, family.values())),
        data(enclose_path_data(scene, system, family.values(), sketched)) {
    for (EnclosedForm& form : equations.forms) {
      form.constant_error += more_error * std::abs(form.constant);
      for (EnclosedForm::Term& term : form.terms) term.error += more_error * std::abs(term.coefficient);
    }
    for (EnclosedLength& length : data.lengths) {
      length.sketch_error += more_error * std::abs(length.path.at_sketch);
      length.target_error += more_error * std::abs(length.path.at_target);
    }
  }

  ArcSeries arc() const {
    GeneralCurve curve(family, 1e-7);
    ArcSeries series(curve.coordinates(), order);
    REQUIRE(curve.start(1, series));
    return series;
  }

  Scene scene;
  SceneSystem system;
  Eigen::VectorXd sketched;
  GeneralFamily family;
  PathEquations equations;
  PathData data;
};

/// Equations whose numbers are anywhere within their errors, the same for one seed.
class ExactEquations {
 public:
  ExactEquations(const PathEquations& equations, const std::vector<EnclosedLength>& lengths,
                 std::uint64_t seed)
      : equations_(equations), lengths_(lengths), random_(seed) {
    for (const EnclosedForm& form : equations.forms) {
      numbers_.push_back({within(form.constant, form.constant_error)});
      for (const EnclosedForm::Term& term : form.terms)
        numbers_.back().push_back(within(term.coefficient, term.error));
    }
    for (const EnclosedLength& length : lengths)
      ends_.push_back({within(length.path.at_sketch, length.sketch_error),
                       within(length.path.at_target, length.target_error),
                       within(length.path.bend, length.bend_error)});
  }

  Quad sum(Eigen::Index e, const QuadVector& y) const {
    Quad result = 0;
    for (const FormPair& pair : equations_.pairs)
      if (pair.equation == e) result += form(pair.value, y) * form(pair.moved, y) / 2;
    return result;
  }

  Quad residual(Eigen::Index e, const QuadVector& y) const {
    const auto i = static_cast<std::size_t>(e);
    const Quad t = y.back(), a = (1 - t) * ends_[i][0] + t * ends_[i][1] + ends_[i][2] * t * (1 - t);
    return sum(e, y) - (lengths_[i].is_plain ? a : a * a / 2);
  }

 private:
  Quad within(double value, double error) {
    return Quad(value) + Quad(random_.sign() * random_.uniform(0.9, 1)) * Quad(error);
  }
  Quad form(Eigen::Index number, const QuadVector& y) const {
    const auto i = static_cast<std::size_t>(number);
    Quad sum = numbers_[i][0];
    for (std::size_t k = 0; k < equations_.forms[i].terms.size(); ++k)
      sum += numbers_[i][k + 1] * y[static_cast<std::size_t>(equations_.forms[i].terms[k].coordinate)];
    return sum;
  }

  const PathEquations& equations_;
  const std::vector<EnclosedLength>& lengths_;
  RandomNumbers random_;
  std::vector<QuadVector> numbers_;
  std::vector<std::array<Quad, 3>> ends_;
};

QuadVector at(const ArcSeries& arc, Quad s) {
  const Eigen::MatrixXd& c = arc.coefficients();
  QuadVector y(static_cast<std::size_t>(c.rows()), 0);
  for (Eigen::Index j = 0; j < c.rows(); ++j)
    for (Eigen::Index n = c.cols() - 1; n >= 0; --n)
      y[static_cast<std::size_t>(j)] = y[static_cast<std::size_t>(j)] * s + c(j, n);
  return y;
}

QuadVector in_quad(const Eigen::VectorXd& y) { return {y.begin(), y.end()}; }

std::vector<ProblemStatement> problems() {
  std::vector<ProblemStatement> result = sample_scenes(51);
  RandomNumbers random(52);
  result.push_back(sketched_points_and_lines(random));
  result.push_back(corner_of_lines(60, 40, 80));
  result.push_back(point_at_an_angle(50));
  result.back().sketch = Figure{random.points(2, 4, 1), {}};
  result.back().interpolation.bends = {{0, {0.5}}, {3, {0.25}}};
  return result;
}

/// So large that it outweighs all rounding, so small that tubes are proven.
constexpr double large_error = 1e-10;

}  // namespace

TEST_CASE("the file's decimals are within the enclosed numbers of equations, which are no doubles") {
  RandomNumbers random(50);
  ProblemStatement problem = sketched(random_platform(2, random), random);
  for (RigidBody& body : problem.bodies)
    for (BodyElement& element : body.elements)
      for (Decimal& number : element.numbers) {
        const int thousandths = static_cast<int>(std::lround(1000 * number.value));
        number = {thousandths / 1000.0, std::to_string(thousandths) + "e-3"};
      }
  const GeneralStart start(problem);
  int checked = 0;
  for (const EnclosedForm& form : start.equations.forms)
    for (const EnclosedForm::Term& term : form.terms) {
      const double unit = std::ldexp(1.0, start.scene.unit_exponent());
      const Quad thousandths = std::round(1000 * unit * term.coefficient);
      if (term.error == 0) continue;
      ++checked;
      CHECK(magnitude(thousandths / 1000 - Quad(unit) * Quad(term.coefficient)) <=
            Quad(unit) * Quad(term.error));
      CHECK(term.error <= 2e-16 * std::abs(term.coefficient));
    }
  CHECK(checked >= 6);
}

TEST_CASE("the enclosed start meets the equations without a value, and its values are enclosed") {
  for (const ProblemStatement& problem : problems()) {
    CAPTURE(name_of(problem));
    const GeneralStart start(problem);
    REQUIRE(start.data.is_finite());
    CHECK(start.data.start.radius.maxCoeff() <= 1e-13);
    const ExactEquations exact(start.equations, start.data.lengths, 1);
    const QuadVector y = in_quad(start.data.start.mid);
    TubeSeries series(start.equations, start.data.lengths, order);
    series.expand(start.arc());
    const Eigen::VectorXd most = series.jacobian_sizes() * start.data.start.radius;
    for (Eigen::Index e = 0; e < start.equations.count; ++e) {
      const EnclosedLength& length = start.data.lengths[static_cast<std::size_t>(e)];
      const double a = std::abs(length.path.at_sketch);
      const double value_error = 2 * length.sketch_error * (length.is_plain ? 1 : a);
      // The coefficients of `exact` are themselves anywhere within their errors.
      const double coefficients = 1e-15 * (1 + a * a);
      CHECK(magnitude(exact.residual(e, y)) <= Quad(most[e] + value_error + coefficients));
    }
  }
}

TEST_CASE("values without incidences are enclosed as the sketch and the file's decimals have them") {
  ProblemStatement problem = with_orientation(octahedron());
  for (DistanceConstraint& c : problem.constraints) {
    const long thousandths = std::lround(1000 * c.given.value);
    c.given = {static_cast<double>(thousandths) / 1000, std::to_string(thousandths) + "e-3"};
  }
  const GeneralStart start(problem);
  REQUIRE(start.system.without_value().empty());
  CHECK(start.data.start.radius.maxCoeff() == 0);
  const double unit = std::ldexp(1.0, start.scene.unit_exponent());
  int inexact = 0;
  for (Eigen::Index e = 0; e < start.equations.count; ++e) {
    const EnclosedLength& length = start.data.lengths[static_cast<std::size_t>(e)];
    const Quad sum =
        ExactEquations(start.equations, start.data.lengths, 1).sum(e, in_quad(start.data.start.mid));
    const Quad low = Quad(length.path.at_sketch) - Quad(length.sketch_error),
               high = Quad(length.path.at_sketch) + Quad(length.sketch_error);
    const auto of_equation = [&](Quad a) { return length.is_plain ? a : a * a / 2; };
    CHECK(of_equation(low) <= sum);
    CHECK(of_equation(high) >= sum);
    CHECK(length.sketch_error <= 1e-15 * length.path.at_sketch);
    const Quad thousandths = std::round(1000 * unit * length.path.at_target);
    const Quad off = magnitude(thousandths / 1000 - Quad(unit) * Quad(length.path.at_target));
    CHECK(off <= Quad(unit) * Quad(length.target_error));
    inexact += off > 0 ? 1 : 0;
  }
  CHECK(inexact > 0);
}

TEST_CASE("bounds along a polynomial hold for samples of general equations, and are sharp") {
  std::uint64_t seed = 100;
  for (const ProblemStatement& problem : problems())
    for (const double error : {0.0, large_error}) {
      const GeneralStart start(problem, error);
      TubeSeries series(start.equations, start.data.lengths, order);
      const ArcSeries arc = start.arc();
      series.expand(arc);
      for (const double tolerance : {1e-12, 1e-7, 1e-3}) {
        TubeBounds bounds;
        const double h = arc.step_for(tolerance);
        series.bound(h, bounds);
        const ExactEquations exact(start.equations, start.data.lengths, ++seed);
        for (Eigen::Index e = 0; e < series.count(); ++e) {
          CAPTURE(name_of(problem), error, h, e);
          Quad largest = 0, before = exact.residual(e, at(arc, -Quad(h)));
          for (int i = -8; i <= 8; ++i) {
            const Quad f = exact.residual(e, at(arc, Quad(h) * i / 8));
            CHECK(magnitude(f) <= Quad(bounds.residual[e]));
            CHECK(magnitude(f - before) <= Quad(bounds.residual_speed[e]) * Quad(h) / 8);
            largest = std::max(largest, magnitude(f));
            before = f;
          }
          if (error == 0) CHECK(Quad(bounds.residual[e]) <= 64 * largest + Quad(1e-11));
        }
      }
    }
}

TEST_CASE(
    "an enclosed point of a general arc is one of the curve, whatever the numbers within their errors") {
  std::uint64_t seed = 200;
  for (const ProblemStatement& problem : problems())
    for (const double error : {0.0, large_error}) {
      const GeneralStart start(problem, error);
      PathTube tube(start.equations, start.data.lengths, order);
      const ArcSeries arc = start.arc();
      REQUIRE(tube.expand(arc));
      double h = arc.step_for(1e-7);
      while (h > 1e-6 && !tube.prove(h, Eigen::ArrayXd::Zero(start.equations.count))) h /= 2;
      CAPTURE(name_of(problem), error, h);
      REQUIRE(h > 1e-6);
      GeneralFamily family = start.family;
      Eigen::MatrixXd jacobian(start.equations.count, start.equations.count + 1);
      for (const double part : {-0.9, -0.3, 0.5, 0.9}) {
        const ArcPoint found = tube.at(part * h);
        const ExactEquations exact(start.equations, start.data.lengths, ++seed);
        const Eigen::VectorXd& y = found.point.mid;
        Eigen::VectorXd f(start.equations.count);
        for (Eigen::Index e = 0; e < f.size(); ++e) f[e] = static_cast<double>(exact.residual(e, in_quad(y)));
        family.jacobian(y, jacobian);
        // One step of Newton's method at the same t is exact to its square.
        const Eigen::VectorXd move = jacobian.leftCols(f.size()).partialPivLu().solve(f);
        const Eigen::VectorXd radius = found.hull().radius,
                              slope = found.tangent.mid / found.tangent.mid[f.size()];
        for (Eigen::Index i = 0; i < f.size(); ++i)
          CHECK(std::abs(move[i]) <= (radius[i] + radius[f.size()] * std::abs(slope[i])) * 1.001 + 1e-17);
        CHECK(radius.maxCoeff() <= (error == 0 ? 1e-9 : 1e-4));
      }
    }
}
