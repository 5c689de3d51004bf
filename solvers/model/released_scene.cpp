#include "solvers/model/released_scene.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solvers/model/complex_lines.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

/// Relative to the longest distance of given points. Lines beside points that are off a line by ε have
/// coordinates of up to 1/ε²: here those that doubles do not hold.
constexpr double narrow = 1e-6;
/// Relative to the same. The height of a triangle or a tetrahedron comes from distances with their rounding
/// over the height: two digits may be lost before a point is added instead.
constexpr double flat = 1e-2;

using Base = Eigen::Matrix<double, 3, 4>;

std::vector<int> given_points(const Scene& scene) {
  std::vector<int> points;
  for (int point = 0; point < scene.point_count(); ++point)
    if (scene.problem().is_fixed(point)) points.push_back(point);
  return points;
}

/// Three given points: the two that are furthest apart, and the one furthest from the line through them.
struct Triangle {
  std::array<int, 3> points{};
  double longest = 0;
  double height = 0;
};

Triangle large_triangle(const Scene& scene) {
  const std::vector<int> points = given_points(scene);
  Triangle triangle;
  for (const int a : points)
    for (const int b : points) {
      const double distance = (*scene.fixed_point(a) - *scene.fixed_point(b)).norm();
      if (distance > triangle.longest) triangle = {{b, a, -1}, distance, 0};
    }
  if (triangle.longest == 0) return triangle;
  const Eigen::Vector3d origin = *scene.fixed_point(triangle.points[0]);
  const Eigen::Vector3d along = (*scene.fixed_point(triangle.points[1]) - origin) / triangle.longest;
  for (const int point : points) {
    const double height = (*scene.fixed_point(point) - origin).cross(along).norm();
    if (height > triangle.height)
      triangle = {{triangle.points[0], triangle.points[1], point}, triangle.longest, height};
  }
  return triangle;
}

/// Two given points that are not further apart.
bool have_coinciding(const Scene& scene, double distance) {
  const std::vector<int> points = given_points(scene);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((*scene.fixed_point(points[i]) - *scene.fixed_point(points[j])).norm() <= distance) return true;
  return false;
}

/// The unit normal of the plane through three points.
Eigen::Vector3d normal(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b - a).cross(c - a).normalized();
}

/// |p − q|² = the square of the positions' distance, given in the file's unit.
DistanceConstraint distance_between(int p, int q, const Eigen::Vector3d& at_p, const Eigen::Vector3d& at_q,
                                    int unit_exponent) {
  const double square = squared_distance(at_p, at_q, 3).value();
  return {"", {p, q}, {std::ldexp(square, 2 * unit_exponent), ""}, true};
}

/// Proper rotations have rows r1 × r2 = r3, others r1 × r2 = −r3; entries may be large.
bool is_proper(const Eigen::Matrix3cd& rotation) {
  const Eigen::Vector3cd third = cross_product(rotation.row(0).transpose(), rotation.row(1).transpose());
  const Eigen::Vector3cd row = rotation.row(2).transpose();
  return (third - row).norm() <= (third + row).norm();
}

/// x ↦ target + rotation·(x − origin)
struct ComplexMotion {
  Eigen::Matrix3cd rotation;
  Eigen::Vector3cd origin;
  Eigen::Vector3cd target;

  ComplexPoints operator()(const ComplexPoints& points) const {
    return (rotation * (points.colwise() - origin)).colwise() + target;
  }
};

/// The motion, proper or not, from points at the distances of `to`. With differences of points as columns of
/// B and A and BᵀB = AᵀA it is R = A B⁻¹ = A⁻ᵀBᵀ: B, which may be large, is not inverted.
ComplexMotion motion(const Eigen::Matrix<std::complex<double>, 3, 4>& from, const Base& to) {
  const Eigen::Matrix3d a = to.rightCols<3>().colwise() - to.col(0);
  const Eigen::Matrix3cd b = from.rightCols<3>().colwise() - Eigen::Vector3cd(from.col(0));
  const Eigen::Matrix3d inverse = a.inverse().transpose();
  return {inverse.cast<std::complex<double>>() * b.transpose(), from.col(0),
          to.col(0).cast<std::complex<double>>()};
}

}  // namespace

std::optional<std::string> why_not_released(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (problem.lines.size() != 1 || problem.is_fixed(scene.point_count()))
    return "it seeks one line, whose position must not be given";
  const Triangle triangle = large_triangle(scene);
  if (have_coinciding(scene, narrow * triangle.longest))
    return "it needs given points in different places: of two in one place distances are no independent "
           "conditions";
  if (triangle.height <= narrow * triangle.longest)
    return "it needs three given points that are not on one line, to tie the rest to";
  return std::nullopt;
}

ReleasedScene::ReleasedScene(const Scene& given) : given_(given) {
  for (const int point : choose_base()) attached_.push_back(attached(point));
  free_.emplace(Scene::unchecked(released_problem()));
}

std::vector<int> ReleasedScene::choose_base() {
  const Triangle triangle = large_triangle(given_);
  std::vector<int> others = given_points(given_);
  const auto append = [&](int point) {
    base_.col(static_cast<int>(base_points_.size())) = given_position(point);
    base_points_.push_back(point);
    std::erase(others, point);
  };
  const auto add = [&](const Eigen::Vector3d& foot, const Eigen::Vector3d& direction) {
    base_.col(static_cast<int>(base_points_.size())) = foot + triangle.longest * direction;
    base_points_.push_back(given_.point_count() + added_points_++);
  };
  append(triangle.points[0]);
  append(triangle.points[1]);
  // Over one end: beside a symmetric base mirror images may lie so specially that lines escape to infinity.
  if (triangle.height > flat * triangle.longest)
    append(triangle.points[2]);
  else
    add(base_.col(0), (base_.col(1) - base_.col(0)).unitOrthogonal());
  const Eigen::Vector3d up = normal(base_.col(0), base_.col(1), base_.col(2));
  const auto height = [&](int point) { return std::abs(up.dot(given_position(point) - base_.col(0))); };
  const auto highest = std::ranges::max_element(others, {}, height);
  if (highest != others.end() && height(*highest) > flat * triangle.longest)
    append(*highest);
  else
    add(base_.leftCols<3>().rowwise().mean(), up);
  return others;
}

Eigen::Vector3d ReleasedScene::given_position(int point) const { return *given_.fixed_point(point); }

ReleasedScene::Attached ReleasedScene::attached(int point) const {
  constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  const Eigen::Vector3d position = given_position(point);
  const auto height = [&](const std::array<int, 3>& face) {
    const auto [a, b, c] = face;
    return std::abs(normal(base_.col(a), base_.col(b), base_.col(c)).dot(position - base_.col(a)));
  };
  return {point, *std::ranges::max_element(faces, {}, height)};
}

ProblemStatement ReleasedScene::released_problem() const {
  const ProblemStatement& given = given_.problem();
  ProblemStatement problem;
  problem.points = given.points;
  problem.lines = given.lines;
  problem.constraints = given.constraints;
  problem.points.resize(given.points.size() + static_cast<std::size_t>(added_points_));
  for (DistanceConstraint& constraint : problem.constraints)
    for (int& entity : constraint.between) entity += given.is_point(entity) ? 0 : added_points_;
  const int exponent = given_.unit_exponent();
  for (int p = 0; p < 4; ++p)
    for (int q = 0; q < p; ++q)
      problem.constraints.push_back(
          distance_between(base_points_[q], base_points_[p], base_.col(q), base_.col(p), exponent));
  for (const auto& [point, base] : attached_)
    for (const int place : base)
      problem.constraints.push_back(
          distance_between(base_points_[place], point, base_.col(place), given_position(point), exponent));
  return problem;
}

/// Nearer to its given position than to the mirror image.
bool ReleasedScene::is_where_given(const Attached& attached, const Eigen::Vector3cd& position) const {
  const auto [a, b, c] = attached.base;
  const Eigen::Vector3d up = normal(base_.col(a), base_.col(b), base_.col(c));
  const Eigen::Vector3d given = given_position(attached.point);
  const Eigen::Vector3d image = given - 2 * up * up.dot(given - base_.col(a));
  return (position - given.cast<std::complex<double>>()).norm() <=
         (position - image.cast<std::complex<double>>()).norm();
}

std::optional<Figure> ReleasedScene::carried_back(const Figure& figure) const {
  const int exponent = free_->unit_exponent() - given_.unit_exponent();
  ComplexPoints points = complex_points(figure) * std::ldexp(1.0, exponent);
  Eigen::Matrix<std::complex<double>, 3, 4> base = points(Eigen::all, base_points_);
  ComplexMotion back = motion(base, base_);
  if (!is_proper(back.rotation)) {  // the mirror image in y = 0, where the x-axis lies
    points.row(1) *= -1;
    base.row(1) *= -1;
    back = motion(base, base_);
  }
  points = back(points);
  const auto is_there = [&](const Attached& a) { return is_where_given(a, points.col(a.point)); };
  if (!std::all_of(attached_.begin(), attached_.end(), is_there)) return std::nullopt;
  const Eigen::Vector3cd origin = back(Eigen::Vector3cd::Zero());
  points.conservativeResize(3, given_.point_count());
  for (const int point : given_points(given_))
    points.col(point) = given_position(point).cast<std::complex<double>>();
  return figure_of(points, {normalised(ComplexLine{origin, back.rotation.col(0)})}, figure.is_real());
}

}  // namespace gcs
