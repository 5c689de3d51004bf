#include "solvers/subdivision/square_narrowing.hpp"

namespace gcs {
namespace {

/// A pass that narrows every interval by less than this share is the last one.
constexpr double worth_a_pass = 0.1;
constexpr int most_passes = 8;

class Narrowing {
 public:
  Narrowing(const IntervalEquations& system, IntervalBox& box)
      : system_(system), box_(box), forms_(forms_over(system, box)) {}

  std::optional<std::vector<Interval>> run() {
    for (int pass = 0; pass < most_passes && has_progress_; ++pass) {
      has_progress_ = false;
      for (const IntervalEquation& equation : system_.equations)
        if (!apply(equation)) return std::nullopt;
    }
    return std::move(forms_);
  }

 private:
  Interval& form(int number) { return forms_[static_cast<std::size_t>(number)]; }

  Interval value(const IntervalProduct& product) {
    return product.is_square() ? square(form(product.left)) : form(product.left) * form(product.right);
  }

  /// False where it cannot hold.
  bool apply(const IntervalEquation& equation) {
    for (std::size_t k = 0; k < equation.products.size(); ++k) {
      Interval rest = equation.given.interval;
      for (std::size_t j = 0; j < equation.products.size(); ++j)
        if (j != k) rest = rest - value(equation.products[j]);
      if (!narrow(equation.products[k], rest)) return false;
    }
    return true;
  }

  bool narrow(const IntervalProduct& product, const Interval& values) {
    if (product.is_square()) return narrow_root(product.left, values);
    for (const auto& [of, other] : {std::pair(product.left, product.right), {product.right, product.left}})
      if (!form(other).contains_zero() && !narrow_form(of, values / form(other))) return false;
    return !intersection(value(product), values).is_empty();
  }

  /// The form's square has one of these values.
  bool narrow_root(int number, const Interval& values) {
    if (values.high < 0) return false;
    const Interval root = sqrt(values);
    Interval hull = intersection(form(number), interval_around_zero(root.high));
    if (hull.low > -root.low) hull.low = std::max(hull.low, root.low);
    if (hull.high < root.low) hull.high = std::min(hull.high, -root.low);
    return narrow_form(number, hull);
  }

  bool narrow_form(int number, const Interval& values) {
    Interval& known = form(number);
    const Interval both = intersection(known, values);
    if (both.is_empty()) return false;
    const bool is_narrower = both.low > known.low || both.high < known.high;
    known = both;
    return !is_narrower || narrow_unknowns(number);
  }

  bool narrow_unknowns(int number) {
    const auto& [terms, constant] = system_.forms[static_cast<std::size_t>(number)];
    for (std::size_t k = 0; k < terms.size(); ++k) {
      Interval rest = form(number) - constant.interval;
      for (std::size_t j = 0; j < terms.size(); ++j)
        if (j != k)
          rest = rest - terms[j].coefficient.interval * box_[static_cast<std::size_t>(terms[j].unknown)];
      if (terms[k].coefficient.interval.contains_zero()) continue;
      if (!narrow_unknown(terms[k].unknown, rest / terms[k].coefficient.interval)) return false;
    }
    form(number) = intersection(form(number), system_.forms[static_cast<std::size_t>(number)].over(box_));
    return !form(number).is_empty();
  }

  bool narrow_unknown(int unknown, const Interval& values) {
    Interval& known = box_[static_cast<std::size_t>(unknown)];
    const Interval both = intersection(known, values);
    if (both.is_empty()) return false;
    has_progress_ = has_progress_ || both.width() < (1 - worth_a_pass) * known.width();
    known = both;
    return true;
  }

  const IntervalEquations& system_;
  IntervalBox& box_;
  std::vector<Interval> forms_;
  bool has_progress_ = true;
};

}  // namespace

std::vector<Interval> forms_over(const IntervalEquations& system, const IntervalBox& box) {
  std::vector<Interval> result;
  for (const IntervalForm& form : system.forms) result.push_back(form.over(box));
  return result;
}

bool are_contradictory(const IntervalEquations& system, const std::vector<Interval>& forms) {
  for (const IntervalEquation& equation : system.equations) {
    Interval sum = -equation.given.interval;
    for (const IntervalProduct& product : equation.products) {
      const Interval &left = forms[static_cast<std::size_t>(product.left)],
                     &right = forms[static_cast<std::size_t>(product.right)];
      sum = sum + (product.is_square() ? square(left) : left * right);
    }
    if (!sum.contains_zero()) return true;
  }
  return false;
}

std::optional<std::vector<Interval>> narrow_by_equations(const IntervalEquations& system, IntervalBox& box) {
  return Narrowing(system, box).run();
}

}  // namespace gcs
