#include "solvers/tracking/sketched_unknowns.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

/// x ↦ turn·x + shift.
struct Motion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const { return turn * point + shift; }
  PlanePosition operator()(const PlanePosition& plane) const {
    const Eigen::Vector3d normal = turn * plane.normal;
    return {normal, plane.offset + normal.dot(shift)};
  }
  Motion inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
};

/// A body as the file gives it, in the scene's unit: its points and planes, which tell its pose, by their entities.
struct GivenBody {
  std::vector<int> points, planes;
  Eigen::Matrix3Xd places;
  std::vector<PlanePosition> sides;
};

GivenBody given_body(const Scene& scene, const RigidBody& body) {
  const ProblemStatement& problem = scene.problem();
  GivenBody result;
  for (const BodyElement& element : body.elements) {
    const auto number = [&](std::size_t i) { return element.numbers[i].value; };
    if (problem.is_point(element.entity)) {
      result.points.push_back(element.entity);
      result.places.conservativeResize(3, result.places.cols() + 1);
      result.places.rightCols<1>().setZero();
      for (int axis = 0; axis < scene.dimension(); ++axis)
        result.places.rightCols<1>()[axis] =
            std::ldexp(number(static_cast<std::size_t>(axis)), -scene.unit_exponent());
    } else if (problem.is_plane(element.entity)) {
      const Eigen::Vector3d normal(number(0), number(1), number(2));
      const double offset = std::ldexp(number(3), -scene.unit_exponent());
      result.planes.push_back(problem.plane_of(element.entity));
      result.sides.push_back({normal.normalized(), offset / normal.norm()});
    }
  }
  return result;
}

/// The rigid motion that brings the body nearest to where the figure has it. Precondition: it has a point.
Motion nearest_motion(const Scene& scene, const GivenBody& body, const Figure& figure) {
  const Eigen::Matrix3Xd seen = figure.points(Eigen::all, body.points);
  const Eigen::Vector3d from = body.places.rowwise().mean(), to = seen.rowwise().mean();
  Eigen::Matrix3d product = (seen.colwise() - to) * (body.places.colwise() - from).transpose();
  for (std::size_t i = 0; i < body.planes.size(); ++i)
    product +=
        figure.planes[static_cast<std::size_t>(body.planes[i])].normal * body.sides[i].normal.transpose();
  if (scene.dimension() == 2) product(2, 2) += 1;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0)
    signs[scene.dimension() - 1] = -1;  // of the smallest singular value
  Motion motion;
  motion.turn = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  motion.shift = to - motion.turn * from;
  return motion;
}

/// With the bodies as the file gives them, near to where they are sketched.
Figure with_rigid_bodies(const Scene& scene, const Figure& figure) {
  Figure result = figure;
  for (const RigidBody& body : scene.problem().bodies) {
    const GivenBody given = given_body(scene, body);
    const Motion motion = nearest_motion(scene, given, figure);
    for (std::size_t i = 0; i < given.points.size(); ++i)
      result.points.col(given.points[i]) = motion(given.places.col(static_cast<Eigen::Index>(i)));
    for (std::size_t i = 0; i < given.planes.size(); ++i)
      result.planes[static_cast<std::size_t>(given.planes[i])] = motion(given.sides[i]);
  }
  return result;
}

/// Moved to where the body that the frame is put in rests, if it is put in one.
Figure with_body_at_rest(const Scene& scene, Figure figure) {
  const ProblemStatement& problem = scene.problem();
  if (problem.reference_body < 0 || scene.is_anchored()) return figure;
  const RigidBody& body = problem.bodies[static_cast<std::size_t>(problem.reference_body)];
  const Motion motion = nearest_motion(scene, given_body(scene, body), figure).inverse();
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i) figure.points.col(i) = motion(figure.points.col(i));
  for (LinePosition& line : figure.lines) line = {motion(line.point), motion.turn * line.direction};
  for (PlanePosition& plane : figure.planes) plane = motion(plane);
  return figure;
}

std::vector<Eigen::Index> without_value(const SceneSystem& system) {
  std::vector<Eigen::Index> equations;
  for (std::size_t e = 0; e < system.value_of().size(); ++e)
    if (system.value_of()[e] == no_value) equations.push_back(static_cast<Eigen::Index>(e));
  return equations;
}

}  // namespace

std::optional<SketchedUnknowns> sketched_unknowns(const Scene& scene, const SceneSystem& system) {
  constexpr int most_steps = 60;
  constexpr double settled = 1e-14, settled_at_all = 1e-10;
  const RealEquations equations = real_equations(system.equations());
  const std::vector<Eigen::Index> fixed = without_value(system);
  const ComplexValues sketched =
      system.coordinates(with_body_at_rest(scene, with_rigid_bodies(scene, *scene.sketch())));
  Eigen::VectorXd x(equations.unknowns);
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = sketched[static_cast<std::size_t>(i)].real();
  const Eigen::VectorXd start = x;
  Eigen::MatrixXd jacobian(equations.count(), equations.unknowns);
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps && !fixed.empty(); ++i) {
    equations.jacobian(x, jacobian);
    const Eigen::VectorXd excess = equations.sums(x) - equations.given;
    const Eigen::VectorXd step =
        jacobian(fixed, Eigen::all).completeOrthogonalDecomposition().solve(Eigen::VectorXd(excess(fixed)));
    x -= step;
    const double size = step.norm() / (1 + x.norm());
    if (!std::isfinite(size)) return std::nullopt;
    const bool is_over = size <= settled || (size <= settled_at_all && size > last / 2);
    if (is_over) break;
    if (i + 1 == most_steps) return std::nullopt;
    last = size;
  }
  return SketchedUnknowns{x, (x - start).lpNorm<Eigen::Infinity>()};
}

}  // namespace gcs
