#pragma once
/// Random scenes of points, lines and planes whose construction plans have instructions of many kinds, with the values of
/// one random figure and the sketch of another.

#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/tests/random_numbers.hpp"

namespace gcs::samples {

/// States constraints with the values that a figure has. Elements by their numbers in the problem.
class MeasuredProblem {
 public:
  MeasuredProblem(int dimension, const Figure& figure);

  /// Of a point from a point, a line or a plane.
  MeasuredProblem& distance(int a, int b);
  /// Of lines and planes with each other.
  MeasuredProblem& angle(int a, int b);
  /// What has no value: "on", "parallel", "perpendicular".
  MeasuredProblem& holds(const std::string& type, int a, int b);

  /// The first points rest in the frame as a body.
  MeasuredProblem& at_rest(int points);

  const ProblemStatement& problem() const { return problem_; }

 private:
  void relate(const std::string& type, int a, int b, Relation::Form form, double value);

  ProblemStatement problem_;
  Figure figure_;
};

struct NamedProblem {
  std::string name;
  ProblemStatement problem;
};

/// One of each kind.
std::vector<NamedProblem> measured_scenes(RandomNumbers& random);

}  // namespace gcs::samples
