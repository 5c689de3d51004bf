#include "harness/tests/strategies/tangent_samples.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "harness/instances/instance_lookup.hpp"

namespace gcs {
namespace {

bool is_same(const AssessedSolution& a, const AssessedSolution& b) {
  const ComplexLine p = normalised(complex_lines(a.placement())[0]),
                    q = normalised(complex_lines(b.placement())[0]);
  const auto off = [&](const Eigen::Vector3cd& u) { return (p.direction - u).norm() / u.norm(); };
  return a.multiplicity == b.multiplicity && a.figure.is_real() == b.figure.is_real() &&
         std::min(off(q.direction), off(-q.direction)) <= 1e-9 &&
         (p.point - q.point).norm() <= 1e-9 * (1 + p.point.norm());
}

}  // namespace

ProblemStatement spheres(const Eigen::Matrix<double, 3, 4>& centers, const Eigen::Vector4d& distances) {
  ProblemStatement problem = load_instance("tangents-durand").problem;
  problem.fixed_texts.clear();
  for (int i = 0; i < 4; ++i) {
    problem.fixed_points[i] = Eigen::Vector3d(centers.col(i));
    problem.constraints[i].given = {distances[i], ""};
    problem.constraints[i].is_squared = false;
  }
  return problem;
}

FourDistances distances_of(const ProblemStatement& problem) {
  FourDistances given;
  for (int i = 0; i < 4; ++i) {
    given.centers.col(i) = *problem.fixed_points[i];
    given.lengths[i] = problem.constraints[i].given.value;
  }
  return given;
}

double Dice::operator()() { return 2 * static_cast<double>(engine_() >> 11) * 0x1p-53 - 1; }

Eigen::Matrix<double, 3, 4> Dice::centers() {
  return Eigen::Matrix<double, 3, 4>::NullaryExpr([this](Eigen::Index, Eigen::Index) { return (*this)(); });
}

Eigen::Vector4d Dice::distances() {
  return Eigen::Vector4d::NullaryExpr([this](Eigen::Index) { return 0.05 + std::abs((*this)()); });
}

Eigen::Vector3d Dice::direction() {
  return Eigen::Vector3d::NullaryExpr([this](Eigen::Index) { return (*this)(); }).normalized();
}

Eigen::Matrix3d Dice::rotation() {
  const Eigen::Vector3d axis = direction();
  return Eigen::AngleAxisd(3 * (*this)(), axis).toRotationMatrix();
}

ProblemStatement Dice::problem(const Eigen::Matrix3d& shape) {
  const Eigen::Matrix<double, 3, 4> at = shape * centers();
  return spheres(at, distances());
}

int real_ones(const SolveRun& run) {
  const auto& solutions = run.solutions;
  return static_cast<int>(std::count_if(solutions.begin(), solutions.end(),
                                        [](const AssessedSolution& s) { return s.figure.is_real(); }));
}

bool have_same_lines(const SolveRun& a, const SolveRun& b) {
  const auto &lines = a.solutions, &others = b.solutions;
  return lines.size() == others.size() &&
         std::all_of(lines.begin(), lines.end(), [&](const AssessedSolution& line) {
           return std::count_if(others.begin(), others.end(),
                                [&](const AssessedSolution& other) { return is_same(line, other); }) == 1;
         });
}

}  // namespace gcs
