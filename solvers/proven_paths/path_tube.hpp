#pragma once
/// A tube around a piece of the path S that provably holds exactly one arc of it (parallelotope continuation:
/// Martin, Goldsztejn, Granvilliers, Jermann, Certified parallelotope continuation for one-manifolds, SIAM J.
/// Numer. Anal. 2013; Krawczyk tracking: van der Hoeven 2015; Duff, Lee 2024; Guillemot, Lairez 2024).
///
/// With c a Taylor polynomial of S and P as in curve_section.hpp, the tube is
///   {c(s) + P v : |s| ≤ h, |v_i| ≤ r_i},
/// and F(s, v) = f(c(s) + P v) are the equations of S in its coordinates, with ∂F/∂v = J P near the identity.
/// Krawczyk's operator with the identity as preconditioner,
///   K(s) = −F(s, 0) + (I − J(c(s) + P V) P) V,
/// lies inside V for every |s| ≤ h. Then for every s there is exactly one v(s) in V with F(s, v(s)) = 0, and
/// ∂F/∂v is regular there. As ν·c'(s) > 0 and ν·P = 0, s is a function of the point: the tube's solutions are
/// one arc without double points, S is regular on it ([I] (h1)), and s grows along it.
///
/// The equations are quadratic in X, so the bound on K costs sums over their products only: the matrices J P, its
/// first two derivatives along c, and bounds on the rest. All rounding is enclosed, and the proof holds for all
/// lengths and coefficients within the errors of EnclosedLength and EnclosedForm at once.

#include <Eigen/LU>

#include "solvers/proven_paths/curve_section.hpp"
#include "solvers/proven_paths/tube_series.hpp"

namespace gcs {

/// A point of the arc at a known s with the direction of growing s there, both enclosed. The point is
/// point + Gᵀ δ with |δ_i| ≤ 1 and `point` in its box: along the equations' level sets, where the point is
/// least certain, the entries of G belong together.
struct ArcPoint {
  PointBox point;
  Eigen::MatrixXd spread;  ///< G, m × (m + 1)
  PointBox tangent;

  /// A box that holds the point.
  PointBox hull() const;
};

struct ParameterRange {
  double low = 0;
  double high = 0;
};

/// What is proven of a point of S and a tube.
struct PlaceInTube {
  enum class Kind { outside, inside, unknown };
  Kind kind = Kind::unknown;
  ParameterRange s;  ///< inside: holds the point's s
};

class PathTube {
 public:
  PathTube(PathEquations equations, std::vector<EnclosedLength> lengths, int order);

  /// Takes c; false where J is singular in floating point. Nothing is proven yet.
  bool expand(const ArcSeries& c);
  /// A half length at which a proof may succeed.
  double promising_half_length() const;
  /// About the r with which a point of S that is known this well can be shown to lie in the tube.
  Eigen::ArrayXd room_for(const PointBox& box, const Eigen::MatrixXd& spread) const;
  /// Proves that the tube of half length h > 0 holds one arc, with r somewhat above what that and `room`
  /// need; false where the test fails. Everything below needs a proof.
  bool prove(double h, const Eigen::ArrayXd& room);

  double half_length() const { return bounds_.h; }
  const ArcSeries& curve() const { return series_.curve(); }
  /// A bound on |y_i − c_i(s)| for the points of the arc.
  Eigen::VectorXd radius() const;
  /// A bound on |y_i − c_i(0)| for the points of the arc.
  Eigen::VectorXd extent() const;
  /// A bound on |c̃_i(s) − c_i(s)| for |s| ≤ h, with c̃(s) as the polynomial is evaluated in floating point.
  Eigen::VectorXd polynomial_error() const;
  /// A bound on |c''(s)|.
  double turn() const { return coordinate_turn_.norm() * round_up; }
  /// Bounds on |t − t(c(s))| for the points of the arc, and on the difference of the derivatives by s.
  double time_radius() const { return time_radius_; }
  double time_speed_radius() const { return time_speed_radius_; }

  /// Where a point of S lies that is enclosed as in ArcPoint. `spread` may have no rows.
  PlaceInTube locate(const PointBox& box, const Eigen::MatrixXd& spread) const;
  /// The arc at |s| ≤ h, sharpened by Newton's method.
  ArcPoint at(double s) const;
  /// An enclosure of the arc's tangents within a range of s.
  PointBox tangent(const ParameterRange& range) const;

 private:
  bool is_plain(Eigen::Index equation) const {
    return series_.lengths()[static_cast<std::size_t>(equation)].is_plain;
  }
  void set_matrices();
  void set_differences();
  bool contracts(const Eigen::ArrayXd& room);
  void bound_arc();
  void set_weights(const Eigen::ArrayXd& v);
  void set_moves(const Eigen::ArrayXd& v);
  /// |I − J P| v, an upper bound over the tube of the last set_moves.
  Eigen::ArrayXd moved(const Eigen::ArrayXd& v) const;
  /// A bound on |v| for every v in V with |v| ≤ push + |I − J P| |v|.
  Eigen::ArrayXd resolved(const Eigen::ArrayXd& push) const;
  double ratio(const Eigen::ArrayXd& size) const { return (size / radius_).maxCoeff() * round_up; }
  void set_progress();
  void set_start_defect();
  void set_speed();
  PointBox polynomial_tangent(const ParameterRange& range) const;
  /// The transpose of J G on c(0), G being the transpose of `spread`.
  Eigen::MatrixXd in_section(const Eigen::MatrixXd& spread) const;
  /// f at y, and a bound on its error when the exact point is off by `error`.
  void residual(const Eigen::VectorXd& y, const Eigen::VectorXd& error, Eigen::ArrayXd& f,
                Eigen::ArrayXd& f_error) const;
  /// J P at y.
  Eigen::MatrixXd section_jacobian(const Eigen::VectorXd& y) const;
  double section_parameter(const Eigen::VectorXd& y) const;

  TubeSeries series_;
  CurveSection section_;
  TubeBounds bounds_;
  Eigen::MatrixXd differences_;           ///< |dD P| for every form D, m × forms: upper bounds
  Eigen::MatrixXd difference_errors_;     ///< of the computed dD P; nothing where forms are differences
  Eigen::MatrixXd jacobian_sizes_;        ///< |J| on c(0), with every product by its size
  Eigen::MatrixXd row_sizes_;             ///< |Pᵀ|
  Eigen::MatrixXd defect_, turn_, bend_;  ///< |I − J P|, |(J P)'|, |(J P)''|/2 at s = 0, transposed
  Eigen::ArrayXd radius_;                 ///< r
  Eigen::ArrayXd inner_radius_;           ///< of the arc itself
  Eigen::ArrayXd form_weights_, error_weights_, time_weights_;
  Eigen::MatrixXd moves_;                         ///< above |I − J P| on the tube, transposed
  Eigen::PartialPivLU<Eigen::MatrixXd> move_lu_;  ///< of I − moves_, for guesses that are then verified
  Eigen::VectorXd coordinate_size_, coordinate_speed_, coordinate_turn_;
  double contraction_ = 1;   ///< of Krawczyk's operator in the norm max |v_i|/r_i
  double start_defect_ = 1;  ///< of I − J P at s = 0 alone
  double progress_ = 0;      ///< below ν·c'(s)
  Eigen::ArrayXd speed_;     ///< |v'(s)|
  double time_radius_ = 0, time_speed_radius_ = 0;
};

}  // namespace gcs
