#include "solvers/elements/random_figure.hpp"

#include <Eigen/Geometry>

#include "solvers/elements/body_motion.hpp"

namespace gcs {
namespace {

class RandomElements {
 public:
  RandomElements(int dimension, double reach, std::mt19937_64& random)
      : dimension_(dimension), reach_(reach), random_(random) {}

  Eigen::Vector3d point() {
    std::uniform_real_distribution<double> coordinate(-reach_, reach_);
    return vector([&] { return coordinate(random_); });
  }
  Eigen::Vector3d direction() {
    std::normal_distribution<double> normal;
    return vector([&] { return normal(random_); }).normalized();
  }
  Eigen::Matrix3d rotation() {
    std::normal_distribution<double> normal;
    Eigen::Quaterniond turn(normal(random_), 0, 0, normal(random_));
    if (dimension_ == 3) turn.vec().head<2>() = Eigen::Vector2d(normal(random_), normal(random_));
    return turn.normalized().toRotationMatrix();
  }

 private:
  template <class Number>
  Eigen::Vector3d vector(const Number& number) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < dimension_; ++axis) result[axis] = number();
    return result;
  }

  int dimension_;
  double reach_;
  std::mt19937_64& random_;
};

}  // namespace

Figure random_figure(const Scene& scene, double reach, std::mt19937_64& random) {
  RandomElements elements(scene.dimension(), reach, random);
  Figure figure;
  figure.points.resize(3, scene.point_count());
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i) figure.points.col(i) = elements.point();
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < scene.problem().bodies.size(); ++i) {
    const Eigen::Matrix3d rotation = elements.rotation();
    motions.push_back({rotation, elements.point()});
  }
  for (std::size_t i = 0; i < scene.problem().lines.size(); ++i) {
    const Eigen::Vector3d through = elements.point();
    figure.lines.push_back({through, elements.direction()});
  }
  for (std::size_t i = 0; i < scene.problem().planes.size(); ++i) {
    const Eigen::Vector3d normal = elements.direction();
    figure.planes.push_back({normal, normal.dot(elements.point())});
  }
  for (std::size_t i = 0; i < motions.size(); ++i)
    for (const BodyElement& element : scene.problem().bodies[i].elements)
      put(scene.problem(), element.entity,
          motions[i](position_in_body(scene.problem(), element, -scene.unit_exponent())), figure);
  return figure;
}

}  // namespace gcs
