#include "solvers/tracking/general_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

/// Whether the file states the square of value `number`.
bool is_stated_squared(const ProblemStatement& problem, int number) {
  const auto i = static_cast<std::size_t>(number);
  if (i < problem.constraints.size()) return problem.constraints[i].is_squared;
  return problem.relations[i - problem.constraints.size()].form == Relation::Form::squared;
}

/// Straight from what the sums are at the sketch, but for bends.
std::vector<TravellingValue> travelling_values(const Scene& scene, const SceneSystem& system,
                                               const RealEquations& equations, const Eigen::VectorXd& x) {
  const Eigen::VectorXd sums = equations.sums(x);
  std::vector<TravellingValue> values(static_cast<std::size_t>(equations.count()));
  for (Eigen::Index e = 0; e < equations.count(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const int number = system.value_of()[i];
    if (number < 0) continue;
    TravellingValue& value = values[i];
    value.is_plain =
        !system.equations().equations[i].given.is_squared && !is_stated_squared(scene.problem(), number);
    if (number < scene.constraint_count())
      value.path = scene.length_paths()[static_cast<std::size_t>(number)];
    const auto travelling = [&](double sum) { return value.is_plain ? sum : std::sqrt(std::max(0.0, sum)); };
    value.path.at_sketch = travelling(sums[e]);
    value.path.at_target = travelling(equations.given[e]);
  }
  return values;
}

std::vector<LengthPath> paths_of(const std::vector<TravellingValue>& values) {
  std::vector<LengthPath> paths;
  for (const TravellingValue& value : values) paths.push_back(value.path);
  return paths;
}

}  // namespace

GeneralFamily::GeneralFamily(const Scene& scene, const SceneSystem& system, Eigen::VectorXd sketched,
                             int order)
    : equations_(real_equations(system.equations())),
      values_(travelling_values(scene, system, equations_, sketched)),
      series_of_values_({}, order),
      sketched_(std::move(sketched)),
      signs_(system.equations().mirror),
      turnings_(generators_of(signs_) & ~(first_turning - 1)) {
  for (Eigen::Index e = 0; e < equations_.count(); ++e) {
    if (system.value_of()[static_cast<std::size_t>(e)] >= 0) equations_.given[e] = 0;
    take_root(e);
  }
  for (RealEquations::Product& product : equations_.products) {
    if (values_[static_cast<std::size_t>(product.equation)].is_plain) continue;
    for (auto& [unknown, coefficient] : product.left.terms) coefficient /= 2;
    product.left.constant /= 2;
  }
  std::vector<bool> plain;
  for (const TravellingValue& value : values_) plain.push_back(value.is_plain);
  series_of_values_ = LengthSeries(paths_of(values_), plain, order);
  const auto products = static_cast<Eigen::Index>(equations_.products.size());
  left_.setZero(products, order + 1);
  right_.setZero(products, order + 1);
}

/// Of an equation that is the square of one form: that form takes its place, with the sign that it has.
void GeneralFamily::take_root(Eigen::Index equation) {
  TravellingValue& value = values_[static_cast<std::size_t>(equation)];
  const auto is_in = [equation](const RealEquations::Product& p) { return p.equation == equation; };
  auto& products = equations_.products;
  if (value.is_plain || std::ranges::count_if(products, is_in) != 1) return;
  RealEquations::Product& product = *std::ranges::find_if(products, is_in);
  if (product.left != product.right) return;
  value.root_sign = product.left.at(sketched_) < 0 ? -1 : 1;
  product.right = {{}, value.root_sign};
  value.is_plain = true;
}

/// What the sums of an equation are to be at t.
double GeneralFamily::side(Eigen::Index equation, double t) const {
  const TravellingValue& value = values_[static_cast<std::size_t>(equation)];
  const double at = value.path.value(t);
  return equations_.given[equation] + (value.is_plain ? at : at * at / 2);
}

void GeneralFamily::residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f) {
  f = equations_.sums(y.head(unknowns()));
  for (Eigen::Index e = 0; e < f.size(); ++e) f[e] -= side(e, y[unknowns()]);
}

void GeneralFamily::wide_residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f) {
  const std::vector<DoubleDouble> sums = equations_.wide_sums(y);
  for (std::size_t e = 0; e < sums.size(); ++e) {
    const DoubleDouble value = values_[e].path.wide_value(y[unknowns()]);
    const DoubleDouble side = values_[e].is_plain ? value : value * value * DoubleDouble{0.5};
    const auto equation = static_cast<Eigen::Index>(e);
    f[equation] = (sums[e] - side - DoubleDouble{equations_.given[equation]}).value();
  }
}

void GeneralFamily::jacobian(const Eigen::VectorXd& y, Eigen::MatrixXd& matrix) {
  const double t = y[unknowns()];
  equations_.jacobian(y, matrix);
  for (Eigen::Index e = 0; e < equations_.count(); ++e) {
    const TravellingValue& value = values_[static_cast<std::size_t>(e)];
    matrix(e, unknowns()) = -value.path.slope(t) * (value.is_plain ? 1 : value.path.value(t));
  }
}

void GeneralFamily::start_series(double t) { series_of_values_.start(t); }

void GeneralFamily::set(int n, const Eigen::Ref<const Eigen::VectorXd>& coefficient) {
  series_of_values_.set(n, coefficient[unknowns()]);
  for (Eigen::Index p = 0; p < left_.rows(); ++p) {
    const RealEquations::Product& product = equations_.products[static_cast<std::size_t>(p)];
    left_(p, n) = product.left.change(coefficient);
    right_(p, n) = product.right.change(coefficient);
  }
}

void GeneralFamily::known(int n, Eigen::Ref<Eigen::VectorXd> result) {
  series_of_values_.known(n, result);
  convolution_.setZero(left_.rows());
  for (int i = 1; i < n; ++i) convolution_.array() += left_.col(i).array() * right_.col(n - i).array();
  for (Eigen::Index p = 0; p < left_.rows(); ++p)
    result[equations_.products[static_cast<std::size_t>(p)].equation] -= convolution_[p];
}

double GeneralFamily::shortest_length(double t) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const TravellingValue& value : values_)
    if (!value.is_plain)
      shortest =
          std::min(shortest, value.path.value(t) / std::max(value.path.at_sketch, value.path.at_target));
  return shortest;
}

Eigen::VectorXd GeneralFamily::signs_towards(const Eigen::VectorXd& y0, const Eigen::VectorXd& y) const {
  return gcs::signs_towards(signs_, turnings_, y0, y);
}

}  // namespace gcs
