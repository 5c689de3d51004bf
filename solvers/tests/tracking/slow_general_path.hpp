#pragma once
/// Another way to track S of general scenes: by geometry, in coordinates of its own, with tiny steps of Euler and Newton.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <utility>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs::samples {

/// Column i is point i of the body, as the file gives it. Precondition: it has nothing but points.
inline Eigen::Matrix3Xd points_of(const RigidBody& body) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(body.elements.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const std::vector<Decimal>& numbers = body.elements[static_cast<std::size_t>(i)].numbers;
    for (std::size_t axis = 0; axis < numbers.size(); ++axis)
      points(static_cast<Eigen::Index>(axis), i) = numbers[axis].value;
  }
  return points;
}

/// Of a scene of points and planes, or of two bodies. Precondition: the problem has a sketch and outlives this.
class SlowPath {
 public:
  explicit SlowPath(const ProblemStatement& problem) : problem_(problem), bent_(bent_lengths(problem)) {
    start_ = problem.bodies.empty() ? elements_of(*problem.sketch) : posture_of(*problem.sketch);
    at_sketch_ = values(start_);
  }

  /// The figures at t = 1 in the order met, as many as asked for, with the sign of dt.
  std::vector<std::pair<Figure, int>> crossings(std::size_t count) {
    constexpr double step = 1e-2;
    constexpr int most_steps = 50'000;
    Eigen::VectorXd z(start_.size() + 1);
    z << start_, 0;
    Eigen::VectorXd tangent = Eigen::VectorXd::Unit(z.size(), z.size() - 1);
    tangent = tangent_at(z, tangent);
    std::vector<std::pair<Figure, int>> found;
    for (int i = 0; i < most_steps && found.size() < count; ++i) {
      const Eigen::VectorXd before = z;
      z += step * tangent;
      correct(z, tangent);
      const double t0 = before[z.size() - 1] - 1, t1 = z[z.size() - 1] - 1;
      if ((t0 < 0) != (t1 < 0)) {
        Eigen::VectorXd at = before + (z - before) * (t0 / (t0 - t1));
        at[z.size() - 1] = 1;
        correct(at, Eigen::VectorXd::Unit(z.size(), z.size() - 1));
        found.emplace_back(figure(at), t1 > t0 ? 1 : -1);
      }
      tangent = tangent_at(z, tangent);
    }
    return found;
  }

 private:
  static Eigen::Quaterniond turn_of(const Eigen::VectorXd& z, Eigen::Index at) {
    return {z[at], z[at + 1], z[at + 2], z[at + 3]};
  }

  Eigen::VectorXd elements_of(const Figure& figure) const {
    std::vector<double> z(figure.points.data(), figure.points.data() + figure.points.size());
    for (const PlanePosition& plane : figure.planes) {
      z.insert(z.end(), plane.normal.begin(), plane.normal.end());
      z.push_back(plane.offset);
    }
    return Eigen::Map<Eigen::VectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
  }

  /// Of the second body as the first one sees it: shift, then a quaternion.
  Eigen::VectorXd posture_of(const Figure& figure) const {
    const Eigen::Index n = figure.points.cols() / 2;
    const Eigen::Matrix4d base =
                              Eigen::umeyama(points_of(problem_.bodies[0]), figure.points.leftCols(n), false),
                          moved = Eigen::umeyama(points_of(problem_.bodies[1]), figure.points.rightCols(n),
                                                 false);
    const Eigen::Matrix4d motion = base.inverse() * moved;
    const Eigen::Quaterniond turn(Eigen::Matrix3d(motion.topLeftCorner<3, 3>()));
    Eigen::VectorXd z(7);
    z << motion.topRightCorner<3, 1>(), turn.w(), turn.x(), turn.y(), turn.z();
    return z;
  }

  Figure figure(const Eigen::VectorXd& z) const {
    if (!problem_.bodies.empty()) {
      const Eigen::Matrix3Xd base = points_of(problem_.bodies[0]), moved = points_of(problem_.bodies[1]);
      Figure result{Eigen::Matrix3Xd(3, base.cols() + moved.cols()), {}};
      result.points << base,
          (turn_of(z, 3).toRotationMatrix() * moved).colwise() + Eigen::Vector3d(z.head<3>());
      return result;
    }
    const auto points = static_cast<Eigen::Index>(problem_.points.size());
    Figure result{Eigen::Map<const Eigen::Matrix3Xd>(z.data(), 3, points), {}};
    for (std::size_t i = 0; i < problem_.planes.size(); ++i) {
      const Eigen::Index at = 3 * points + 4 * static_cast<Eigen::Index>(i);
      result.planes.push_back({z.segment<3>(at), z[at + 3]});
    }
    return result;
  }

  /// Of all constraints, in the order of the problem.
  Eigen::VectorXd values(const Eigen::VectorXd& z) const {
    const Figure at = figure(z);
    std::vector<double> result;
    for (const DistanceConstraint& c : problem_.constraints)
      result.push_back((at.points.col(c.between[0]) - at.points.col(c.between[1])).norm());
    const auto plane = [&](const Operand& of) {
      return at.planes[static_cast<std::size_t>(problem_.plane_of(of.entity))];
    };
    for (const Relation& r : problem_.relations) {
      if (r.type == "angle")
        result.push_back(plane(r.of[0]).normal.dot(plane(r.of[1]).normal));
      else
        result.push_back(plane(r.of[1]).normal.dot(at.points.col(r.of[0].entity)) - plane(r.of[1]).offset);
    }
    return Eigen::Map<Eigen::VectorXd>(result.data(), static_cast<Eigen::Index>(result.size()));
  }

  double given(Eigen::Index i) const {
    const auto count = static_cast<Eigen::Index>(problem_.constraints.size());
    return i < count ? problem_.constraints[static_cast<std::size_t>(i)].given.value
                     : problem_.relations[static_cast<std::size_t>(i - count)].given.value;
  }

  /// Zero on S, and where the frame and the norms of normals and of the quaternion are.
  Eigen::VectorXd excess(const Eigen::VectorXd& z) const {
    const double t = z[z.size() - 1];
    Eigen::VectorXd f = values(z);
    for (Eigen::Index i = 0; i < f.size(); ++i) {
      f[i] -= (1 - t) * at_sketch_[i] + t * given(i);
      for (const BentLength& bent : bent_)
        if (bent.constraint == i) f[i] -= bent.coefficients[0] * t * (1 - t);
    }
    std::vector<double> rest;
    if (!problem_.bodies.empty()) {
      rest.push_back(turn_of(z, 3).squaredNorm() - 1);
      if (problem_.dimension == 2) rest.insert(rest.end(), {z[2], z[4], z[5]});
    } else {
      rest = {z[0] - start_[0], z[1] - start_[1], z[2] - start_[2],
              z[4] - start_[4], z[5] - start_[5], z[8] - start_[8]};
      for (const PlanePosition& plane : figure(z).planes) rest.push_back(plane.normal.squaredNorm() - 1);
    }
    Eigen::VectorXd all(f.size() + static_cast<Eigen::Index>(rest.size()));
    all << f, Eigen::Map<Eigen::VectorXd>(rest.data(), static_cast<Eigen::Index>(rest.size()));
    return all;
  }

  Eigen::MatrixXd derivatives(const Eigen::VectorXd& z) const {
    constexpr double change = 1e-6;
    Eigen::MatrixXd result(z.size() - 1, z.size());
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      const Eigen::VectorXd e = change * Eigen::VectorXd::Unit(z.size(), i);
      result.col(i) = (excess(z + e) - excess(z - e)) / (2 * change);
    }
    return result;
  }

  Eigen::MatrixXd bordered(const Eigen::VectorXd& z, const Eigen::VectorXd& last) const {
    Eigen::MatrixXd matrix(z.size(), z.size());
    matrix << derivatives(z), last.transpose();
    return matrix;
  }

  Eigen::VectorXd tangent_at(const Eigen::VectorXd& z, const Eigen::VectorXd& last) const {
    return bordered(z, last).partialPivLu().solve(Eigen::VectorXd::Unit(z.size(), z.size() - 1)).normalized();
  }

  void correct(Eigen::VectorXd& z, const Eigen::VectorXd& across) const {
    const auto factors = bordered(z, across).partialPivLu();
    for (int i = 0; i < 4; ++i) {
      Eigen::VectorXd f(z.size());
      f << excess(z), 0;
      z -= factors.solve(f);
    }
  }

  const ProblemStatement& problem_;
  std::vector<BentLength> bent_;
  Eigen::VectorXd start_, at_sketch_;
};

}  // namespace gcs::samples
