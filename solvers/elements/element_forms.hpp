#pragma once
/// Points, directions and offsets as linear forms in the unknowns of a system, and what equations are made of.

#include <array>
#include <complex>
#include <vector>

#include "solvers/model/quadratic_system.hpp"

namespace gcs {

/// One form per axis; in the plane the third is 0.
using VectorForm = std::array<LinearForm, 3>;

inline bool is_zero(const LinearForm& form) { return form.terms.empty() && form.constant.is_zero(); }

LinearForm constant_form(const ExactNumber& number);
LinearForm negated(LinearForm form);
VectorForm negated(VectorForm forms);
/// Precondition: one of them has no constant.
LinearForm difference(LinearForm left, const LinearForm& right);

/// Times 2^exponent.
VectorForm scaled(VectorForm forms, int exponent);

/// Σ products − given of an equation that is being written: nothing is added where a factor is 0.
class Equation {
 public:
  Equation& plus(const LinearForm& left, const LinearForm& right);
  Equation& minus(const LinearForm& left, const LinearForm& right) { return plus(negated(left), right); }
  Equation& plus(const LinearForm& form) { return plus(form, constant_form(exactly(1))); }
  Equation& minus(const LinearForm& form) { return plus(negated(form)); }
  /// The bilinear product of two vectors.
  Equation& plus(const VectorForm& left, const VectorForm& right);
  Equation& minus(const VectorForm& left, const VectorForm& right) { return plus(negated(left), right); }
  /// The bilinear square of left − right.
  Equation& plus_square_of_difference(const VectorForm& left, const VectorForm& right);

  QuadraticEquation equals(const ExactNumber& given = {}) {
    equation_.given = given;
    return std::move(equation_);
  }

 private:
  QuadraticEquation equation_;
};

/// At x, in doubles.
std::complex<double> value_at(const LinearForm& form, const std::vector<std::complex<double>>& x);

}  // namespace gcs
