#pragma once
/// Newton's method and Krawczyk's test in balls of any precision, for every quadratic system.

#include <complex>
#include <limits>
#include <optional>
#include <vector>

#include "solvers/model/enclosure.hpp"
#include "solvers/model/quadratic_system.hpp"
#include "solvers/numeric/balls.hpp"

namespace gcs {

/// A system at one precision.
class BallKrawczyk {
 public:
  BallKrawczyk(const QuadraticSystem& system, slong bits);

  slong bits() const { return bits_; }
  int unknowns() const { return unknowns_; }

  /// The numbers as a column.
  static BallMatrix vector(const std::vector<std::complex<double>>& x);
  struct Newton {
    BallMatrix x;                                                 ///< a point
    double correction = std::numeric_limits<double>::infinity();  ///< the last one, relative to the size of x
    bool is_singular = false;                                     ///< the Jacobian at x is
    bool converged = false;  ///< the last correction is below half the precision
  };
  /// Newton's method from a point x.
  Newton refined(const BallMatrix& x) const;

  struct Proof {
    BallMatrix solution;  ///< a ball for every unknown
    double unique = 0;    ///< no other solution has all |x_i − mid_i| at most this
  };
  /// Proves that there is a solution next to the point x, alone in its surroundings; real where x and the
  /// system are.
  std::optional<Proof> prove(const BallMatrix& x) const;

  /// f(x): encloses all values.
  BallMatrix value(const BallMatrix& x) const;
  BallMatrix jacobian(const BallMatrix& x) const;

 private:
  struct Term {
    int unknown;
    std::size_t coefficient;  ///< number of a ball in numbers_
  };
  struct Form {
    std::vector<Term> terms;
    std::size_t constant;
  };
  struct Product {
    Form left;
    Form right;
  };
  struct Equation {
    std::vector<Product> products;
    std::size_t given;
  };

  std::size_t number(const ExactNumber& exact);
  Form form(const LinearForm& exact);
  acb_srcptr at(std::size_t number) const { return numbers_[number](0, 0); }
  void evaluate(const Form& form, const BallMatrix& x, acb_ptr value) const;
  void add_gradient(const Form& form, acb_srcptr factor, slong row, BallMatrix& jacobian) const;
  /// The largest row sum of |inverse| times how far the Jacobian moves when every x_i moves by 1.
  double bend(const BallMatrix& inverse) const;
  /// x ± radius; in the real part alone where the system and x are real.
  BallMatrix box_around(const BallMatrix& x, double radius) const;
  /// x − correction + (1 − inverse·J(box))(box − x), the correction being inverse·f(x)
  BallMatrix image(const BallMatrix& x, const BallMatrix& correction, const BallMatrix& inverse,
                   const BallMatrix& box) const;

  int unknowns_;
  slong bits_;
  std::vector<Equation> equations_;
  std::vector<BallMatrix> numbers_;  ///< of one entry each
  bool is_real_ = true;
};

/// The proof in doubles, rounded outwards.
Enclosure enclosure_of(const BallKrawczyk::Proof& proof);

}  // namespace gcs
