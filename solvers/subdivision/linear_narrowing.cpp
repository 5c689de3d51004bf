#include "solvers/subdivision/linear_narrowing.hpp"

#include <Eigen/Core>
#include <cmath>

#include "solvers/subdivision/boxed_simplex.hpp"

namespace gcs {
namespace {

/// An unknown that moves all slabs by less than this share of what others do is left as it is.
constexpr double negligible = 0x1p-20;

/// A point of the relaxation that is so near to a bound, in the box's radii, says that no program narrows the
/// box there by more.
constexpr double near_bound = 0.1;

/// Of multipliers: below this share of the largest one they are rounding.
constexpr double rounding = 1e-11;

/// Σ coefficients·x ∈ values at all solutions in the box.
struct Slab {
  std::vector<Interval> coefficients;
  Interval values;
};

class Relaxation {
 public:
  Relaxation(const IntervalEquations& system, const std::vector<Interval>& forms, const IntervalBox& box)
      : system_(system), forms_(forms), box_(box) {
    for (const Interval& side : box) {
      middle_.push_back(side.middle());
      radius_.push_back(side.reach(middle_.back()));
    }
    for (const IntervalEquation& equation : system.equations) add(slab_of(equation));
    for (std::size_t form = 0; form < system.forms.size(); ++form)
      if (is_narrower_than_box(form)) add(slab_of(form));
    choose_columns();
    make_rows();
  }

  const std::vector<int>& columns() const { return columns_; }
  const Eigen::MatrixXd& rows() const { return rows_; }
  const std::vector<Interval>& values() const { return row_values_; }
  Interval unknown(std::size_t column, const Interval& z) const {
    const auto i = static_cast<std::size_t>(columns_[column]);
    return exact_interval(middle_[i]) + radius_[i] * z;
  }

 private:
  /// The products' linear parts.
  Slab slab_of(const IntervalEquation& equation) const {
    Slab slab{std::vector<Interval>(box_.size()), equation.given.interval};
    for (const IntervalProduct& product : equation.products) {
      const Interval &left = forms_[static_cast<std::size_t>(product.left)],
                     &right = forms_[static_cast<std::size_t>(product.right)];
      const double l = left.middle(), r = right.middle();
      const Interval radii = exact_interval(left.reach(l)) * exact_interval(right.reach(r));
      const Interval rest = product.is_square() ? Interval{0, radii.high} : interval_around_zero(radii.high);
      slab.values = slab.values - rest + exact_interval(l) * exact_interval(r);
      add_form(product.left, r, slab);
      add_form(product.right, l, slab);
    }
    return slab;
  }

  Slab slab_of(std::size_t form) const {
    Slab slab{std::vector<Interval>(box_.size()), forms_[form]};
    add_form(static_cast<int>(form), 1, slab);
    return slab;
  }

  /// factor·form, in terms of x − middle.
  void add_form(int number, double factor, Slab& slab) const {
    const IntervalForm& form = system_.forms[static_cast<std::size_t>(number)];
    slab.values = slab.values - factor * form.constant.interval;
    for (const auto& [unknown, coefficient] : form.terms) {
      const auto i = static_cast<std::size_t>(unknown);
      const Interval term = factor * coefficient.interval;
      slab.values = slab.values - middle_[i] * term;
      slab.coefficients[i] = slab.coefficients[i] + radius_[i] * term;
    }
  }

  bool is_narrower_than_box(std::size_t form) const {
    constexpr double clearly = 0.99;
    return system_.forms[form].terms.size() > 1 &&
           forms_[form].width() < clearly * system_.forms[form].over(box_).width();
  }

  void add(Slab slab) {
    if (slab.values.is_finite()) slabs_.push_back(std::move(slab));
  }

  void choose_columns() {
    std::vector<double> largest(box_.size(), 0);
    for (const Slab& slab : slabs_)
      for (std::size_t i = 0; i < box_.size(); ++i)
        largest[i] = std::max(largest[i], slab.coefficients[i].magnitude());
    const double all = *std::max_element(largest.begin(), largest.end());
    for (std::size_t i = 0; i < box_.size(); ++i)
      if (largest[i] > negligible * all) columns_.push_back(static_cast<int>(i));
  }

  /// The slabs as rows of doubles, which are exact for values that are wider by what is rounded and left out,
  /// each in a unit that makes it of order 1.
  void make_rows() {
    std::vector<Eigen::VectorXd> rows;
    for (const Slab& slab : slabs_) {
      Eigen::VectorXd row(static_cast<Eigen::Index>(columns_.size()));
      Interval values = slab.values;
      std::size_t column = 0;
      for (std::size_t i = 0; i < box_.size(); ++i) {
        if (column < columns_.size() && columns_[column] == static_cast<int>(i)) {
          const double middle = slab.coefficients[i].middle();
          row[static_cast<Eigen::Index>(column++)] = middle;
          values = values + interval_around_zero(slab.coefficients[i].reach(middle));
        } else {
          values = values + interval_around_zero(slab.coefficients[i].magnitude());
        }
      }
      const double size = row.size() == 0 ? 0 : row.cwiseAbs().maxCoeff();
      if (!(size > 0) || is_implied(row, values)) continue;
      const double unit = std::ldexp(1.0, -std::ilogb(size));
      rows.emplace_back(unit * row);
      row_values_.push_back(unit * values);
    }
    rows_.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t e = 0; e < rows.size(); ++e) rows_.row(static_cast<Eigen::Index>(e)) = rows[e];
  }

  static bool is_implied(const Eigen::VectorXd& row, const Interval& values) {
    const double reach = row.cwiseAbs().sum();
    return values.low <= -reach && values.high >= reach;
  }

  const IntervalEquations& system_;
  const std::vector<Interval>& forms_;
  const IntervalBox& box_;
  std::vector<double> middle_, radius_;
  std::vector<Slab> slabs_;
  std::vector<int> columns_;
  Eigen::MatrixXd rows_;
  std::vector<Interval> row_values_;
};

constexpr Interval unit_interval{-1, 1};

/// Σ y_e s_e + (c − Aᵀy)·z, which is c·z, for c = e_j, or 0 where j < 0.
Interval safe_value(const Relaxation& relaxation, Eigen::VectorXd y, int j) {
  const double least = rounding * y.cwiseAbs().maxCoeff();
  Interval sum;
  std::vector<Interval> rest(static_cast<std::size_t>(relaxation.rows().cols()));
  if (j >= 0) rest[static_cast<std::size_t>(j)] = exact_interval(1);
  for (Eigen::Index e = 0; e < y.size(); ++e) {
    if (!(std::abs(y[e]) > least)) continue;
    sum = sum + y[e] * relaxation.values()[static_cast<std::size_t>(e)];
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] = rest[i] - y[e] * exact_interval(relaxation.rows()(e, static_cast<Eigen::Index>(i)));
  }
  for (const Interval& coefficient : rest) sum = sum + coefficient * unit_interval;
  return sum;
}

}  // namespace

bool narrow_linearly(const IntervalEquations& system, const std::vector<Interval>& forms, IntervalBox& box,
                     LinearWork& work) {
  const Relaxation relaxation(system, forms, box);
  const std::vector<int>& columns = relaxation.columns();
  if (columns.empty() || relaxation.values().empty()) return true;
  Eigen::VectorXd low(relaxation.rows().rows()), high(low.size());
  for (Eigen::Index e = 0; e < low.size(); ++e) {
    low[e] = relaxation.values()[static_cast<std::size_t>(e)].low;
    high[e] = relaxation.values()[static_cast<std::size_t>(e)].high;
  }
  BoxedSimplex simplex(relaxation.rows(), low, high);
  ++work.programs;
  const BoxedSimplex::End end = simplex.find_point();
  if (end != BoxedSimplex::End::feasible) {
    work.pivots += simplex.pivots();
    return end == BoxedSimplex::End::gave_up ||
           safe_value(relaxation, simplex.contradiction(), -1).contains_zero();
  }

  const auto n = static_cast<int>(columns.size());
  std::vector<Interval> seen(columns.size(), {1, -1});
  const auto look = [&] {
    for (int j = 0; j < n; ++j) {
      Interval& range = seen[static_cast<std::size_t>(j)];
      range = {std::min(range.low, simplex.value(j)), std::max(range.high, simplex.value(j))};
    }
  };
  look();
  bool is_possible = true;
  for (int j = 0; j < n && is_possible; ++j)
    for (const double sign : {1.0, -1.0}) {
      const Interval& range = seen[static_cast<std::size_t>(j)];
      if (sign > 0 ? range.low < -1 + near_bound : range.high > 1 - near_bound) continue;
      ++work.programs;
      const Eigen::VectorXd y = simplex.minimise(j, sign);
      look();
      Interval z = safe_value(relaxation, y, j);
      if (!z.is_finite()) continue;
      (sign > 0 ? z.high : z.low) = sign;
      if (z.is_empty()) {
        is_possible = false;
        break;
      }
      Interval& side = box[static_cast<std::size_t>(columns[static_cast<std::size_t>(j)])];
      side = intersection(side, relaxation.unknown(static_cast<std::size_t>(j), z));
      is_possible = is_possible && !side.is_empty();
    }
  work.pivots += simplex.pivots();
  return is_possible;
}

}  // namespace gcs
