#include "solvers/tracking/edge_series.hpp"

#include <algorithm>
#include <limits>

namespace gcs {

double wide_half_excess(const Eigen::Matrix3Xd& points, const std::array<int, 2>& edge,
                        const LengthPath& path, double t) {
  const DoubleDouble length = path.wide_value(t);
  const DoubleDouble square = squared_distance<Eigen::Vector3d>(points.col(edge[0]), points.col(edge[1]), 3);
  return (square - length * length).value() / 2;
}

LengthSeries::LengthSeries(std::vector<LengthPath> paths, std::vector<bool> plain, int order)
    : paths_(std::move(paths)), plain_(std::move(plain)) {
  plain_.resize(paths_.size());
  const auto m = static_cast<Eigen::Index>(paths_.size());
  for (Eigen::VectorXd* v : {&value_, &slope_, &quadratic_, &cubic_, &quartic_}) v->setZero(m);
  for (Eigen::VectorXd* v : {&offset_, &offset2_}) v->setZero(order + 1);
  int highest = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i)
    if (!paths_[i].higher.empty()) {
      polynomials_.push_back({static_cast<Eigen::Index>(i), {}});
      highest = std::max(highest, std::min(2 * paths_[i].degree(), order));
    }
  if (highest > 0) powers_.setZero(highest + 1, order + 1);
}

void LengthSeries::expand(Polynomial& of, double t0) const {
  const auto edge = static_cast<std::size_t>(of.edge);
  const std::vector<double> a = paths_[edge].expansion(t0);
  if (plain_[edge]) {
    of.powers = a;
    return;
  }
  of.powers.assign(2 * a.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) of.powers[i + j] += a[i] * a[j] / 2;
}

/// The n-th coefficients of the powers, which begin with order k.
void LengthSeries::set_powers(int n) {
  powers_(1, n - 1) = offset_[n - 1];
  for (Eigen::Index k = 2; k < powers_.rows(); ++k) {
    double sum = 0;
    for (Eigen::Index i = 1; i <= n - k + 1; ++i) sum += offset_[i] * powers_(k - 1, n - i);
    powers_(k, n) = sum;
  }
}

void LengthSeries::start(double t0) {
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    const auto e = static_cast<Eigen::Index>(i);
    const double a = paths_[i].value(t0);
    const double b = paths_[i].slope(t0);
    const double c = -paths_[i].bend;
    value_[e] = a;
    slope_[e] = plain_[i] ? b : a * b;
    quadratic_[e] = plain_[i] ? c : b * b / 2 + a * c;
    cubic_[e] = plain_[i] ? 0 : b * c;
    quartic_[e] = plain_[i] ? 0 : c * c / 2;
  }
  for (Polynomial& polynomial : polynomials_) expand(polynomial, t0);
}

double LengthSeries::shortest(double t) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const LengthPath& path : paths_)
    shortest = std::min(shortest, path.value(t) / std::max(path.at_sketch, path.at_target));
  return shortest;
}

void LengthSeries::known(int n, Eigen::Ref<Eigen::VectorXd> result) {
  double square = 0;
  for (int i = 1; i < n; ++i) square += offset_[i] * offset_[n - i];
  double cube = 0;
  for (int i = 2; i < n; ++i) cube += offset2_[i] * offset_[n - i];
  double fourth = 0;
  for (int i = 2; i < n - 1; ++i) fourth += offset2_[i] * offset2_[n - i];
  offset2_[n] = square;
  result = quadratic_ * square + cubic_ * cube + quartic_ * fourth;
  if (polynomials_.empty()) return;
  set_powers(n);
  for (const Polynomial& of : polynomials_) {
    double sum = 0;
    for (Eigen::Index k = 2; k < powers_.rows() && k < std::ssize(of.powers); ++k)
      sum += of.powers[static_cast<std::size_t>(k)] * powers_(k, n);
    result[of.edge] = sum;
  }
}

EdgeSeries::EdgeSeries(Eigen::Index edges, int dimension, int order)
    : dimension_(dimension),
      order_(order),
      differences_(edges * dimension, order + 1),
      products_(edges * dimension) {}

void EdgeSeries::resize(Eigen::Index edges) {
  differences_ = AlignedColumns(edges * dimension_, order_ + 1);
  products_.resize(edges * dimension_);
}

void EdgeSeries::subtract_half_convolution(int n, Eigen::Ref<Eigen::VectorXd> entries) {
  kernels_.half_convolution(differences_.from(0), 1, n, products_.data());
  const Eigen::Index m = edges();
  if (dimension_ == 3)
    entries -= products_.head(m) + products_.segment(m, m) + products_.tail(m);
  else
    entries -= products_.head(m) + products_.tail(m);
}

}  // namespace gcs
