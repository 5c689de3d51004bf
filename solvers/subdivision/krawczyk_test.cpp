#include "solvers/subdivision/krawczyk_test.hpp"

#include <Eigen/LU>
#include <limits>

namespace gcs {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double underflow = 0x1p-1000;  ///< above all that products lose below the smallest normal number

/// Of double-doubles: products and sums of a hundred terms are right to this, relative to the terms.
constexpr double fine_rounding = 0x1p-92;

/// Of the unknowns' size: a box around a solution needs room for what rounding leaves open of it.
constexpr double room = 0x1p-40;

constexpr int most_iterations = 12;

/// A form at a point, and the sum of its terms' sizes.
struct FormValue {
  DoubleDouble value;
  double size = 0;
};

FormValue value_at(const IntervalForm& form, const Eigen::VectorXd& x) {
  FormValue result{form.constant.value, std::abs(form.constant.value.hi)};
  for (const auto& [unknown, coefficient] : form.terms) {
    result.value = result.value + coefficient.value * DoubleDouble{x[unknown], 0};
    result.size += std::abs(coefficient.value.hi * x[unknown]);
  }
  return result;
}

std::vector<FormValue> values_at(const IntervalEquations& system, const Eigen::VectorXd& x) {
  std::vector<FormValue> result;
  for (const IntervalForm& form : system.forms) result.push_back(value_at(form, x));
  return result;
}

}  // namespace

LinearisedSystem<double> KrawczykTest::linearised(const Eigen::VectorXd& x) const {
  const Eigen::Index n = x.size();
  LinearisedSystem<double> f{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::MatrixXd::Zero(n, n)};
  const std::vector<FormValue> values = values_at(system_, x);
  for (Eigen::Index e = 0; e < n; ++e) {
    const IntervalEquation& equation = system_.equations[static_cast<std::size_t>(e)];
    DoubleDouble sum = -equation.given.value;
    double size = std::abs(sum.hi);
    for (const auto& [l, r] : equation.products) {
      const FormValue &left = values[static_cast<std::size_t>(l)],
                      &right = values[static_cast<std::size_t>(r)];
      sum = sum + left.value * right.value;
      size += left.size * right.size;
      for (const auto& [unknown, coefficient] : system_.forms[static_cast<std::size_t>(l)].terms)
        f.jacobian(e, unknown) += coefficient.value.hi * right.value.hi;
      for (const auto& [unknown, coefficient] : system_.forms[static_cast<std::size_t>(r)].terms)
        f.jacobian(e, unknown) += coefficient.value.hi * left.value.hi;
    }
    f.value[e] = sum.value();
    f.value_error[e] = epsilon * std::abs(f.value[e]) + fine_rounding * size + underflow;
  }
  return f;
}

/// How far the entries move within the box, and what the rounding of those at the middle is.
Eigen::MatrixXd KrawczykTest::jacobian_radius(const Eigen::VectorXd& x, const Eigen::VectorXd& radius) const {
  constexpr double rounding = 0x1p-44;  // of sums of up to a hundred terms, relative to these
  std::vector<double> moves;
  for (const IntervalForm& form : system_.forms) {
    double move = 0, size = std::abs(form.constant.value.hi);
    for (const auto& [unknown, coefficient] : form.terms) {
      const double c = std::abs(coefficient.value.hi);
      move += c * radius[unknown];
      size += c * std::abs(x[unknown]);
    }
    moves.push_back(move * (1 + rounding) + rounding * size + underflow);
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(radius.size(), radius.size());
  const auto add = [&](Eigen::Index e, int form, int other) {
    for (const auto& [unknown, coefficient] : system_.forms[static_cast<std::size_t>(form)].terms)
      result(e, unknown) +=
          std::abs(coefficient.value.hi) * moves[static_cast<std::size_t>(other)] * (1 + rounding);
  };
  for (Eigen::Index e = 0; e < radius.size(); ++e)
    for (const auto& [left, right] : system_.equations[static_cast<std::size_t>(e)].products) {
      add(e, left, right);
      add(e, right, left);
    }
  return result * (1 + rounding);
}

std::optional<KrawczykImage<double>> KrawczykTest::image(const Box& box) const {
  const LinearisedSystem<double> f = linearised(box.mid);
  const Eigen::MatrixXd inverse = f.jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return std::nullopt;
  return krawczyk_image(inverse, f, jacobian_radius(box.mid, box.radius), box.radius);
}

bool KrawczykTest::refine(Eigen::VectorXd& x, std::int64_t& iterations) const {
  double previous = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_iterations; ++i) {
    const LinearisedSystem<double> f = linearised(x);
    const Eigen::VectorXd correction = f.jacobian.partialPivLu().solve(f.value);
    const double length = correction.cwiseAbs().maxCoeff();
    ++iterations;
    if (!std::isfinite(length)) return false;
    x -= correction;
    if (length <= 4 * epsilon * size_) return true;
    if (length > previous / 2) return length <= room * size_;  // rounding alone is left
    previous = length;
  }
  return false;
}

/// The image of a box holds all of its solutions.
Box KrawczykTest::tightened(Box box) const {
  constexpr double worth_another = 0.95;
  constexpr int most_images = 40;
  for (int i = 0; i < most_images; ++i) {
    const auto now = image(box);
    if (!now) return box;
    const Eigen::VectorXd reach = now->reach().cwiseMin(box.radius);
    const bool is_last = reach.maxCoeff() > worth_another * box.radius.maxCoeff();
    box.radius = reach;
    if (is_last) return box;
  }
  return box;
}

std::optional<ProvenSolution> KrawczykTest::only_solution_around(const Box& box,
                                                                 std::int64_t& iterations) const {
  Eigen::VectorXd x = box.mid;
  if (!refine(x, iterations)) return std::nullopt;
  const Eigen::VectorXd around =
      ((box.radius + (x - box.mid).cwiseAbs()) * (1 + 4 * epsilon)).cwiseMax(room * size_);
  const auto now = image({x, around});
  if (!now || !now->is_inside(around)) return std::nullopt;
  return ProvenSolution{tightened({x, around}), around};
}

}  // namespace gcs
