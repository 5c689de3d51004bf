#pragma once
/// Random general scenes whose numbers of solutions are known, without a sketch.

#include <Eigen/Geometry>
#include <vector>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/tests/random_numbers.hpp"

namespace gcs::samples {

/// In the plane about the third axis.
Eigen::Quaterniond random_turn(int dimension, RandomNumbers& random);

/// Two random bodies, leg i between point i of each, as long as it is where the second body stands.
ProblemStatement random_platform(int dimension, RandomNumbers& random);

/// Six elements, all pairs but 0–3, 1–4, 2–5; the last `planes` of them are planes. Values of a random figure.
ProblemStatement random_octahedral(int planes, RandomNumbers& random);

/// Bodies of these points, each in a position of its own but for the first. The points as they stand are a solution.
ProblemStatement bodies_of(const Eigen::Matrix3Xd& points, const std::vector<std::vector<int>>& bodies,
                           RandomNumbers& random);

/// As many bodies in a ring as there are pairs of columns, each hinged to the next: body i has the pairs i and i + 1.
ProblemStatement ring_of(const Eigen::Matrix3Xd& points, RandomNumbers& random);

/// In the plane: c is at an angle from a as seen from o, and on a circle about a that o is inside of, so that the line
/// through o in that direction meets it on the ray and on the opposite one. o, a, b are a regular triangle.
ProblemStatement point_at_an_angle(double degrees);

}  // namespace gcs::samples
