#include "solvers/subdivision/boxed_simplex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gcs {
namespace {

/// Of entries of order 1: what rounding leaves of a zero, with room for some hundred exchanges.
constexpr double tolerance = 1e-9;
/// Exchanging by a smaller entry would magnify rounding.
constexpr double least_pivot = 1e-7;

/// Exchanges for each variable before the method gives up.
constexpr int most_rounds = 20;

}  // namespace

BoxedSimplex::BoxedSimplex(const Eigen::MatrixXd& rows, Eigen::VectorXd low, Eigen::VectorXd high)
    : columns_(static_cast<int>(rows.cols())),
      table_(rows),
      cost_(rows.cols()),
      low_(rows.cols() + rows.rows()),
      high_(rows.cols() + rows.rows()),
      basic_(static_cast<std::size_t>(rows.rows())),
      nonbasic_(static_cast<std::size_t>(rows.cols())),
      value_of_(static_cast<std::size_t>(rows.cols() + rows.rows())) {
  low_ << Eigen::VectorXd::Constant(columns_, -1), low;
  high_ << Eigen::VectorXd::Constant(columns_, 1), high;
  std::iota(nonbasic_.begin(), nonbasic_.end(), 0);
  std::iota(basic_.begin(), basic_.end(), columns_);
}

/// The basic variables from the others.
void BoxedSimplex::update_values() {
  Eigen::VectorXd at(columns_);
  for (int j = 0; j < columns_; ++j)
    at[j] = value_of_[static_cast<std::size_t>(nonbasic_[static_cast<std::size_t>(j)])];
  const Eigen::VectorXd values = table_ * at;
  for (std::size_t k = 0; k < basic_.size(); ++k)
    value_of_[static_cast<std::size_t>(basic_[k])] = values[static_cast<Eigen::Index>(k)];
}

/// Exchanges a basic and another variable.
void BoxedSimplex::pivot(Eigen::Index k, Eigen::Index j) {
  ++pivots_;
  const double inverse = 1 / table_(k, j);
  table_.row(k) *= -inverse;
  table_(k, j) = inverse;
  for (Eigen::Index i = 0; i < table_.rows(); ++i) {
    if (i == k) continue;
    const double factor = table_(i, j);
    if (factor == 0) continue;
    table_(i, j) = 0;
    table_.row(i) += factor * table_.row(k);
  }
  const double factor = cost_[j];
  cost_[j] = 0;
  cost_ += factor * table_.row(k).transpose();
  std::swap(basic_[static_cast<std::size_t>(k)], nonbasic_[static_cast<std::size_t>(j)]);
}

/// The dual simplex method with costs of which no two are equal: from any costs the bounds at which they are
/// least are a start.
BoxedSimplex::End BoxedSimplex::find_point() {
  for (int j = 0; j < columns_; ++j) {
    cost_[j] = 1 + j / (columns_ + 1.0);
    value_of_[static_cast<std::size_t>(j)] = low_[j];
  }
  const std::int64_t most = pivots_ + most_rounds * (table_.rows() + columns_);
  while (pivots_ < most) {
    update_values();
    Eigen::Index leaving = -1;
    double worst = tolerance;
    for (std::size_t k = 0; k < basic_.size(); ++k) {
      const int v = basic_[k];
      const double x = value_of_[static_cast<std::size_t>(v)];
      const double violation = std::max(low(v) - x, x - high(v));
      if (violation > worst) {
        worst = violation;
        leaving = static_cast<Eigen::Index>(k);
      }
    }
    if (leaving < 0) return End::feasible;
    const int out = basic_[static_cast<std::size_t>(leaving)];
    const bool is_below = value_of_[static_cast<std::size_t>(out)] < low(out);
    Eigen::Index entering = -1;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < columns_; ++j) {
      const int v = nonbasic_[static_cast<std::size_t>(j)];
      const bool is_at_low = value_of_[static_cast<std::size_t>(v)] <= low(v);
      const double entry = is_below ? table_(leaving, j) : -table_(leaving, j);
      if (is_at_low ? !(entry > least_pivot) : !(entry < -least_pivot)) continue;
      const double ratio = std::abs(cost_[j] / entry);
      if (ratio < least) {
        least = ratio;
        entering = j;
      }
    }
    if (entering < 0) {
      contradicting_ = leaving;
      return End::infeasible;
    }
    value_of_[static_cast<std::size_t>(out)] = is_below ? low(out) : high(out);
    pivot(leaving, entering);
  }
  return End::gave_up;
}

Eigen::VectorXd BoxedSimplex::multipliers(const Eigen::VectorXd& of_nonbasic) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(table_.rows());
  for (int j = 0; j < columns_; ++j) {
    const int v = nonbasic_[static_cast<std::size_t>(j)];
    if (v >= columns_) y[v - columns_] = of_nonbasic[j];
  }
  return y;
}

Eigen::VectorXd BoxedSimplex::contradiction() const {
  Eigen::VectorXd y = multipliers(table_.row(contradicting_).transpose());
  const int v = basic_[static_cast<std::size_t>(contradicting_)];
  if (v >= columns_) y[v - columns_] = -1;
  return y;
}

Eigen::VectorXd BoxedSimplex::minimise(int objective, double sign) {
  cost_.setZero();
  const auto as_basic = std::find(basic_.begin(), basic_.end(), objective);
  if (as_basic != basic_.end())
    cost_ = sign * table_.row(as_basic - basic_.begin()).transpose();
  else
    cost_[std::find(nonbasic_.begin(), nonbasic_.end(), objective) - nonbasic_.begin()] = sign;

  const std::int64_t most = most_rounds * (table_.rows() + columns_);
  for (std::int64_t round = 0; round < most; ++round) {
    Eigen::Index entering = -1;
    double steepest = tolerance;
    for (Eigen::Index j = 0; j < columns_; ++j) {
      const int v = nonbasic_[static_cast<std::size_t>(j)];
      const bool is_at_low = value_of_[static_cast<std::size_t>(v)] <= low(v);
      const double slope = is_at_low ? -cost_[j] : cost_[j];
      if (slope > steepest) {
        steepest = slope;
        entering = j;
      }
    }
    if (entering < 0) break;
    const int in = nonbasic_[static_cast<std::size_t>(entering)];
    const double direction = value_of_[static_cast<std::size_t>(in)] <= low(in) ? 1 : -1;
    double step = high(in) - low(in), size = 0;
    Eigen::Index leaving = -1;
    double bound = 0;
    for (Eigen::Index k = 0; k < table_.rows(); ++k) {
      const double rate = direction * table_(k, entering);
      if (std::abs(rate) <= least_pivot) continue;
      const int v = basic_[static_cast<std::size_t>(k)];
      const double end = rate > 0 ? high(v) : low(v);
      const double way = std::max(0.0, (end - value_of_[static_cast<std::size_t>(v)]) / rate);
      if (way < step || (way == step && std::abs(rate) > size)) {
        step = way;
        size = std::abs(rate);
        leaving = k;
        bound = end;
      }
    }
    if (leaving < 0) {
      value_of_[static_cast<std::size_t>(in)] = direction > 0 ? high(in) : low(in);
    } else {
      value_of_[static_cast<std::size_t>(basic_[static_cast<std::size_t>(leaving)])] = bound;
      pivot(leaving, entering);
    }
    update_values();
  }
  return sign * multipliers(cost_);
}

}  // namespace gcs
