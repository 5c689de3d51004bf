#include "solvers/proven_paths/path_tube.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// Of a sum of few floating-point products, relative to their sizes.
constexpr double of_few_roundings = 16 * epsilon;

/// A wider tube is proven as easily, as long as its width changes J little, and the next point of the chain
/// is well inside.
constexpr double least_radius = 0x1p-38;  ///< relative to the terms of the equation
constexpr double width = 4;               ///< relative to the residual

constexpr double largest_contraction = 0.9;

/// How far t may be from that on c: the bounds on lengths hold up to 1.
constexpr double largest_time_reach = 0.5;

/// The transpose of J G for the J with these values of forms and derivatives −pull(e) by t; `transposed` is Gᵀ.
template <class Value, class Pull>
Eigen::MatrixXd jacobian_times(const TubeSeries& series, const Eigen::MatrixXd& transposed,
                               const Value& value_of, const Pull& pull) {
  Eigen::MatrixXd product(transposed.rows(), series.count());
  for (Eigen::Index e = 0; e < series.count(); ++e) product.col(e) = -pull(e) * transposed.rightCols<1>();
  for (const auto& [e, value, moved] : series.equations().pairs) {
    const double v = value_of(value);
    for (const EnclosedForm::Term& term : series.terms(moved))
      product.col(e) += v * term.coefficient * transposed.col(term.coordinate);
  }
  return product;
}

}  // namespace

PointBox ArcPoint::hull() const {
  PointBox box = point;
  box.radius = (box.radius + spread.cwiseAbs().colwise().sum().transpose()) * round_up;
  return box;
}

PathTube::PathTube(PathEquations equations, std::vector<EnclosedLength> lengths, int order)
    : series_(std::move(equations), std::move(lengths), order) {}

bool PathTube::expand(const ArcSeries& c) {
  series_.expand(c);
  if (!set_section(series_.jacobian(), c.coefficient(1), series_.has_differences(), section_)) return false;
  set_matrices();
  return true;
}

void PathTube::set_matrices() {
  const Eigen::Index m = series_.count();
  jacobian_sizes_ = series_.jacobian_sizes();
  row_sizes_ = section_.rows.cwiseAbs();
  set_differences();
  std::array<Eigen::MatrixXd*, 3> orders{&defect_, &turn_, &bend_};
  for (int k = 0; k < 3; ++k) {
    orders[k]->resize(m, m);
    for (Eigen::Index e = 0; e < m; ++e)
      orders[k]->col(e) = -series_.pull(e, k) * section_.rows.rightCols<1>();
  }
  for (const auto& [e, value, moved] : series_.equations().pairs)
    for (int k = 0; k < 3; ++k) orders[k]->col(e) += series_.coefficient(value, k) * differences_.col(moved);
  defect_.diagonal().array() -= 1;
  for (Eigen::MatrixXd* matrix : orders) *matrix = matrix->cwiseAbs().eval();
  differences_ = differences_.cwiseAbs().eval();
  if (!series_.has_differences()) differences_ += difference_errors_;
}

/// dD P, and bounds on its error; differences of rows of P are exact.
void PathTube::set_differences() {
  differences_.setZero(series_.count(), series_.forms());
  if (!series_.has_differences()) difference_errors_.setZero(series_.count(), series_.forms());
  for (Eigen::Index k = 0; k < series_.forms(); ++k)
    for (const EnclosedForm::Term& term : series_.terms(k)) {
      differences_.col(k) += term.coefficient * section_.rows.col(term.coordinate);
      if (!series_.has_differences())
        difference_errors_.col(k) += series_.coefficient_error(term) * row_sizes_.col(term.coordinate);
    }
}

double PathTube::promising_half_length() const {
  const Eigen::VectorXd scale = series_.equation_scales();
  Eigen::VectorXd v = scale;
  double growth = 0;
  for (int i = 0; i < 4; ++i) {
    const Eigen::VectorXd next = turn_.transpose() * v;
    growth = next.cwiseQuotient(scale).maxCoeff();
    if (!(growth > 0)) break;
    // Entries that nothing feeds must not vanish.
    v = (next / growth).cwiseMax(0x1p-10 * scale);
  }
  return growth > 0 ? 0.5 / growth : std::numeric_limits<double>::infinity();
}

/// What each unit of |dD P v| and of |P_t v| moves in (I − J P) for a v of this size.
void PathTube::set_weights(const Eigen::ArrayXd& v) {
  const Eigen::Index m = series_.count(), forms = series_.forms();
  const Eigen::ArrayXd reach = (differences_.transpose() * v.matrix()).array();
  const double time = row_sizes_.col(row_sizes_.cols() - 1).dot(v.matrix());
  form_weights_ = bounds_.rest.head(forms) + reach + series_.sum_rounding() * bounds_.size.head(forms);
  if (!series_.has_differences()) {
    form_weights_ += bounds_.form_error;
    error_weights_ = bounds_.size.head(forms) + bounds_.form_error + reach;
  }
  time_weights_.resize(m);
  for (Eigen::Index e = 0; e < m; ++e) {
    const double slope_move = bounds_.curvature[e] * time;
    const double slope = bounds_.slope[e] + slope_move, move = slope * time;
    if (is_plain(e)) {
      time_weights_[e] =
          bounds_.pull_rest[e] + bounds_.slope_error[e] + slope_move + series_.sum_rounding() * slope;
      continue;
    }
    const double length = bounds_.size[forms + e] + bounds_.length_error[e] + move;
    time_weights_[e] = bounds_.pull_rest[e] + slope * (bounds_.length_error[e] + move) +
                       length * (bounds_.slope_error[e] + slope_move) +
                       series_.sum_rounding() * slope * length;
  }
}

void PathTube::set_moves(const Eigen::ArrayXd& v) {
  set_weights(v);
  moves_ = defect_ + bounds_.h * turn_ + (bounds_.h * bounds_.h) * bend_;
  for (const auto& [e, value, moved] : series_.equations().pairs) {
    moves_.col(e) += form_weights_[value] * differences_.col(moved);
    if (!series_.has_differences()) moves_.col(e) += error_weights_[value] * difference_errors_.col(moved);
  }
  for (Eigen::Index e = 0; e < series_.count(); ++e)
    moves_.col(e) += time_weights_[e] * row_sizes_.rightCols<1>();
}

Eigen::ArrayXd PathTube::moved(const Eigen::ArrayXd& v) const {
  return (moves_.transpose() * v.matrix()).array() * round_up;
}

Eigen::MatrixXd PathTube::in_section(const Eigen::MatrixXd& spread) const {
  return jacobian_times(
      series_, spread, [this](Eigen::Index form) { return series_.coefficient(form, 0); },
      [this](Eigen::Index e) { return series_.pull(e, 0); });
}

Eigen::ArrayXd PathTube::room_for(const PointBox& box, const Eigen::MatrixXd& spread) const {
  return (jacobian_sizes_ * box.radius).array() +
         in_section(spread).cwiseAbs().colwise().sum().transpose().array();
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
  if (!(progress_ > 0 && contracts(room))) return false;
  bound_arc();
  return true;
}

void PathTube::bound_arc() {
  const Eigen::VectorXd time = row_sizes_.rightCols<1>();
  inner_radius_ = resolved(bounds_.residual).min(radius_);
  set_start_defect();
  set_speed();
  time_radius_ = time.dot(inner_radius_.matrix()) * round_up;
  time_speed_radius_ = time.dot(speed_.matrix()) * round_up;
}

/// ν·c'(s) ≥ ν·c_1 − Σ_{n ≥ 2} n |ν·c_n| h^(n−1)
void PathTube::set_progress() {
  const Eigen::VectorXd along = series_.curve().coefficients().transpose() * section_.normal;
  double rest = 0, power = bounds_.h;
  for (Eigen::Index n = 2; n < along.size(); ++n, power *= bounds_.h)
    rest += static_cast<double>(n) * std::abs(along[n]) * power;
  const double rounding = static_cast<double>(along.size() + section_.normal.size()) * epsilon *
                          section_.normal.cwiseAbs().dot(coordinate_speed_);
  progress_ = (along[1] - rest * round_up) * (1 - of_few_roundings) - rounding;
}

/// r = (I − |I − J P|)⁻¹ b for a right side b that is the same part of every equation's terms: then
/// Krawczyk's operator contracts in the norm of r by what r leaves of b. The matrix depends on r, but little.
bool PathTube::contracts(const Eigen::ArrayXd& room) {
  constexpr int rounds = 3;
  const Eigen::Index m = series_.count();
  const Eigen::ArrayXd& terms = bounds_.terms;
  const double part = (width * (bounds_.residual + room) / terms).maxCoeff() + least_radius;
  radius_ = 2 * part * terms;
  for (int i = 0; i < rounds; ++i) {
    set_moves(radius_);
    move_lu_.compute(Eigen::MatrixXd::Identity(m, m) - moves_.transpose());
    radius_ = move_lu_.solve((part * terms).matrix()).array();
    const double least = radius_.minCoeff(), time_reach = row_sizes_.rightCols<1>().dot(radius_.matrix());
    if (!(least > 0 && time_reach <= largest_time_reach)) return false;
    set_moves(radius_);
    contraction_ = ratio(moved(radius_));
    if (contraction_ > largest_contraction) continue;
    if ((radius_ > (moved(radius_) + bounds_.residual) * round_up).all()) return true;
  }
  return false;
}

/// A vector w with push + |I − J P| w ≤ w bounds all v with |v| ≤ push + |I − J P| |v|.
Eigen::ArrayXd PathTube::resolved(const Eigen::ArrayXd& push) const {
  constexpr double above = 1 + 0x1p-20;
  const Eigen::ArrayXd w = above * move_lu_.solve(push.matrix()).array();
  if ((w >= 0).all() && (w >= (push + moved(w)) * round_up).all()) return w;
  return radius_ * (ratio(push) / (1 - contraction_) * round_up);
}

void PathTube::set_start_defect() {
  const Eigen::Index m = series_.count(), forms = series_.forms();
  const Eigen::ArrayXd reach = (differences_.transpose() * radius_.matrix()).array();
  const double time = row_sizes_.col(row_sizes_.cols() - 1).dot(radius_.matrix());
  Eigen::ArrayXd terms(m);
  for (Eigen::Index e = 0; e < m; ++e)
    terms[e] =
        bounds_.slope[e] * (is_plain(e) ? 1 : bounds_.size[forms + e] + bounds_.length_error[e]) * time;
  for (const auto& [e, value, moved] : series_.equations().pairs)
    terms[e] += bounds_.size[value] * reach[moved];
  Eigen::ArrayXd defect = (defect_.transpose() * radius_.matrix()).array() + series_.sum_rounding() * terms;
  if (!series_.has_differences()) {
    const Eigen::ArrayXd errors = (difference_errors_.transpose() * radius_.matrix()).array();
    for (const auto& [e, value, moved] : series_.equations().pairs)
      defect[e] += bounds_.size[value] * errors[moved];
  }
  start_defect_ = ratio(defect);
}

/// v' = −(∂F/∂v)⁻¹ ∂F/∂s, where ∂F/∂s(s, v) − ∂F/∂s(s, 0) = (J(c + P v) − J(c)) c'.
void PathTube::set_speed() {
  const Eigen::Index m = series_.count(), forms = series_.forms();
  const Eigen::ArrayXd reach = (differences_.transpose() * inner_radius_.matrix()).array();
  const double time = row_sizes_.col(row_sizes_.cols() - 1).dot(inner_radius_.matrix());
  Eigen::ArrayXd push = bounds_.residual_speed;
  for (const auto& [e, value, moved] : series_.equations().pairs)
    push[e] += reach[value] * (bounds_.speed[moved] + bounds_.form_speed_error[moved]);
  for (Eigen::Index e = 0; e < m; ++e) {
    const double slope_move = bounds_.curvature[e] * time;
    const double slope = bounds_.slope[e] + slope_move, move = slope * time;
    const double length = bounds_.size[forms + e] + bounds_.length_error[e] + move;
    push[e] += (is_plain(e) ? slope_move : slope * move + length * slope_move) * bounds_.time_speed;
  }
  speed_ = resolved(push);
}

Eigen::VectorXd PathTube::polynomial_error() const {
  return static_cast<double>(2 * series_.curve().order() + 4) * epsilon * coordinate_size_;
}

Eigen::VectorXd PathTube::radius() const {
  return row_sizes_.transpose() * inner_radius_.matrix() * round_up;
}

Eigen::VectorXd PathTube::extent() const {
  const Eigen::VectorXd moved = coordinate_size_ - series_.curve().coefficient(0).cwiseAbs();
  return (moved.cwiseAbs() + radius() + polynomial_error()) * round_up;
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

/// ν·y = ν·c(s) fixes s up to ds; then v = J (y − c(s)) + (I − J P) v.
PlaceInTube PathTube::locate(const PointBox& box, const Eigen::MatrixXd& spread) const {
  const double s = section_parameter(box.mid), terms = static_cast<double>(box.mid.size() + 4) * epsilon;
  Eigen::VectorXd c;
  series_.curve().evaluate(s, c);
  const Eigen::VectorXd offset = box.mid - c;
  const Eigen::VectorXd error = box.radius + polynomial_error() +
                                terms * (offset.cwiseAbs() + spread.cwiseAbs().colwise().sum().transpose());
  const double along = section_.normal.dot(offset);
  const double along_error =
      (section_.normal.cwiseAbs().dot(error) + (spread * section_.normal).cwiseAbs().sum()) * round_up;
  // ν·c grows with s: beyond an end of the tube, ν·y is beyond that end's value.
  if (s == bounds_.h && along > along_error) return {PlaceInTube::Kind::outside, {s, s}};
  if (s == -bounds_.h && along < -along_error) return {PlaceInTube::Kind::outside, {s, s}};
  const double ds = (std::abs(along) + along_error) / progress_ * round_up;
  PlaceInTube place{PlaceInTube::Kind::unknown, {s - ds, s + ds}};
  if (!(place.s.low > -bounds_.h && place.s.high < bounds_.h)) return place;
  const PointBox direction = polynomial_tangent({s, s});
  const Eigen::MatrixXd& sizes = jacobian_sizes_;
  const Eigen::ArrayXd v = (section_.jacobian * offset).array().abs();
  const Eigen::ArrayXd v_error =
      ((sizes * (error + ds * (direction.radius + ds * coordinate_turn_ + terms * direction.mid.cwiseAbs())) +
        ds * (section_.jacobian * direction.mid).cwiseAbs())
           .array() +
       in_section(spread).cwiseAbs().colwise().sum().transpose().array()) *
      round_up;
  if (((v + v_error) * round_up < radius_ * (1 - start_defect_)).all())
    place.kind = PlaceInTube::Kind::inside;
  else if ((v - v_error > radius_ * (1 + start_defect_) * round_up).any())
    place.kind = PlaceInTube::Kind::outside;
  return place;
}

void PathTube::residual(const Eigen::VectorXd& y, const Eigen::VectorXd& error, Eigen::ArrayXd& f,
                        Eigen::ArrayXd& f_error) const {
  const Eigen::Index m = series_.count(), time = y.size() - 1;
  Eigen::ArrayXd size(m);
  for (Eigen::Index e = 0; e < m; ++e) {
    const double a = series_.lengths()[static_cast<std::size_t>(e)].path.value(y[time]);
    // t is within 1/2 of that on c.
    const double a_error =
        bounds_.value_error[e] + (bounds_.slope[e] + bounds_.curvature[e] / 2) * error[time];
    f[e] = is_plain(e) ? -2 * a : -a * a;
    size[e] = std::abs(f[e]);
    f_error[e] = is_plain(e) ? a_error : (std::abs(a) + a_error) * a_error;
  }
  Eigen::ArrayXd at(series_.forms()), at_error(series_.forms());
  for (Eigen::Index k = 0; k < series_.forms(); ++k) {
    at[k] = series_.form_at(k, y);
    at_error[k] = series_.form_error_at(k, y, error);
  }
  for (const auto& [e, value, moved] : series_.equations().pairs) {
    const double product = at[value] * at[moved];
    f[e] += product;
    size[e] += std::abs(product);
    f_error[e] += ((std::abs(at[value]) + at_error[value]) * at_error[moved] +
                   (std::abs(at[moved]) + at_error[moved]) * at_error[value]) /
                  2;
  }
  f /= 2;
  f_error = (f_error + series_.sum_rounding() * size) * round_up;
}

Eigen::MatrixXd PathTube::section_jacobian(const Eigen::VectorXd& y) const {
  const double t = y[y.size() - 1];
  const auto pull = [&](Eigen::Index e) {
    const LengthPath& path = series_.lengths()[static_cast<std::size_t>(e)].path;
    return is_plain(e) ? path.slope(t) : path.value(t) * path.slope(t);
  };
  return jacobian_times(
             series_, section_.rows, [&](Eigen::Index form) { return series_.form_at(form, y); }, pull)
      .transpose();
}

ArcPoint PathTube::at(double s) const {
  constexpr int rounds = 8;
  Eigen::VectorXd c, v = Eigen::VectorXd::Zero(series_.count());
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
  const Eigen::VectorXd left = resolved(f.abs() + f_error).matrix();
  return {{y, error * round_up}, left.asDiagonal() * section_.rows, tangent({s, s})};
}

/// c' at the middle of the range, and how far it is from there to its ends.
PointBox PathTube::polynomial_tangent(const ParameterRange& range) const {
  const double s = (range.low + range.high) / 2;
  const Eigen::MatrixXd& c = series_.curve().coefficients();
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(c.rows());
  for (Eigen::Index n = c.cols() - 1; n >= 1; --n)
    direction = direction * s + static_cast<double>(n) * c.col(n);
  const double rounding = static_cast<double>(2 * c.cols() + 4) * epsilon;
  return {direction, rounding * coordinate_speed_ + (range.high - range.low) * coordinate_turn_};
}

PointBox PathTube::tangent(const ParameterRange& range) const {
  PointBox box = polynomial_tangent(range);
  box.radius = (box.radius + row_sizes_.transpose() * speed_.matrix()) * round_up;
  return box;
}

}  // namespace gcs
