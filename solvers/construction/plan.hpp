#pragma once
/// Reparameterised construction plans, [I] Definitions 2 and 3: points are placed one by one as intersections
/// of spheres (circles in the plane); a sphere whose radius is a driving parameter is centred at a fixed copy
/// of a point.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "solvers/model/interpolation.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

/// One argument pair (p, a) of an instruction.
struct PlanSphere {
  int center = -1;      ///< the point named; for a driven sphere `reference` stands in for it
  int constraint = -1;  ///< whose length is the radius; −1: driven
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();  ///< the fixed copy p' of a driven sphere

  bool is_driven() const { return constraint < 0; }
};

/// `place` at the intersection of `count` spheres: 1 interCL/interSL, 2 interCC/interSSP, 3 interSSS, which
/// is interSS of the first two and then interCS with the third. count is also the number of coordinates that
/// the frame leaves to the point. count 0: the origin.
struct Instruction {
  int place = -1;
  int count = 0;
  std::array<PlanSphere, 3> spheres;
  int side = 1;  ///< the branch b_i: which of the two intersections
  /// The table T of [I] §4.3.1 for the spheres that can be exchanged (1 and 2): the original one, if
  /// exchanged.
  std::array<std::optional<PlanSphere>, 3> original;
};

/// Driving parameters are numbered in the order of the instructions, so that parameter j matters only from
/// the instruction that introduces it on.
class Plan {
 public:
  Plan() = default;
  /// `constraints`: how many the problem has. Points that no instruction places must be fixed in the scene.
  Plan(int dimension, int constraints, std::vector<Instruction> instructions);

  int dimension() const { return dimension_; }
  const std::vector<Instruction>& instructions() const { return instructions_; }
  std::vector<Instruction>& instructions() { return instructions_; }

  /// C−: the constraints that no instruction uses; as many as driving parameters.
  const std::vector<int>& removed() const { return removed_; }
  int driving_parameters() const { return driven_before_.back(); }
  /// Driving parameters introduced before instruction k; k may be one past the last.
  int driven_before(std::size_t k) const { return driven_before_[k]; }
  /// To be called after a change of the instructions' spheres.
  void renew_indices();

  /// The frame in which the plan builds: its first points as origin, axis and plane.
  Reference frame() const;

 private:
  int dimension_ = 3;
  int constraints_ = 0;
  std::vector<Instruction> instructions_;
  std::vector<int> removed_;
  std::vector<int> driven_before_{0};
};

/// Centre of a sphere in a figure.
inline Eigen::Vector3d center_of(const PlanSphere& sphere, const Eigen::Matrix3Xd& points) {
  if (sphere.is_driven()) return sphere.reference;
  return points.col(sphere.center);
}

/// Radius of sphere `slot` of an instruction in a figure.
inline double radius_of(const Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  return (points.col(instruction.place) - center_of(instruction.spheres[slot], points)).norm();
}

/// Places one point: the intersection of the instruction's spheres with these radii on its branch; false
/// where it is empty. `points` holds the centres and receives the point.
bool place(const Instruction& instruction, const std::array<double, 3>& radii, Eigen::Matrix3Xd& points);

/// Evaluates the plan from instruction `first` on into `points`, which holds the points placed before.
/// `radius(sphere, j)` is a sphere's radius, j the number of its driving parameter if it is driven. False
/// outside the plan's domain.
template <class RadiusOf>
bool evaluate_plan(const Plan& plan, std::size_t first, const RadiusOf& radius, Eigen::Matrix3Xd& points) {
  for (std::size_t k = first; k < plan.instructions().size(); ++k) {
    const Instruction& instruction = plan.instructions()[k];
    int driven = plan.driven_before(k);
    std::array<double, 3> radii{};
    for (int i = 0; i < instruction.count; ++i) {
      const PlanSphere& sphere = instruction.spheres[i];
      radii[i] = radius(sphere, sphere.is_driven() ? driven++ : -1);
    }
    if (!place(instruction, radii, points)) return false;
  }
  return true;
}

/// The branch of the instruction on which the figure lies (+1 or −1).
int side_of(const Instruction& instruction, const Eigen::Matrix3Xd& points);

}  // namespace gcs
