#pragma once
/// Sharper enclosures of points on two spheres and a cylinder around the x-axis.

#include "solvers/scanning/form_contraction.hpp"
#include "solvers/scanning/form_placing.hpp"

namespace gcs {

/// Sharpens what is known of a point at given squared distances from two centres and, `axis_square`, from the
/// x-axis. With m the middle of what is known, δ the way on from it to the point, d_i the constant way from
/// centre i (or the axis) to m and v_i all of the way from there to the point but d_i,
///   2 d_i·δ = squares_i − |d_i|² − 2 d_i·(v_i − δ) − |v_i|².
/// Every point of the branch satisfies this: an enclosure put in on the right gives another one. What is
/// known of a centre enters it with its true weight. The better one is returned.
template <int N>
FormVector<N> sharpened_on_cylinder(const FormVector<N>& known, const std::array<FormSurface<N>, 2>& spheres,
                                    const AffineForm<N>& axis_square) {
  Eigen::Vector3d middle;
  FormVector<N> delta = known;
  std::array<double, 3> reach;
  for (int axis = 0; axis < 3; ++axis) {
    middle[axis] = known[axis].mid;
    delta[axis].mid = 0;
    reach[axis] = delta[axis].radius();
  }
  FormEquations<3, N> equations;
  const auto set = [&](int row, const Eigen::Vector3d& d, const FormVector<N>& rest_of_way,
                       const AffineForm<N>& from, const FormVector<N>& moved) {
    equations.matrix.row(row) = 2 * d;
    equations.terms.row(row) = 2 * d.cwiseAbs();
    equations.right[row] = from - square(constant_form<N>(d)) - 2 * dot(d, rest_of_way) - square(moved);
  };
  for (int i = 0; i < 2; ++i) {
    const FormVector<N>& center = spheres[i].vector;
    const Eigen::Vector3d d(middle[0] - center[0].mid, middle[1] - center[1].mid, middle[2] - center[2].mid);
    const FormVector<N> rest_of_way = constant_form<N>(middle) - constant_form<N>(d) - center;
    set(i, d, rest_of_way, spheres[i].number, delta + rest_of_way);
  }
  set(2, {0, middle[1], middle[2]}, {}, axis_square, {AffineForm<N>(), delta[1], delta[2]});
  const FormVector<N> sharp = constant_form<N>(middle) + equations.solve(reach);
  return unknown_of(sharp) < unknown_of(known) ? sharp : known;
}

}  // namespace gcs
