#include "solvers/tangents/tangent_equations.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gcs {
namespace {

/// Which centre takes which part: the first is the origin, the next two span the plane.
using Roles = std::array<int, 4>;

struct Triangle {
  Roles roles{};
  double area = -1;
  double width = 0;
};

/// The triangle with its origin opposite the longest side, where the angle is nearest to a right one.
Triangle triangle_without(const FourSpheres& spheres, int left_out) {
  const int a = (left_out + 1) % 4, b = (left_out + 2) % 4, c = (left_out + 3) % 4;
  const auto side = [&](int p, int q) { return (spheres[p].center - spheres[q].center).norm(); };
  const std::array<double, 3> opposite{side(b, c), side(c, a), side(a, b)};
  const auto longest = std::max_element(opposite.begin(), opposite.end()) - opposite.begin();
  std::array<int, 3> corners{a, b, c};
  std::rotate(corners.begin(), corners.begin() + longest, corners.end());
  Triangle triangle;
  triangle.roles = {corners[0], corners[1], corners[2], left_out};
  const Eigen::Vector3d& origin = spheres[corners[0]].center;
  triangle.area = (spheres[corners[1]].center - origin).cross(spheres[corners[2]].center - origin).norm();
  const double length = opposite[static_cast<std::size_t>(longest)];
  triangle.width = length > 0 ? triangle.area / (length * length) : 0;
  return triangle;
}

Triangle largest_triangle(const FourSpheres& spheres) {
  Triangle largest;
  for (int left_out = 0; left_out < 4; ++left_out)
    if (const Triangle triangle = triangle_without(spheres, left_out); triangle.area > largest.area)
      largest = triangle;
  return largest;
}

/// (a·u) as a form.
TernaryLinearForm linear_form(const Eigen::Vector3d& a) { return {a[2], a[0], a[1]}; }

/// u·(matrix u), the matrix symmetric.
QuadraticForm quadratic_form(const Eigen::Matrix3d& matrix) {
  QuadraticForm form;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      form[monomial_number((i == 0) + (j == 0), (i == 1) + (j == 1))] = (i == j ? 1 : 2) * matrix(i, j);
  return form;
}

}  // namespace

Eigen::Matrix3d distance_matrix(const Eigen::Vector3d& c, DoubleDouble first_square, DoubleDouble square) {
  const double constant = c.squaredNorm() + (first_square - square).value();
  return 0.5 * (constant * Eigen::Matrix3d::Identity() - c * c.transpose());
}

double relative_width(const FourSpheres& spheres) { return largest_triangle(spheres).width; }

TangentEquations::TangentEquations(const FourSpheres& spheres, const Eigen::Matrix3d& turn) : turn_(turn) {
  const Roles roles = largest_triangle(spheres).roles;
  const Sphere& first = spheres[roles[0]];
  origin_ = first.center;
  std::array<Eigen::Vector3d, 3> c;
  std::array<QuadraticForm, 3> b;
  for (int i = 0; i < 3; ++i) {
    const Sphere& sphere = spheres[roles[i + 1]];
    c[i] = turn * (sphere.center - origin_);
    b[i] = quadratic_form(distance_matrix(c[i], first.square, sphere.square));
  }
  normal_ = c[0].cross(c[1]).normalized();
  const Eigen::Vector3d across_1 = c[1].cross(normal_), across_2 = normal_.cross(c[0]);
  dual_ = {across_1 / across_1.dot(c[0]), across_2 / across_2.dot(c[1])};
  b_ = {b[0], b[1]};
  h_ = c[2].dot(normal_);
  kappa_ = b[2] - c[2].dot(dual_[0]) * b[0] - c[2].dot(dual_[1]) * b[1];
  l_ = linear_form(normal_);
  s_ = form_product<2, 1>(b[0], linear_form(dual_[0])) + form_product<2, 1>(b[1], linear_form(dual_[1]));
  const QuadraticForm unit = quadratic_form(Eigen::Matrix3d::Identity());  // u·u
  rho_ = first.square.value() * form_product<2, 2>(unit, unit) -
         dual_[0].squaredNorm() * form_product<2, 2>(b[0], b[0]) -
         2 * dual_[0].dot(dual_[1]) * form_product<2, 2>(b[0], b[1]) -
         dual_[1].squaredNorm() * form_product<2, 2>(b[1], b[1]);
}

template <class Scalar>
Tangent<Scalar> line_through(const Eigen::Matrix<Scalar, 3, 1>& u,
                             const Eigen::Matrix<Scalar, 3, 1>& scaled_point, const Eigen::Vector3d& origin) {
  const Scalar uu = (u.transpose() * u).value();
  Tangent<Scalar> line;
  line.direction = u / std::sqrt(uu);
  line.point = scaled_point / uu + origin.cast<Scalar>();
  line.point -= line.direction * (line.direction.transpose() * line.point).value();
  return line;
}

template <class Scalar>
Tangent<Scalar> TangentEquations::line(const Eigen::Matrix<Scalar, 3, 1>& turned_u, Scalar tau) const {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  const Vector scaled_point = form_value<2>(b_[0], turned_u) * dual_[0].cast<Scalar>() +
                              form_value<2>(b_[1], turned_u) * dual_[1].cast<Scalar>() +
                              tau * normal_.cast<Scalar>();
  const Eigen::Matrix<Scalar, 3, 3> back = turn_.transpose().cast<Scalar>();
  return line_through<Scalar>(back * turned_u, back * scaled_point, origin_);
}

template Tangent<double> line_through(const Eigen::Vector3d&, const Eigen::Vector3d&, const Eigen::Vector3d&);
template Tangent<std::complex<double>> line_through(const Eigen::Vector3cd&, const Eigen::Vector3cd&,
                                                    const Eigen::Vector3d&);
template Tangent<double> TangentEquations::line(const Eigen::Vector3d&, double) const;
template Tangent<std::complex<double>> TangentEquations::line(const Eigen::Vector3cd&,
                                                              std::complex<double>) const;

}  // namespace gcs
