#include "solvers/proven_paths/path_equations.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/numeric/balls.hpp"

namespace gcs {
namespace {

struct EnclosedNumber {
  double mid = 0;
  double error = 0;
};

EnclosedNumber enclosed(const ExactNumber& number) {
  constexpr slong bits = 128;
  const double mid = rounded_to_double(number).real();
  Ball exact, rounded;
  enclose(exact, number, bits);
  acb_set_d(rounded, mid);
  acb_sub(exact, exact, rounded, bits);
  return {mid, magnitude(exact)};
}

/// Times a power of two.
EnclosedForm enclosed(const LinearForm& exact, double factor) {
  EnclosedForm form;
  for (const ScaledUnknown& term : exact.terms) {
    const EnclosedNumber coefficient = enclosed(term.coefficient);
    form.terms.push_back({term.unknown, factor * coefficient.mid, factor * coefficient.error});
  }
  const EnclosedNumber constant = enclosed(exact.constant);
  form.constant = factor * constant.mid;
  form.constant_error = factor * constant.error;
  return form;
}

EnclosedForm constant(const EnclosedNumber& number) { return {{}, number.mid, number.error}; }

void add_product(Eigen::Index equation, EnclosedForm left, EnclosedForm right, PathEquations& equations) {
  const auto l = static_cast<Eigen::Index>(equations.forms.size()), r = l + 1;
  equations.forms.push_back(std::move(left));
  equations.forms.push_back(std::move(right));
  equations.pairs.push_back({equation, l, r});
  equations.pairs.push_back({equation, r, l});
}

bool is_exact(const EnclosedForm& form) {
  return form.constant_error == 0 &&
         std::ranges::all_of(form.terms, [](const EnclosedForm::Term& term) { return term.error == 0; });
}

bool are_equal(const EnclosedForm& a, const EnclosedForm& b) {
  const auto same = [](const EnclosedForm::Term& s, const EnclosedForm::Term& t) {
    return s.coordinate == t.coordinate && s.coefficient == t.coefficient;
  };
  return is_exact(a) && is_exact(b) && a.constant == b.constant && std::ranges::equal(a.terms, b.terms, same);
}

}  // namespace

bool EnclosedForm::is_difference() const {
  const auto is_one = [](const Term& term) { return std::abs(term.coefficient) == 1 && term.error == 0; };
  return terms.size() <= 2 && std::ranges::all_of(terms, is_one) && constant == 0 && constant_error == 0;
}

PathEquations distance_equations(const DistanceSystem& system) {
  PathEquations equations{system.equations(), {}, {}};
  for (int axis = 0; axis < system.dimension(); ++axis)
    for (int e = 0; e < system.equations(); ++e) {
      const auto [a, b] = system.edges()[static_cast<std::size_t>(e)];
      const int i = system.unknown(a, axis), j = system.unknown(b, axis);
      const auto form = static_cast<Eigen::Index>(equations.forms.size());
      equations.forms.emplace_back();
      if (i >= 0) equations.forms.back().terms.push_back({i, 1, 0});
      if (j >= 0) equations.forms.back().terms.push_back({j, -1, 0});
      equations.pairs.push_back({e, form, form});
    }
  return equations;
}

PathEquations released_equations(const QuadraticSystem& system) {
  PathEquations equations{static_cast<Eigen::Index>(system.equations.size()), {}, {}};
  for (Eigen::Index e = 0; e < equations.count; ++e)
    for (const FormProduct& product : system.equations[static_cast<std::size_t>(e)].products) {
      EnclosedForm left = enclosed(product.left, 1);
      if (!are_equal(left, enclosed(product.right, 1))) {
        add_product(e, enclosed(product.left, 0.5), enclosed(product.right, 1), equations);
        continue;
      }
      const auto form = static_cast<Eigen::Index>(equations.forms.size());
      equations.forms.push_back(std::move(left));
      equations.pairs.push_back({e, form, form});
    }
  return equations;
}

PathEquations general_equations(const SceneSystem& system, const std::vector<TravellingValue>& values) {
  PathEquations equations{static_cast<Eigen::Index>(values.size()), {}, {}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto e = static_cast<Eigen::Index>(i);
    const QuadraticEquation& exact = system.equations().equations[i];
    if (values[i].root_sign != 0) {
      add_product(e, enclosed(exact.products[0].left, 1), constant({values[i].root_sign}), equations);
      continue;
    }
    for (const FormProduct& product : exact.products)
      add_product(e, enclosed(product.left, values[i].is_plain ? 1 : 0.5), enclosed(product.right, 1),
                  equations);
    if (system.value_of()[i] < 0 && !exact.given.is_zero())
      add_product(e, constant(enclosed(exact.given)), constant({-1, 0}), equations);
  }
  return equations;
}

}  // namespace gcs
