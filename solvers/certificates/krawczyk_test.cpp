#include "solvers/certificates/krawczyk_test.hpp"

#include <Eigen/LU>
#include <limits>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// Of the unknowns' size: a box around a solution needs room for what rounding leaves open of it.
constexpr double room = 0x1p-40;

constexpr int most_iterations = 12;

}  // namespace

std::optional<KrawczykImage<double>> KrawczykTest::image(const Box& box) const {
  const LinearisedSystem<double> f = linearised(system_, box.mid);
  const Eigen::MatrixXd inverse = f.jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return std::nullopt;
  return krawczyk_image(inverse, f, jacobian_radius(system_, box.mid, box.radius), box.radius);
}

std::optional<KrawczykImage<double>> KrawczykTest::image(const Eigen::MatrixXd& axes,
                                                         const SkewBox& box) const {
  return krawczyk_image_along(axes, linearised(system_, box.mid),
                              jacobian_radius(system_, box.mid, axes.cwiseAbs() * box.radius), box.radius);
}

bool KrawczykTest::refine(Eigen::VectorXd& x, std::int64_t& iterations) const {
  double previous = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_iterations; ++i) {
    const LinearisedSystem<double> f = linearised(system_, x);
    const Eigen::VectorXd correction = f.jacobian.partialPivLu().solve(f.value);
    const double length = correction.cwiseAbs().maxCoeff();
    ++iterations;
    if (!std::isfinite(length)) return false;
    x -= correction;
    if (length <= 4 * epsilon * size_) return true;
    if (length > previous / 2) return length <= room * size_;  // rounding alone is left
    previous = length;
  }
  return false;
}

/// The image of a box holds all of its solutions.
Box KrawczykTest::tightened(Box box) const {
  constexpr double worth_another = 0.95;
  constexpr int most_images = 40;
  for (int i = 0; i < most_images; ++i) {
    const auto now = image(box);
    if (!now) return box;
    const Eigen::VectorXd reach = now->reach().cwiseMin(box.radius);
    const bool is_last = reach.maxCoeff() > worth_another * box.radius.maxCoeff();
    box.radius = reach;
    if (is_last) return box;
  }
  return box;
}

std::optional<ProvenSolution> KrawczykTest::only_solution_around(const Box& box,
                                                                 std::int64_t& iterations) const {
  Eigen::VectorXd x = box.mid;
  if (!refine(x, iterations)) return std::nullopt;
  const Eigen::VectorXd around =
      ((box.radius + (x - box.mid).cwiseAbs()) * (1 + 4 * epsilon)).cwiseMax(room * size_);
  const auto now = image({x, around});
  if (!now || !now->is_inside(around)) return std::nullopt;
  return ProvenSolution{tightened({x, around}), around};
}

}  // namespace gcs
