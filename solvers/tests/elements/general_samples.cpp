#include "solvers/tests/elements/general_samples.hpp"

namespace gcs::samples {
namespace {

RigidBody random_body(const std::string& name, int first_point, int count, int dimension,
                      RandomNumbers& random) {
  RigidBody body{name, {}};
  for (int i = 0; i < count; ++i) {
    BodyElement element{first_point + i, {}};
    for (int axis = 0; axis < dimension; ++axis) element.numbers.push_back({random.uniform(-1, 1), ""});
    body.elements.push_back(element);
  }
  return body;
}

}  // namespace

Eigen::Quaterniond random_turn(int dimension, RandomNumbers& random) {
  if (dimension == 2)
    return Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(-3, 3), Eigen::Vector3d::UnitZ()));
  const double w = random.uniform(-1, 1);
  const Eigen::Vector3d axis = random.point(3, 1);
  return Eigen::Quaterniond(w, axis.x(), axis.y(), axis.z()).normalized();
}

ProblemStatement random_platform(int dimension, RandomNumbers& random) {
  const int legs = dimension == 3 ? 6 : 3;
  ProblemStatement problem;
  problem.dimension = dimension;
  for (int i = 0; i < 2 * legs; ++i) problem.points.push_back("p" + std::to_string(i));
  for (const int body : {0, 1})
    problem.bodies.push_back(random_body("b" + std::to_string(body), body * legs, legs, dimension, random));
  problem.reference_body = 0;
  const Eigen::Quaterniond turn = random_turn(dimension, random);
  const Eigen::Vector3d shift = random.point(dimension, 2);
  const auto given = [&](int body, int i) {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    const BodyElement& element =
        problem.bodies[static_cast<std::size_t>(body)].elements[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < dimension; ++axis)
      at[axis] = element.numbers[static_cast<std::size_t>(axis)].value;
    return at;
  };
  for (int i = 0; i < legs; ++i)
    problem.constraints.push_back({"leg" + std::to_string(i),
                                   {i, legs + i},
                                   {(turn * given(1, i) + shift - given(0, i)).norm(), ""},
                                   false});
  return problem;
}

ProblemStatement random_octahedral(int planes, RandomNumbers& random) {
  const int points = 6 - planes;
  ProblemStatement problem;
  const Eigen::Matrix3Xd places = random.points(3, points, 2);
  std::vector<PlanePosition> sides;
  for (int i = 0; i < points; ++i) problem.points.push_back("p" + std::to_string(i));
  for (int i = 0; i < planes; ++i) {
    problem.planes.push_back("h" + std::to_string(i));
    sides.push_back({random.point(3, 1).normalized(), random.uniform(-1, 1)});
  }
  problem.reference = Reference{0, 1, 2};
  const auto side = [&](int i) { return sides[static_cast<std::size_t>(i - points)]; };
  for (int a = 0; a < 6; ++a)
    for (int b = a + 1; b < 6; ++b) {
      if (b == a + 3) continue;
      const std::string id = "c" + std::to_string(6 * a + b);
      if (b < points)
        problem.constraints.push_back({id, {a, b}, {(places.col(a) - places.col(b)).norm(), ""}, false});
      else if (a < points)
        problem.relations.push_back({id,
                                     "distance",
                                     {{a}, {b}},
                                     Relation::Form::length,
                                     {side(b).normal.dot(places.col(a)) - side(b).offset, ""}});
      else
        problem.relations.push_back(
            {id, "angle", {{a}, {b}}, Relation::Form::cosine, {side(a).normal.dot(side(b).normal), ""}});
    }
  return problem;
}

ProblemStatement bodies_of(const Eigen::Matrix3Xd& points, const std::vector<std::vector<int>>& bodies,
                           RandomNumbers& random) {
  ProblemStatement problem;
  for (Eigen::Index i = 0; i < points.cols(); ++i) problem.points.push_back("p" + std::to_string(i));
  for (const std::vector<int>& has : bodies) {
    RigidBody body{"b" + std::to_string(problem.bodies.size()), {}};
    const Eigen::Quaterniond turn = random_turn(3, random);
    const Eigen::Vector3d shift = random.point(3, 1);
    for (const int point : has) {
      const Eigen::Vector3d given = points.col(point);
      const Eigen::Vector3d at = problem.bodies.empty() ? given : Eigen::Vector3d(turn * given + shift);
      body.elements.push_back({point, {{at.x(), ""}, {at.y(), ""}, {at.z(), ""}}});
    }
    problem.bodies.push_back(body);
  }
  problem.reference_body = 0;
  return problem;
}

ProblemStatement ring_of(const Eigen::Matrix3Xd& points, RandomNumbers& random) {
  const auto count = static_cast<int>(points.cols());
  std::vector<std::vector<int>> bodies;
  for (int i = 0; i < count; i += 2) bodies.push_back({i, i + 1, (i + 2) % count, (i + 3) % count});
  return bodies_of(points, bodies, random);
}

ProblemStatement point_at_an_angle(double degrees) {
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"o", "a", "b", "c"};
  problem.reference = Reference{0, 2};
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
    problem.constraints.push_back({std::to_string(i) + std::to_string(j), {i, j}, {1, ""}, false});
  problem.constraints.push_back({"ac", {1, 3}, {1.2, ""}, false});
  problem.relations = {{"aoc", "angle", {{0, 1}, {0, 3}}, Relation::Form::degrees, {degrees, ""}}};
  return problem;
}

}  // namespace gcs::samples
