#include "solvers/certification/path_tube.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Of a sum of few floating-point products, relative to their sizes.
constexpr double few_roundings = 16 * epsilon;

/// A wider tube is proven as easily, as long as its width changes J little, and the next point of the chain
/// is well inside.
constexpr double least_radius = 0x1p-38;  ///< relative to the terms of the equation
constexpr double width = 4;               ///< relative to the residual

constexpr double largest_contraction = 0.9;

}  // namespace

PathTube::PathTube(const DistanceSystem& system, std::vector<EnclosedLength> lengths, int order)
    : series_(system, std::move(lengths), order) {}

bool PathTube::expand(const ArcSeries& c) {
  series_.expand(c);
  if (!set_section(series_.jacobian(), c.coefficient(1), section_)) return false;
  set_matrices();
  return true;
}

void PathTube::set_matrices() {
  const int m = series_.edges(), n = series_.coordinates();
  Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(m, n + 1);
  padded.leftCols(n) = section_.rows;
  differences_.resize(m, series_.axes() * m);
  std::array<Eigen::MatrixXd*, 3> orders{&defect_, &turn_, &bend_};
  for (int k = 0; k < 3; ++k) {
    orders[k]->resize(m, m);
    for (int e = 0; e < m; ++e) orders[k]->col(e) = -series_.pull(e, k) * padded.col(n - 1);
  }
  for (int axis = 0; axis < series_.axes(); ++axis)
    for (int e = 0; e < m; ++e) {
      const auto [i, j] = series_.ends(axis, e);
      auto difference = differences_.col(axis * m + e);
      difference = padded.col(i) - padded.col(j);
      for (int k = 0; k < 3; ++k) orders[k]->col(e) += series_.coefficient(axis, e, k) * difference;
    }
  defect_.diagonal().array() -= 1;
  for (Eigen::MatrixXd* matrix : orders) *matrix = matrix->cwiseAbs().eval();
  differences_ = differences_.cwiseAbs().eval();
  row_sizes_ = section_.rows.cwiseAbs();
}

double PathTube::promising_half_length() const {
  Eigen::VectorXd v = Eigen::VectorXd::Ones(series_.edges());
  double growth = 0;
  for (int i = 0; i < 4; ++i) {
    const Eigen::VectorXd next = turn_.transpose() * v;
    growth = next.maxCoeff();
    if (!(growth > 0)) break;
    // Entries that nothing feeds must not vanish.
    v = (next / growth).cwiseMax(0x1p-10);
  }
  return growth > 0 ? 0.5 / growth : std::numeric_limits<double>::infinity();
}

/// What each unit of |P_i − P_j| v and of |P_t| v moves in (I − J P) for a v of this size.
void PathTube::set_weights(const Eigen::ArrayXd& v) {
  const Eigen::Index m = series_.edges(), axes = series_.axes();
  const Eigen::ArrayXd reach = (differences_.transpose() * v.matrix()).array();
  const double time = row_sizes_.col(row_sizes_.cols() - 1).dot(v.matrix());
  axis_weights_ = bounds_.rest.head(axes * m) + reach + few_roundings * bounds_.size.head(axes * m);
  time_weights_.resize(m);
  for (Eigen::Index e = 0; e < m; ++e) {
    const double slope_move = 2 * std::abs(series_.lengths()[static_cast<std::size_t>(e)].path.bend) * time;
    const double slope = bounds_.slope[e] + slope_move, move = slope * time;
    const double length = bounds_.size[axes * m + e] + bounds_.length_error[e] + move;
    time_weights_[e] = bounds_.pull_rest[e] + slope * (bounds_.length_error[e] + move) +
                       length * (bounds_.slope_error[e] + slope_move) + few_roundings * slope * length;
  }
}

/// A bound on (I − J P) v over the tube of the last weights.
Eigen::ArrayXd PathTube::moved(const Eigen::ArrayXd& v) const {
  const Eigen::Index m = series_.edges();
  const Eigen::VectorXd x = v.matrix();
  Eigen::ArrayXd sum = (defect_.transpose() * x).array() + bounds_.h * (turn_.transpose() * x).array() +
                       bounds_.h * bounds_.h * (bend_.transpose() * x).array();
  const Eigen::ArrayXd reach = axis_weights_ * (differences_.transpose() * x).array();
  for (int axis = 0; axis < series_.axes(); ++axis) sum += reach.segment(axis * m, m);
  return (sum + time_weights_ * row_sizes_.col(row_sizes_.cols() - 1).dot(x)) * round_up;
}

Eigen::ArrayXd PathTube::room_for(const PointBox& box) const {
  const auto direction = series_.curve().coefficient(1);
  const double along = section_.normal.cwiseAbs().dot(box.radius) / section_.normal.dot(direction);
  return (section_.jacobian.cwiseAbs() * (box.radius + along * direction.cwiseAbs())).array();
}

bool PathTube::prove(double h, const Eigen::ArrayXd& room) {
  series_.bound(h, bounds_);
  const Eigen::MatrixXd sizes = series_.curve().coefficients().cwiseAbs();
  coordinate_size_ = coordinate_speed_ = coordinate_turn_ = Eigen::VectorXd::Zero(sizes.rows());
  double power = 1;
  for (Eigen::Index n = 0; n < sizes.cols(); ++n, power *= h) {
    const auto k = static_cast<double>(n);
    coordinate_size_ += power * sizes.col(n);
    coordinate_speed_ += k * power / h * sizes.col(n);
    coordinate_turn_ += k * (k - 1) * power / (h * h) * sizes.col(n);
  }
  set_progress();
  return progress_ > 0 && contracts(room);
}

/// ν·c'(s) ≥ ν·c_1 − Σ_{n ≥ 2} n |ν·c_n| h^(n−1)
void PathTube::set_progress() {
  const Eigen::VectorXd along = series_.curve().coefficients().transpose() * section_.normal;
  double rest = 0, power = bounds_.h;
  for (Eigen::Index n = 2; n < along.size(); ++n, power *= bounds_.h)
    rest += static_cast<double>(n) * std::abs(along[n]) * power;
  const double rounding = static_cast<double>(along.size() + section_.normal.size()) * epsilon *
                          section_.normal.cwiseAbs().dot(coordinate_speed_);
  progress_ = (along[1] - rest * round_up) * (1 - few_roundings) - rounding;
}

/// Finds r with |F(s, 0)| + |(I − J P) r| < r by iterating its fixed point, widened.
bool PathTube::contracts(const Eigen::ArrayXd& room) {
  constexpr int rounds = 12;
  const Eigen::Index m = series_.edges();
  Eigen::ArrayXd terms = Eigen::ArrayXd::Zero(m);
  for (int axis = 0; axis <= series_.axes(); ++axis) terms += bounds_.size.segment(axis * m, m).square();
  const Eigen::ArrayXd target = width * (bounds_.residual + room) + least_radius * terms;
  radius_ = 2 * target;
  for (int i = 0; i < rounds; ++i) {
    set_weights(radius_);
    const double time_reach = row_sizes_.col(row_sizes_.cols() - 1).dot(radius_.matrix());
    if (!(time_reach <= 0.5)) return false;
    const Eigen::ArrayXd move = moved(radius_);
    contraction_ = ratio(move);
    if (contraction_ <= largest_contraction &&
        (radius_ - (move + bounds_.residual) * round_up).minCoeff() > 0) {
      sharpen();
      return true;
    }
    radius_ = 1.1 * (target + move);
  }
  return false;
}

/// A bound on every v in V with |v| ≤ push + |(I − J P) v|.
Eigen::ArrayXd PathTube::fixed_point(const Eigen::ArrayXd& push) const {
  constexpr int rounds = 4;
  Eigen::ArrayXd v = radius_ * std::min(1.0, ratio(push) / (1 - contraction_) * round_up);
  for (int i = 0; i < rounds; ++i) v = v.min((push + moved(v)) * round_up);
  return v;
}

void PathTube::sharpen() {
  const Eigen::Index last = row_sizes_.cols() - 1;
  inner_radius_ = fixed_point(bounds_.residual);
  set_start_defect();
  set_speed();
  time_radius_ = row_sizes_.col(last).dot(inner_radius_.matrix()) * round_up;
  time_speed_radius_ = row_sizes_.col(last).dot(speed_.matrix()) * round_up;
}

void PathTube::set_start_defect() {
  const Eigen::Index m = series_.edges(), axes = series_.axes();
  const Eigen::ArrayXd reach = (differences_.transpose() * radius_.matrix()).array();
  Eigen::ArrayXd terms = bounds_.slope * (bounds_.size.tail(m) + bounds_.length_error) *
                         row_sizes_.col(row_sizes_.cols() - 1).dot(radius_.matrix());
  for (Eigen::Index axis = 0; axis < axes; ++axis)
    terms += bounds_.size.segment(axis * m, m) * reach.segment(axis * m, m);
  start_defect_ = ratio((defect_.transpose() * radius_.matrix()).array() + few_roundings * terms);
}

/// v' = −(∂F/∂v)⁻¹ ∂F/∂s, where ∂F/∂s(s, v) − ∂F/∂s(s, 0) = (J(c + P v) − J(c)) c'.
void PathTube::set_speed() {
  const Eigen::Index m = series_.edges(), axes = series_.axes();
  const Eigen::ArrayXd reach = (differences_.transpose() * inner_radius_.matrix()).array();
  const double time = row_sizes_.col(row_sizes_.cols() - 1).dot(inner_radius_.matrix());
  Eigen::ArrayXd push = bounds_.residual_speed;
  for (Eigen::Index axis = 0; axis < axes; ++axis)
    push += reach.segment(axis * m, m) * bounds_.speed.segment(axis * m, m);
  for (Eigen::Index e = 0; e < m; ++e) {
    const double slope_move = 2 * std::abs(series_.lengths()[static_cast<std::size_t>(e)].path.bend) * time;
    const double slope = bounds_.slope[e] + slope_move, move = slope * time;
    const double length = bounds_.size[axes * m + e] + bounds_.length_error[e] + move;
    push[e] += (slope * move + length * slope_move) * bounds_.time_speed;
  }
  speed_ = radius_ * (ratio(push) / (1 - contraction_) * round_up);
}

Eigen::VectorXd PathTube::polynomial_error() const {
  return static_cast<double>(2 * series_.curve().order() + 4) * epsilon * coordinate_size_;
}

Eigen::VectorXd PathTube::radius() const {
  return row_sizes_.transpose() * inner_radius_.matrix() * round_up;
}

double PathTube::section_parameter(const Eigen::VectorXd& y) const {
  Eigen::VectorXd along = series_.curve().coefficients().transpose() * section_.normal;
  along[0] = section_.normal.dot(series_.curve().coefficient(0) - y);
  double s = 0;
  for (int i = 0; i < 12; ++i) {
    double value = 0, slope = 0;
    for (Eigen::Index n = along.size() - 1; n >= 0; --n) {
      slope = slope * s + value;
      value = value * s + along[n];
    }
    s = std::clamp(s - value / slope, -bounds_.h, bounds_.h);
  }
  return s;
}

/// ν·y = ν·c(s) fixes s; then v = J (y − c(s)) + (I − J P) v.
PlaceInTube PathTube::locate(const PointBox& box) const {
  const double s = section_parameter(box.mid);
  Eigen::VectorXd c;
  series_.curve().evaluate(s, c);
  const Eigen::VectorXd offset = box.mid - c,
                        error = box.radius + polynomial_error() + epsilon * offset.cwiseAbs();
  const Eigen::VectorXd normal = section_.normal.cwiseAbs();
  const double terms = static_cast<double>(offset.size() + 4);
  const double along = std::abs(section_.normal.dot(offset)),
               along_error = (normal.dot(error) + terms * epsilon * normal.dot(offset.cwiseAbs())) * round_up;
  const double spread = (along + along_error) / progress_ * round_up;
  PlaceInTube place{PlaceInTube::Kind::unknown, {s - spread, s + spread}};
  const bool at_end = std::abs(s) == bounds_.h;
  if (at_end && along > along_error) return {PlaceInTube::Kind::outside, {s, s}};
  if (!(place.s.low > -bounds_.h && place.s.high < bounds_.h)) return place;
  const Eigen::ArrayXd v = (section_.jacobian * offset).array().abs();
  const Eigen::ArrayXd v_error = (section_.jacobian.cwiseAbs() *
                                  (error + coordinate_speed_ * spread + terms * epsilon * offset.cwiseAbs()))
                                     .array() *
                                 round_up;
  if (((v + v_error) * round_up - radius_ * (1 - start_defect_)).maxCoeff() < 0)
    place.kind = PlaceInTube::Kind::inside;
  else if ((v - v_error - radius_ * (1 + start_defect_) * round_up).maxCoeff() > 0)
    place.kind = PlaceInTube::Kind::outside;
  return place;
}

void PathTube::residual(const Eigen::VectorXd& y, const Eigen::VectorXd& error, Eigen::ArrayXd& f,
                        Eigen::ArrayXd& f_error) const {
  const Eigen::Index m = series_.edges(), time = y.size() - 1;
  for (Eigen::Index e = 0; e < m; ++e) {
    const int edge = static_cast<int>(e);
    const double a = series_.lengths()[static_cast<std::size_t>(e)].path.value(y[time]);
    const double a_error = bounds_.value_error[e] + bounds_.slope[e] * error[time];
    double sum = -a * a, size = a * a;
    f_error[e] = (std::abs(a) + a_error) * a_error;
    for (int axis = 0; axis < series_.axes(); ++axis) {
      const auto [i, j] = series_.ends(axis, edge);
      const double difference = (i <= time ? y[i] : 0) - (j <= time ? y[j] : 0);
      const double moved = (i <= time ? error[i] : 0) + (j <= time ? error[j] : 0);
      sum += difference * difference;
      size += difference * difference;
      f_error[e] += (std::abs(difference) + moved) * moved;
    }
    f[e] = sum / 2;
    f_error[e] = (f_error[e] + few_roundings * size) * round_up;
  }
}

Eigen::MatrixXd PathTube::section_jacobian(const Eigen::VectorXd& y) const {
  const Eigen::Index m = series_.edges(), time = y.size() - 1;
  Eigen::MatrixXd transposed(m, m);
  for (Eigen::Index e = 0; e < m; ++e) {
    const LengthPath& path = series_.lengths()[static_cast<std::size_t>(e)].path;
    transposed.col(e) = -path.value(y[time]) * path.slope(y[time]) * section_.rows.col(time);
    for (int axis = 0; axis < series_.axes(); ++axis) {
      const auto [i, j] = series_.ends(axis, static_cast<int>(e));
      const double difference = (i <= time ? y[i] : 0) - (j <= time ? y[j] : 0);
      if (i <= time) transposed.col(e) += difference * section_.rows.col(i);
      if (j <= time) transposed.col(e) -= difference * section_.rows.col(j);
    }
  }
  return transposed.transpose();
}

ArcPoint PathTube::at(double s) const {
  constexpr int rounds = 8;
  Eigen::VectorXd c, v = Eigen::VectorXd::Zero(series_.edges());
  series_.curve().evaluate(s, c);
  Eigen::VectorXd y = c, error = polynomial_error();
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(section_jacobian(c));
  Eigen::ArrayXd f(v.size()), f_error(v.size());
  for (int i = 0; i < rounds; ++i) {
    residual(y, error, f, f_error);
    if ((f.abs() <= f_error).all()) break;
    v = (v - lu.solve(f.matrix())).cwiseMax(-radius_.matrix()).cwiseMin(radius_.matrix());
    y = c + section_.rows.transpose() * v;
  }
  const double terms = static_cast<double>(v.size() + 4) * epsilon;
  error += terms * (row_sizes_.transpose() * v.cwiseAbs());
  residual(y, error, f, f_error);
  const Eigen::VectorXd left = fixed_point(f.abs() + f_error).matrix();
  return {{y, (error + row_sizes_.transpose() * left) * round_up}, tangent({s, s})};
}

PointBox PathTube::tangent(const ParameterRange& range) const {
  const double s = (range.low + range.high) / 2;
  const Eigen::MatrixXd& c = series_.curve().coefficients();
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(c.rows());
  for (Eigen::Index n = c.cols() - 1; n >= 1; --n)
    direction = direction * s + static_cast<double>(n) * c.col(n);
  const Eigen::VectorXd rounding = static_cast<double>(2 * c.cols() + 4) * epsilon * coordinate_speed_;
  return {direction, (row_sizes_.transpose() * speed_.matrix() + rounding +
                      (range.high - range.low) * coordinate_turn_) *
                         round_up};
}

}  // namespace gcs
