/// Equations evaluated with numbers that were rounded once, beside the terms as they are written.

#include "solvers/elements/dense_equations.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <complex>

#include "solvers/answers/settled_figure.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/numeric/rounding.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

ComplexValues random_values(int count, RandomNumbers& random) {
  ComplexValues x;
  for (int i = 0; i < count; ++i) {
    const double re = random.uniform(-1, 1), im = random.uniform(-1, 1);
    x.emplace_back(re, im);
  }
  return x;
}

/// Σ left·right − given, every number rounded where it stands.
std::complex<double> value_of(const QuadraticEquation& equation, const ComplexValues& x) {
  std::complex<double> sum = -rounded_to_double(equation.given);
  for (const FormProduct& product : equation.products)
    sum += value_at(product.left, x) * value_at(product.right, x);
  return sum;
}

void check_equations(const ProblemStatement& problem, RandomNumbers& random) {
  const Scene scene = Scene::unchecked(problem);
  const SceneSystem system(scene);
  const DenseEquations equations(system.equations());
  REQUIRE(equations.count() == static_cast<int>(system.equations().equations.size()));
  const ComplexValues x = random_values(equations.unknowns(), random);
  const ComplexValues change = random_values(equations.unknowns(), random);
  const EquationResiduals here = equations.residuals(x);
  // The equations are of degree two: a difference about x is the derivative.
  ComplexValues before = x, after = x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    before[i] -= change[i];
    after[i] += change[i];
  }
  const Eigen::VectorXcd slope =
      equations.jacobian(x) * Eigen::Map<const Eigen::VectorXcd>(change.data(), equations.unknowns());
  for (int e = 0; e < equations.count(); ++e) {
    const QuadraticEquation& equation = system.equations().equations[static_cast<std::size_t>(e)];
    CHECK(here.value[e] == value_of(equation, x));
    CHECK(here.size[e] >= std::abs(here.value[e]) * (1 - 1e-14));
    const std::complex<double> difference = (value_of(equation, after) - value_of(equation, before)) / 2.0;
    CHECK(std::abs(slope[e] - difference) <= 1e-12 * (1 + here.size[e] + std::abs(slope[e])));
  }
}

}  // namespace

TEST_CASE("equations with rounded numbers have the values of the terms as they are written") {
  RandomNumbers random(3);
  for (const int dimension : {2, 3}) check_equations(samples::random_platform(dimension, random), random);
  for (const int planes : {1, 2, 3}) check_equations(samples::random_octahedral(planes, random), random);
  check_equations(samples::point_at_an_angle(17), random);
}

TEST_CASE("solutions of a general scene are settled from a hundred roundings away and not from far") {
  RandomNumbers random(5);
  const Scene scene = Scene::unchecked(samples::random_platform(3, random));
  const Answer answer = solve(scene, Monodromy{.certify = true});
  REQUIRE(answer.solutions.size() == 40);
  const SceneSystem system(scene);
  const FigureSettler settler(system);
  for (const AssessedSolution& solution : answer.solutions) {
    const Figure figure = scene.in_frame(solution.figure);
    const auto off = [&](double roundings) {
      ComplexValues start = system.coordinates(figure);
      for (std::complex<double>& value : start)
        value += roundings * epsilon * solution.condition * random.uniform(-1, 1);
      const Figure settled = settler.settled(system.figure(start, figure.is_real()), solution.condition);
      return std::max((settled.points - figure.points).lpNorm<Eigen::Infinity>(),
                      (settled.imaginary - figure.imaginary).lpNorm<Eigen::Infinity>());
    };
    CHECK(off(100) <= 16 * epsilon * (1 + extent(figure)));
    CHECK(off(1e5) > 1e3 * epsilon * solution.condition);
  }
}
