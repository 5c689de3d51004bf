#include "solvers/construction/hypotheses.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/model/interpolation.hpp"

namespace gcs {
namespace {

/// A length at an end of the support, which is a root to rounding times the condition of the root, and a length
/// of the sketch.
constexpr double rounding = 1e-9;

double size_of(const LengthPath& path) {
  double size = std::abs(path.at_sketch) + std::abs(path.at_target) + std::abs(path.bend);
  for (const double coefficient : path.higher) size += std::abs(coefficient);
  return size;
}

bool are_close(double a, double b, double size) { return std::abs(a - b) <= rounding * size; }

bool is_same_function(const LengthPath& a, const LengthPath& b) {
  const double size = size_of(a) + size_of(b);
  return are_close(a.at_sketch, b.at_sketch, size) && are_close(a.at_target, b.at_target, size) &&
         are_close(a.bend, b.bend, size) &&
         std::ranges::equal(a.higher, b.higher,
                            [&](double first, double second) { return are_close(first, second, size); });
}

bool vanishes_at(const LengthPath& path, double t) {
  return std::abs(path.value(t)) <= rounding * size_of(path) * std::max(1.0, std::abs(t));
}

int pairs_of_one_function(const std::vector<LengthPath>& lengths) {
  int pairs = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    for (std::size_t j = i + 1; j < lengths.size(); ++j)
      pairs += is_same_function(lengths[i], lengths[j]) ? 1 : 0;
  return pairs;
}

/// Of the instruction's given lengths.
int vanishing(const Instruction& instruction, const std::vector<LengthPath>& lengths, double t) {
  int count = 0;
  for (int i = 0; i < instruction.count; ++i) {
    const PlanSphere& sphere = instruction.spheres[i];
    count += !sphere.is_driven() && vanishes_at(lengths[sphere.constraint], t) ? 1 : 0;
  }
  return count;
}

bool has_driving_parameter(const Instruction& instruction) {
  return std::any_of(instruction.spheres.begin(), instruction.spheres.begin() + instruction.count,
                     [](const PlanSphere& sphere) { return sphere.is_driven(); });
}

}  // namespace

PlanHypotheses check_hypotheses(const Scene& scene, const Plan& plan, const Figure& sketch, double alpha) {
  const std::vector<LengthPath> lengths = scene.length_paths();
  const TimeRange support = positive_support(lengths);
  PlanHypotheses fails;
  fails.h3 = pairs_of_one_function(lengths);
  for (const double end : {support.low, support.high}) {
    if (!std::isfinite(end)) {
      ++fails.h2;
      continue;
    }
    for (const Instruction& instruction : plan.instructions()) {
      const int count = vanishing(instruction, lengths, end);
      if (instruction.count == 1) fails.h4 = std::max(fails.h4, count);
      if (count > 1) ++fails.h5;
      if (count > 0 && has_driving_parameter(instruction)) ++fails.h6;
    }
  }
  for (const Instruction& instruction : plan.instructions())
    if (boundary_distance(instruction, {alpha, false}, sketch.points) <= alpha) ++fails.h7;
  return fails;
}

}  // namespace gcs
