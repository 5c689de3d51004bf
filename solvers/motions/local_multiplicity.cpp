#include "solvers/motions/local_multiplicity.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <map>
#include <numeric>

#include "solvers/elements/dense_equations.hpp"

namespace gcs {
namespace {

using Exponents = std::vector<int>;

/// A singular value below this part of the largest leaves its direction free; what it still says is an entry of g.
constexpr double nearly_free = 1e-4;
/// Coefficients of g, with t in units of the radius in which its terms are of one size, that count as 0: above what the
/// uncertainty of x makes of them.
constexpr double absent = 1e-6;
/// Of a matrix whose rank is found in a second or less.
constexpr std::size_t most_columns = 700;

/// All of one degree in so many variables.
std::vector<Exponents> monomials_of(int degree, std::size_t variables) {
  if (variables == 1) return {{degree}};
  std::vector<Exponents> result;
  for (int first = degree; first >= 0; --first)
    for (Exponents& rest : monomials_of(degree - first, variables - 1)) {
      rest.insert(rest.begin(), first);
      result.push_back(std::move(rest));
    }
  return result;
}

Exponents sum_of(Exponents a, const Exponents& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

/// g(t), degree by degree.
class ReducedSeries {
 public:
  ReducedSeries(const QuadraticSystem& system, const std::vector<std::complex<double>>& x)
      : system_(system), at_origin_(system_.jacobian(std::vector<std::complex<double>>(x.size()))) {
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(system_.jacobian(x),
                                                 Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::VectorXd& sizes = svd.singularValues();
    const Eigen::Index rank = (sizes.array() > nearly_free * sizes[0]).count();
    const Eigen::Index left = svd.matrixV().cols() - rank;
    solving_ = svd.matrixV().leftCols(rank) * sizes.head(rank).cwiseInverse().asDiagonal() *
               svd.matrixU().leftCols(rank).adjoint();
    remaining_ = svd.matrixU().rightCols(svd.matrixU().cols() - rank).adjoint();
    for (Eigen::Index i = 0; i < left; ++i) {
      Exponents one(static_cast<std::size_t>(left), 0);
      one[static_cast<std::size_t>(i)] = 1;
      const Eigen::VectorXcd direction = svd.matrixV().col(rank + i);
      terms_[one] = remaining_ * (system_.jacobian(x) * direction);
      unknowns_[one] = direction;
      slopes_[one] = slope_along(direction);
    }
  }

  std::size_t variables() const { return unknowns_.empty() ? 0 : unknowns_.begin()->first.size(); }
  Eigen::Index equations() const { return remaining_.rows(); }
  const std::map<Exponents, Eigen::VectorXcd>& terms() const { return terms_; }
  /// The length of t at which terms of the first two degrees are of one size, and what the second ones are there.
  double radius() const { return radius_; }
  double size() const { return size_; }

  /// Precondition: lower degrees are there.
  void add_degree(int degree) {
    double largest_unknown = 0, largest_product = 0;
    for (const Exponents& monomial : monomials_of(degree, variables())) {
      const Eigen::VectorXcd product = product_at(monomial);
      largest_product = std::max(largest_product, product.lpNorm<Eigen::Infinity>());
      terms_[monomial] = remaining_ * product;
      new_unknowns_[monomial] = -(solving_ * product);
      largest_unknown = std::max(largest_unknown, new_unknowns_[monomial].norm());
    }
    for (auto& [monomial, unknown] : new_unknowns_) {
      slopes_[monomial] = slope_along(unknown);
      unknowns_[monomial] = std::move(unknown);
    }
    new_unknowns_.clear();
    if (degree != 2) return;
    radius_ = 1 / std::max(1.0, largest_unknown);
    size_ = largest_product * radius_ * radius_;
  }

 private:
  /// Half of the change of the Jacobian: the quadratic part of the equations at (u, v) is slope(u) v.
  Eigen::MatrixXcd slope_along(const Eigen::VectorXcd& u) const {
    return (system_.jacobian({u.begin(), u.end()}) - at_origin_) / 2;
  }

  Eigen::VectorXcd product_at(const Exponents& monomial) const {
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(at_origin_.rows());
    for (const auto& [factor, slope] : slopes_) {
      Exponents other = monomial;
      for (std::size_t i = 0; i < other.size(); ++i) other[i] -= factor[i];
      if (const auto found = unknowns_.find(other); found != unknowns_.end()) sum += slope * found->second;
    }
    return sum;
  }

  const DenseEquations system_;
  Eigen::MatrixXcd at_origin_, solving_, remaining_;
  std::map<Exponents, Eigen::VectorXcd> terms_, unknowns_, new_unknowns_;
  std::map<Exponents, Eigen::MatrixXcd> slopes_;
  double radius_ = 1, size_ = 1;
};

/// How many operators of order `degree` or less there are, of order 0 one.
int operators(const ReducedSeries& series, const std::vector<std::vector<Exponents>>& monomials, int degree) {
  std::map<Exponents, Eigen::Index> column_of;
  for (int d = 1; d <= degree; ++d)
    for (const Exponents& monomial : monomials[static_cast<std::size_t>(d)])
      column_of.emplace(monomial, std::ssize(column_of));
  std::vector<Eigen::RowVectorXcd> rows;
  for (int d = 0; d < degree; ++d)
    for (const Exponents& factor : monomials[static_cast<std::size_t>(d)])
      for (Eigen::Index j = 0; j < series.equations(); ++j) {
        Eigen::RowVectorXcd row = Eigen::RowVectorXcd::Zero(std::ssize(column_of));
        for (const auto& [monomial, term] : series.terms())
          if (const auto column = column_of.find(sum_of(monomial, factor)); column != column_of.end())
            row[column->second] =
                term[j] * std::pow(series.radius(), std::accumulate(monomial.begin(), monomial.end(), 0)) /
                series.size();
        rows.push_back(std::move(row));
      }
  Eigen::MatrixXcd matrix(std::ssize(rows), std::ssize(column_of));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.row(i) = rows[static_cast<std::size_t>(i)];
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> factors(matrix);
  const auto rank = (factors.matrixQR().diagonal().cwiseAbs().array() > absent).count();
  return static_cast<int>(1 + matrix.cols() - rank);
}

}  // namespace

std::optional<int> local_multiplicity(const QuadraticSystem& system,
                                      const std::vector<std::complex<double>>& x, int most) {
  ReducedSeries series(system, x);
  if (series.variables() == 0) return 1;
  std::vector<std::vector<Exponents>> monomials{monomials_of(0, series.variables())};
  std::size_t columns = 0;
  int known = 1;
  for (int degree = 1; known <= most; ++degree) {
    monomials.push_back(monomials_of(degree, series.variables()));
    columns += monomials.back().size();
    if (columns > most_columns) return std::nullopt;
    series.add_degree(degree + 1);
    const int more = operators(series, monomials, degree);
    if (more == known) return known;
    known = more;
  }
  return most + 1;
}

}  // namespace gcs
