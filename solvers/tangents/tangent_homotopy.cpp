#include "solvers/tangents/tangent_homotopy.hpp"

#include <algorithm>
#include <numbers>

#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/numeric/dense_factors.hpp"
#include "solvers/tangents/squeezed_tangents.hpp"
#include "solvers/tangents/tangent_algebra.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
constexpr int unknowns = TangentHomotopy::unknowns;
using Vector = ComplexVector<unknowns>;

/// x² − 1, m − y², n − g², y³ − 1, n² − 1: weights 2, 2, 2, 3 and 4.
SystemValue<unknowns> start_system(const Vector& at) {
  const Complex x = at[0], y = at[1], g = at[2], m = at[3], n = at[4];
  SystemValue<unknowns> system;
  system.value << x * x - 1.0, m - y * y, n - g * g, y * y * y - 1.0, n * n - 1.0;
  system.jacobian.setZero();
  system.jacobian(0, 0) = 2.0 * x;
  system.jacobian(1, 1) = -2.0 * y;
  system.jacobian(1, 3) = 1;
  system.jacobian(2, 2) = -2.0 * g;
  system.jacobian(2, 4) = 1;
  system.jacobian(3, 1) = 3.0 * y * y;
  system.jacobian(4, 4) = 2.0 * n;
  return system;
}

double largest(const Eigen::Matrix3d& matrix) { return matrix.cwiseAbs().maxCoeff(); }

}  // namespace

TangentHomotopy::TangentHomotopy(const FourSpheres& spheres, std::mt19937_64& random)
    : origin_(spheres[0].center), square_(spheres[0].square.value()), gamma_(random_phase(random)) {
  Eigen::Matrix3d centers;
  for (int i = 0; i < 3; ++i) centers.col(i) = spheres[i + 1].center - origin_;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(centers);
  frame_ = orthogonal_factor(decomposition);
  const Eigen::Matrix3d r = decomposition.matrixR().triangularView<Eigen::Upper>();
  std::array<Eigen::Matrix3d, 3> b;
  for (int i = 0; i < 3; ++i) {
    const int sphere = decomposition.colsPermutation().indices()[i] + 1;
    b[i] = distance_matrix(r.col(i), spheres[0].square, spheres[sphere].square);
  }
  along_ = b[0] / r(0, 0);
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix3d across = b[i + 1] - r(0, i + 1) * along_;
    const double size = std::max(largest(across), r.col(i + 1).tail<2>().cwiseAbs().maxCoeff());
    across_[i] = across / size;
    weight_[i] = r.col(i + 1).tail<2>() / size;
  }
  for (int axis = 0; axis < 3; ++axis) patch_[axis] = random_phase(random);
}

SystemValue<unknowns> TangentHomotopy::target(const Vector& x) const {
  const Eigen::Vector3cd u = x.head<3>(), along_u = along_ * u, p = scaled_point(x);
  const Complex on_patch = bilinear_product(patch_, u), uu = bilinear_product(u, u);
  SystemValue<unknowns> system;
  system.value[0] = on_patch * on_patch - 1.0;
  system.jacobian.row(0) << 2.0 * on_patch * patch_.transpose(), 0, 0;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3cd across_u = across_[i] * u;
    system.value[1 + i] = weight_[i][0] * p[1] + weight_[i][1] * p[2] - bilinear_product(u, across_u);
    system.jacobian.row(1 + i) << -2.0 * across_u.transpose(), weight_[i].transpose();
  }
  system.value[3] = bilinear_product(p, u);
  system.jacobian.row(3) << 2.0 * u[0] * along_u.transpose() + p.transpose(), u[1], u[2];
  system.value[4] = bilinear_product(p, p) - square_ * uu * uu;
  system.jacobian.row(4) << 4.0 * (p[0] * along_u - square_ * uu * u).transpose(), 2.0 * p[1], 2.0 * p[2];
  return system;
}

Eigen::Vector3cd TangentHomotopy::scaled_point(const Vector& x) const {
  const Eigen::Vector3cd u = x.head<3>();
  return {bilinear_product(u, along_ * u), x[3], x[4]};
}

ComplexTangent TangentHomotopy::line(const Vector& x) const {
  const Eigen::Vector3cd u = x.head<3>();
  return line_through<Complex>(frame_ * u, frame_ * scaled_point(x), origin_);
}

bool TangentHomotopy::is_at_infinity(const Vector& x) const {
  return nearness_to_isotropic(Eigen::Vector3cd(x.head<3>())) <= isotropic;
}

HomotopyValue<unknowns> TangentHomotopy::at(const Vector& x, Complex t) const {
  return straight_line(start_system(x), target(x), gamma_, t);
}

std::vector<Vector> TangentHomotopy::starts() {
  const auto root = [](int k, int n) { return std::polar(1.0, 2 * std::numbers::pi * k / n); };
  std::vector<Vector> result;
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 3; ++y)
      for (int g = 0; g < 4; ++g)  // g⁴ = n² = 1
        result.emplace_back(Vector{{root(x, 2), root(y, 3), root(g, 4), root(2 * y, 3), root(2 * g, 4)}});
  return result;
}

namespace {

/// What is left of the paths to the lines of the widened spheres when these are squeezed.
void squeeze(const FourSpheres& spheres, const Strip& strip, const TangentEnds& ends, std::mt19937_64& random,
             FollowedTangents& followed, WorkCounters& work) {
  const FoundTangents wide = std::move(followed.found);
  SqueezedTangents squeezed = squeezed_tangents(spheres, strip, wide, random, work);
  followed.found = std::move(squeezed.found);
  for (std::size_t i = 0; i < followed.paths.size(); ++i) {
    PathRecord& path = followed.paths[i];
    if (path.end == PathRecord::End::singular)
      path = {
          PathRecord::End::failed, "a multiple line of the widened spheres is not followed further", 0, {}};
    if (path.end != PathRecord::End::regular) continue;
    const auto line = wide.find(*ends.line_of_path(i));
    if (line && squeezed.has_end[*line]) continue;
    path = {PathRecord::End::failed, "lost on the way from the widened spheres to the given ones", 0, {}};
  }
}

/// Follows the 24 paths, or as many as there is time for before a stop.
class PathFollower {
 public:
  PathFollower(std::uint64_t seed, const std::stop_token& stop, Monitor* monitor, WorkCounters& work)
      : random_(seed), stop_(stop), monitor_(monitor), work_(work) {}

  FollowedTangents straight(const FourSpheres& spheres) {
    const TangentHomotopy homotopy(spheres, random_);
    TangentEnds ends(spheres, work_);
    return walk(homotopy, ends);
  }

  FollowedTangents squeezed(const FourSpheres& spheres, const Strip& strip) {
    const FourSpheres wide = strip.widened_spheres();
    const TangentHomotopy homotopy(wide, random_);
    TangentEnds ends(wide, work_);
    FollowedTangents followed = walk(homotopy, ends);
    if (!is_stopped(followed)) squeeze(spheres, strip, ends, random_, followed, work_);
    return followed;
  }

  static bool is_stopped(const FollowedTangents& followed) {
    return followed.paths.back().end == PathRecord::End::stopped;
  }

 private:
  FollowedTangents walk(const TangentHomotopy& homotopy, TangentEnds& ends) {
    std::vector<PathRecord> paths = follow_tangent_paths(homotopy, ends, stop_, monitor_, work_);
    return {ends.lines(), std::move(paths)};
  }

  std::mt19937_64 random_;
  const std::stop_token& stop_;
  Monitor* monitor_;
  WorkCounters& work_;
};

bool is_complete(const FollowedTangents& followed) {
  return followed.found.accounted_for() == tangent_count &&
         std::none_of(followed.paths.begin(), followed.paths.end(),
                      [](const PathRecord& path) { return path.end == PathRecord::End::failed; });
}

}  // namespace

FollowedTangents follow_tangents(const FourSpheres& spheres, std::uint64_t seed, const std::stop_token& stop,
                                 Monitor* monitor, WorkCounters& work) {
  PathFollower follower(seed, stop, monitor, work);
  const Strip strip(spheres);
  const double width = relative_width(spheres);
  if (width < deceptive) return follower.squeezed(spheres, strip);
  FollowedTangents followed = follower.straight(spheres);
  if (PathFollower::is_stopped(followed)) return followed;
  if (is_complete(followed) && followed.found.are_all_simple()) return followed;
  if (strip.widening() > 1) {
    FollowedTangents squeezed = follower.squeezed(spheres, strip);
    if (PathFollower::is_stopped(squeezed)) return squeezed;
    if (is_complete(squeezed) && (!is_complete(followed) || squeezed.found.tell_more_than(followed.found)))
      return squeezed;
  }
  return followed;
}

}  // namespace gcs
