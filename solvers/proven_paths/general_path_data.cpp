#include "solvers/proven_paths/general_path_data.hpp"

#include <Eigen/QR>
#include <complex>
#include <limits>
#include <optional>

#include "solvers/model/ball_krawczyk.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

constexpr slong path_bits = 128;

/// Columns that span what is normal to the rows of the equations' Jacobian at x.
Eigen::MatrixXd directions_along(const QuadraticSystem& system, const std::vector<int>& equations,
                                 const Eigen::VectorXd& x) {
  const Eigen::Index unknowns = x.size(), count = static_cast<Eigen::Index>(equations.size());
  Eigen::MatrixXd jacobian(unknowns, unknowns);
  real_equations(system).jacobian(x, jacobian);
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

/// x̂, at which the equations numbered `met` are; nothing where it is not proven.
std::optional<BallMatrix> exact_start(const QuadraticSystem& system, const std::vector<int>& met,
                                      const Eigen::VectorXd& sketched) {
  const BallMatrix near = BallKrawczyk::vector({sketched.begin(), sketched.end()});
  if (met.empty()) return near;
  QuadraticSystem start{system.unknowns, {}, {}};
  for (const int e : met) start.equations.push_back(system.equations[static_cast<std::size_t>(e)]);
  const Eigen::MatrixXd directions = directions_along(system, met, sketched);
  for (Eigen::Index i = 0; i < directions.cols(); ++i)
    start.equations.push_back(plane_through(sketched, directions.col(i)));
  const BallKrawczyk krawczyk(start, path_bits);
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
  acb_sub(difference, number, difference, path_bits);
  return magnitude(difference);
}

/// What the sums of all equations are at x, of a form that takes the place of its square that form with its sign.
BallMatrix sums_at(const SceneSystem& system, const std::vector<TravellingValue>& values,
                   const BallMatrix& x) {
  QuadraticSystem sums = system.equations();
  for (std::size_t e = 0; e < values.size(); ++e) {
    sums.equations[e].given = {};
    if (values[e].root_sign != 0) sums.equations[e].products[0].right = {{}, exactly(values[e].root_sign)};
  }
  return BallKrawczyk(sums, path_bits).value(x);
}

void enclose_start(const BallMatrix& start, const Eigen::VectorXd& near, PointBox& box) {
  for (Eigen::Index i = 0; i < near.size(); ++i)
    box.radius[i] = error_of(start(static_cast<slong>(i), 0), near[i]);
}

/// At x and t = 0; the radii are infinite.
PathData unproven_data(const Eigen::VectorXd& x, std::size_t equations) {
  PathData data;
  data.start.mid.setZero(x.size() + 1);
  data.start.mid.head(x.size()) = x;
  data.start.radius.setConstant(x.size() + 1, std::numeric_limits<double>::infinity());
  data.lengths.resize(equations);
  return data;
}

/// Half a number, enclosed about its nearest double.
struct HalfNumber {
  double mid = 0, error = 0;

  explicit HalfNumber(acb_srcptr number)
      : mid(arf_get_d(arb_midref(acb_realref(number)), ARF_RND_NEAR) / 2),
        error(error_of(number, 2 * mid) / 2) {}
};

/// Infinite where the number may not be positive.
double error_of_root(acb_srcptr number, double rounded) {
  if (!arb_is_positive(acb_realref(number))) return std::numeric_limits<double>::infinity();
  Ball root;
  acb_sqrt(root, number, path_bits);
  return error_of(root, rounded);
}

}  // namespace

PathData enclose_path_data(const Scene& scene, const SceneSystem& system,
                           const std::vector<TravellingValue>& values, const Eigen::VectorXd& sketched) {
  const Eigen::Index unknowns = sketched.size();
  PathData data = unproven_data(sketched, values.size());
  const std::optional<BallMatrix> start = exact_start(system.equations(), system.without_value(), sketched);
  if (!start) return data;
  data.start.radius[unknowns] = 0;
  enclose_start(*start, sketched, data.start);
  const BallMatrix sums = sums_at(system, values, *start);
  Ball given;
  for (std::size_t e = 0; e < values.size(); ++e) {
    if (system.value_of()[e] < 0) continue;
    EnclosedLength& length = data.lengths[e];
    const auto& [path, is_plain, root_sign] = values[e];
    const acb_srcptr sum = sums(static_cast<slong>(e), 0);
    enclose(given, system.equations().equations[e].given, path_bits);
    length.path = path;
    length.is_plain = is_plain;
    length.sketch_error = is_plain ? error_of(sum, path.at_sketch) : error_of_root(sum, path.at_sketch);
    length.target_error =
        is_plain && root_sign == 0 ? error_of(given, path.at_target) : error_of_root(given, path.at_target);
    set_bend_errors(scene, length);
  }
  return data;
}

PathData enclose_released_data(const QuadraticSystem& equations, Eigen::Index released,
                               const Eigen::VectorXd& start) {
  PathData data = unproven_data(start, equations.equations.size());
  std::vector<int> met;
  for (int e = 0; e < static_cast<int>(equations.equations.size()); ++e)
    if (e != released) met.push_back(e);
  const std::optional<BallMatrix> exact = exact_start(equations, met, start);
  if (!exact) return data;
  data.start.radius[start.size()] = 0;
  enclose_start(*exact, start, data.start);
  QuadraticSystem sums = equations;
  for (QuadraticEquation& equation : sums.equations) equation.given = {};
  const BallMatrix at_start = BallKrawczyk(sums, path_bits).value(*exact);
  Ball given;
  for (std::size_t e = 0; e < equations.equations.size(); ++e) {
    EnclosedLength& value = data.lengths[e];
    enclose(given, equations.equations[e].given, path_bits);
    const HalfNumber target(given);
    const HalfNumber first(static_cast<Eigen::Index>(e) == released ? at_start(static_cast<slong>(e), 0)
                                                                    : static_cast<acb_srcptr>(given));
    value.is_plain = true;
    value.path = {first.mid, target.mid, 0};
    value.sketch_error = first.error;
    value.target_error = target.error;
  }
  return data;
}

}  // namespace gcs
