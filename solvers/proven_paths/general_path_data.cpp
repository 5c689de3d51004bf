#include "solvers/proven_paths/general_path_data.hpp"

#include <Eigen/QR>
#include <complex>
#include <limits>
#include <optional>

#include "solvers/certificates/ball_krawczyk.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

constexpr slong bits = 128;

/// Columns that span what is normal to the rows of the equations' Jacobian at x.
Eigen::MatrixXd directions_along(const SceneSystem& system, const std::vector<int>& equations,
                                 const Eigen::VectorXd& x) {
  const Eigen::Index unknowns = x.size(), count = static_cast<Eigen::Index>(equations.size());
  Eigen::MatrixXd jacobian(unknowns, unknowns);
  real_equations(system.equations()).jacobian(x, jacobian);
  const Eigen::MatrixXd rows = jacobian(equations, Eigen::all);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows.transpose());
  const Eigen::MatrixXd all = qr.householderQ() * Eigen::MatrixXd::Identity(unknowns, unknowns);
  return all.rightCols(unknowns - count);
}

/// direction·(x − at) = 0
QuadraticEquation plane_through(const Eigen::VectorXd& at, const Eigen::VectorXd& direction) {
  QuadraticEquation equation;
  for (Eigen::Index i = 0; i < at.size(); ++i)
    equation.products.push_back({{{{static_cast<int>(i)}}, exactly(-at[i])}, {{}, exactly(direction[i])}});
  return equation;
}

/// x̂; nothing where it is not proven.
std::optional<BallMatrix> exact_start(const SceneSystem& system, const Eigen::VectorXd& sketched) {
  const BallMatrix near = BallKrawczyk::vector({sketched.begin(), sketched.end()});
  const std::vector<int> without_value = system.without_value();
  if (without_value.empty()) return near;
  QuadraticSystem start{system.equations().unknowns, {}, {}};
  for (const int e : without_value)
    start.equations.push_back(system.equations().equations[static_cast<std::size_t>(e)]);
  const Eigen::MatrixXd directions = directions_along(system, without_value, sketched);
  for (Eigen::Index i = 0; i < directions.cols(); ++i)
    start.equations.push_back(plane_through(sketched, directions.col(i)));
  const BallKrawczyk krawczyk(start, bits);
  const BallKrawczyk::Newton newton = krawczyk.refined(near);
  if (!newton.converged) return std::nullopt;
  auto proof = krawczyk.prove(newton.x);
  if (!proof) return std::nullopt;
  return std::move(proof->solution);
}

/// At most |number − rounded|.
double error_of(acb_srcptr number, double rounded) {
  Ball difference;
  acb_set_d(difference, rounded);
  acb_sub(difference, number, difference, bits);
  return magnitude(difference);
}

/// What the sums of all equations are at x.
BallMatrix sums_at(const SceneSystem& system, const BallMatrix& x) {
  QuadraticSystem sums = system.equations();
  for (QuadraticEquation& equation : sums.equations) equation.given = {};
  return BallKrawczyk(sums, bits).value(x);
}

/// Of the value that an equation's sum gives; infinite where it may be the root of 0.
double error_of_value(acb_srcptr sum, double value, bool is_root) {
  if (!is_root) return error_of(sum, value);
  if (!arb_is_positive(acb_realref(sum))) return std::numeric_limits<double>::infinity();
  Ball root;
  acb_sqrt(root, sum, bits);
  return error_of(root, value);
}

}  // namespace

PathData enclose_path_data(const Scene& scene, const SceneSystem& system,
                           const std::vector<TravellingValue>& values, const Eigen::VectorXd& sketched) {
  const Eigen::Index unknowns = sketched.size();
  PathData data;
  data.start.mid.setZero(unknowns + 1);
  data.start.mid.head(unknowns) = sketched;
  data.start.radius.setZero(unknowns + 1);
  const std::optional<BallMatrix> start = exact_start(system, sketched);
  if (!start) {
    data.start.radius.setConstant(std::numeric_limits<double>::infinity());
    return data;
  }
  for (Eigen::Index i = 0; i < unknowns; ++i)
    data.start.radius[i] = error_of((*start)(static_cast<slong>(i), 0), sketched[i]);
  const BallMatrix sums = sums_at(system, *start);
  for (std::size_t e = 0; e < values.size(); ++e) {
    const int number = system.value_of()[e];
    EnclosedLength& length = data.lengths.emplace_back();
    if (number < 0) continue;
    const TravellingValue& value = values[e];
    const bool is_root = !value.is_plain || value.root_sign != 0;
    Ball given;
    enclose(given, system.equations().equations[e].given, bits);
    length = {value.path, error_of_value(sums(static_cast<slong>(e), 0), value.path.at_sketch, is_root),
              error_of_value(given, value.path.at_target, is_root)};
    set_bend_errors(scene, length);
    length.is_plain = value.is_plain;
  }
  return data;
}

}  // namespace gcs
