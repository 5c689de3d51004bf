#pragma once
/// The curve of figures that meet all equations but one, as the series tracker wants it.
///
/// With the value of equation e released the others, one fewer than unknowns, leave a curve. Its t is defined by
/// Σ left·right of equation e = given + c (t − 1), so that t = 1 where the value is met; c is the gradient's length at
/// a solution that it starts from, so that t changes by no more than the coordinates there. Of a distance t grows with its square: that is smooth
/// where the distance vanishes, and no curve ends there.
///
/// Mirror images and elements turned over are the same figure: where the curve comes to such an image of its start it is
/// closed, since it goes on as the image of what it was so far.

#include <vector>

#include "solvers/numeric/sign_masks.hpp"
#include "solvers/tracking/implicit_curve.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {

class ReleasedFamily {
 public:
  /// Begins at t = 1 at unknowns that meet all equations. Precondition: as many equations as unknowns.
  static ReleasedFamily at_solution(const RealEquations& equations, const SignMasks& signs,
                                    Eigen::Index released, const Eigen::VectorXd& solution, int order);
  /// Begins at t = 0 at unknowns that meet all equations but that one; c is such that it is met at t = 1.
  static ReleasedFamily at_figure(const RealEquations& equations, const SignMasks& signs,
                                  Eigen::Index released, const Eigen::VectorXd& x, int order);

  int unknowns() const { return unknowns_; }
  Eigen::VectorXd start() const { return start_; }
  void residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f);
  void wide_residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f);
  void jacobian(const Eigen::VectorXd& y, Eigen::MatrixXd& matrix);
  void start_series(double) {}
  void set(int n, const Eigen::Ref<const Eigen::VectorXd>& coefficient);
  void known(int n, Eigen::Ref<Eigen::VectorXd> result);
  /// No value but t changes.
  double shortest_length(double) const { return 1; }

  Eigen::VectorXd signs_towards(const Eigen::VectorXd& y0, const Eigen::VectorXd& y) const;

 private:
  struct Term {
    Eigen::Index unknown = 0;
    double coefficient = 0;
  };

  ReleasedFamily(const RealEquations& equations, const SignMasks& signs, Eigen::Index released, double scale,
                 Eigen::VectorXd start, int order);
  void add_form(const RealForm& form);
  void evaluate(const Eigen::VectorXd& y);
  DoubleDouble wide_form(Eigen::Index form, const Eigen::VectorXd& y) const;
  void changes(const Eigen::Ref<const Eigen::VectorXd>& y, Eigen::Ref<Eigen::VectorXd> forms) const;
  Eigen::Index left(Eigen::Index product) const { return product; }
  Eigen::Index right(Eigen::Index product) const { return product < squares_ ? product : product + pairs(); }
  Eigen::Index pairs() const { return std::ssize(equation_of_) - squares_; }

  int unknowns_;
  Eigen::Index released_;
  std::vector<Term>
      terms_;  ///< of all forms in turn: those of squares, left ones of other products, right ones
  std::vector<std::size_t> ends_{0};       ///< where those of each form end, after 0
  std::vector<double> constants_;          ///< of all forms
  std::vector<Eigen::Index> equation_of_;  ///< of all products, squares first
  Eigen::Index squares_ = 0;
  Eigen::VectorXd given_;
  SignMasks signs_;
  SignMask generators_;
  double scale_;  ///< c
  Eigen::VectorXd start_, forms_;
  Eigen::ArrayXd convolution_;
  Eigen::MatrixXd series_;  ///< (form, order)
};

class ReleasedCurve : public ImplicitCurve<ReleasedFamily> {
 public:
  using ImplicitCurve::ImplicitCurve;

  Eigen::VectorXd signs_towards(const Eigen::VectorXd& y0, const Eigen::VectorXd& y) const {
    return family().signs_towards(y0, y);
  }
};

}  // namespace gcs
