#include "solvers/tangents/tangent_homotopy.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <numbers>

#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/tangents/squeezed_tangents.hpp"
#include "solvers/tangents/tangent_algebra.hpp"
#include "solvers/tangents/tangent_refinement.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
constexpr int unknowns = TangentHomotopy::unknowns;
using Vector = ComplexVector<unknowns>;
using End = TrackingEnd<unknowns>;

Complex random_phase(std::mt19937_64& random) {
  return std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(random() >> 11U) * 0x1p-53);
}

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

/// The lines of ends, one after the other.
class EndCollector {
 public:
  EndCollector(const FourSpheres& spheres, const TangentHomotopy& homotopy, WorkCounters& work)
      : spheres_(spheres), homotopy_(homotopy), work_(work) {}

  PathRecord take(const End& end) {
    line_of_path_.emplace_back();
    if (end.kind == End::Kind::failed) return {PathRecord::End::failed, end.cause, 0, {}};
    const Eigen::Vector3cd u = end.x.head<3>();
    if (nearness_to_isotropic(u) <= isotropic) {
      ++to_infinity_;
      return {PathRecord::End::at_infinity, "", 0, {}, end.winding_number, 0};
    }
    const ComplexTangent line = homotopy_.line(end.x);
    if (end.winding_number == 1 && take_simple(line)) return {PathRecord::End::regular, "", 0, {}, 1, 0};
    if (take_multiple(line)) return {PathRecord::End::singular, "", 0, {}, end.winding_number, 0};
    return {PathRecord::End::failed, "the line where it ends is no common tangent to rounding", 0, {}};
  }

  /// The simple line where the path ends, if it does so.
  const std::optional<ComplexTangent>& line_of_path(std::size_t path) const { return line_of_path_[path]; }

  /// Of a singular line with a single end it is not known what it is: none of multiplicity 0 is kept.
  FoundTangents lines() const {
    FoundTangents result;
    for (std::size_t i = 0; i < found_.lines.size(); ++i) {
      FoundTangent line = found_.lines[i];
      line.multiplicity = singular_ends_[i] == 0 ? 1 : singular_ends_[i] / 2;
      if (line.multiplicity > 0) result.lines.push_back(line);
    }
    result.at_infinity = to_infinity_ / 2;
    return result;
  }

 private:
  template <class Scalar>
  bool refined(Tangent<Scalar>& line) {
    const TangentRefinement refinement = refine(spheres_, line);
    work_.newton_iterations += refinement.iterations;
    return refinement.is_regular;
  }

  /// In R where the line is real.
  bool take_simple(ComplexTangent line) {
    if (!refined(line)) return false;
    Tangent<double> real{line.point.real(), line.direction.real()};
    const bool is_real = is_nearly_real(line) && refined(real);
    if (is_real) line = {real.point.cast<Complex>(), real.direction.cast<Complex>()};
    if (!found_.find(line)) add({line, is_real, 1}, 0);
    line_of_path_.back() = line;
    return true;
  }

  bool take_multiple(const ComplexTangent& line) {
    const auto found = multiple_tangent(spheres_, line, is_nearly_real(line), 1);
    if (!found) return false;
    if (const auto known = found_.find(found->line))
      ++singular_ends_[*known];
    else
      add(*found, 1);
    return true;
  }

  void add(const FoundTangent& line, int singular_ends) {
    found_.lines.push_back(line);
    singular_ends_.push_back(singular_ends);
  }

  const FourSpheres& spheres_;
  const TangentHomotopy& homotopy_;
  WorkCounters& work_;
  FoundTangents found_;
  std::vector<int> singular_ends_;  ///< of each line
  std::vector<std::optional<ComplexTangent>> line_of_path_;
  int to_infinity_ = 0;
};

}  // namespace

TangentHomotopy::TangentHomotopy(const FourSpheres& spheres, std::mt19937_64& random)
    : origin_(spheres[0].center), square_(spheres[0].square.value()), gamma_(random_phase(random)) {
  Eigen::Matrix3d centers;
  for (int i = 0; i < 3; ++i) centers.col(i) = spheres[i + 1].center - origin_;
  const Eigen::ColPivHouseholderQR<Eigen::Matrix3d> decomposition(centers);
  frame_ = decomposition.householderQ();
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
void squeeze(const FourSpheres& spheres, const Strip& strip, const EndCollector& ends,
             std::mt19937_64& random, FollowedTangents& followed, WorkCounters& work) {
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
    EndCollector ends(spheres, homotopy, work_);
    return walk(homotopy, ends);
  }

  FollowedTangents squeezed(const FourSpheres& spheres, const Strip& strip) {
    const FourSpheres wide = strip.widened_spheres();
    const TangentHomotopy homotopy(wide, random_);
    EndCollector ends(wide, homotopy, work_);
    FollowedTangents followed = walk(homotopy, ends);
    if (!is_stopped(followed)) squeeze(spheres, strip, ends, random_, followed, work_);
    return followed;
  }

  static bool is_stopped(const FollowedTangents& followed) {
    return followed.paths.back().end == PathRecord::End::stopped;
  }

 private:
  FollowedTangents walk(const TangentHomotopy& homotopy, EndCollector& ends) {
    PathTracker<TangentHomotopy> tracker(homotopy, work_);
    const std::vector<Vector> starts = TangentHomotopy::starts();
    FollowedTangents followed;
    for (const Vector& start : starts) {
      if (monitor_)
        monitor_->progress("following paths",
                           static_cast<double>(followed.paths.size()) / static_cast<double>(starts.size()));
      if (stop_.stop_requested()) break;
      followed.paths.push_back(ends.take(tracker.follow(start)));
    }
    followed.paths.resize(starts.size(), {PathRecord::End::stopped, "stopped on request", 0, {}});
    followed.found = ends.lines();
    return followed;
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
