#include "solvers/tangents/tangent_homotopy.hpp"

#include <algorithm>
#include <numbers>

#include "solvers/tangents/tangent_algebra.hpp"
#include "solvers/tangents/tangent_refinement.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
constexpr int unknowns = TangentHomotopy::unknowns;
using Vector = ComplexVector<unknowns>;
using End = PathEnd<unknowns>;

Complex random_phase(std::mt19937_64& random) {
  return std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(random() >> 11U) * 0x1p-53);
}

/// x² − 1, τ − y², g³ − 1, τ² − 1: weights 2, 2, 3 and 4.
SystemValue<unknowns> start_system(const Vector& at) {
  const Complex x = at[0], y = at[1], g = at[2], tau = at[3];
  SystemValue<unknowns> system;
  system.value << x * x - 1.0, tau - y * y, g * g * g - 1.0, tau * tau - 1.0;
  system.jacobian.setZero();
  system.jacobian(0, 0) = 2.0 * x;
  system.jacobian(1, 1) = -2.0 * y;
  system.jacobian(1, 3) = 1;
  system.jacobian(2, 2) = 3.0 * g * g;
  system.jacobian(3, 3) = 2.0 * tau;
  return system;
}

/// The lines of ends, one after the other.
class EndCollector {
 public:
  EndCollector(const FourSpheres& spheres, const TangentEquations& equations, WorkCounters& work)
      : spheres_(spheres), equations_(equations), work_(work) {}

  PathRecord take(const End& end) {
    if (end.kind == End::Kind::failed) return {PathRecord::End::failed, end.cause, 0, {}};
    const Eigen::Vector3cd u = end.x.head<3>();
    if (nearness_to_isotropic(u) <= isotropic) {
      ++to_infinity_;
      return {PathRecord::End::at_infinity, "", 0, {}};
    }
    const ComplexTangent line = equations_.line<Complex>(u, end.x[3]);
    if (end.winding_number == 1 && take_simple(line)) return {PathRecord::End::regular, "", 0, {}};
    if (take_multiple(line)) return {PathRecord::End::singular, "", 0, {}};
    return {PathRecord::End::failed, "the line where it ends is no common tangent to rounding", 0, {}};
  }

  /// Of a singular line with a single end it is not known what it is: none of multiplicity 0 is kept.
  CommonTangents lines() const {
    CommonTangents result;
    for (std::size_t i = 0; i < found_.lines.size(); ++i) {
      FoundTangent line = found_.lines[i];
      line.multiplicity = singular_ends_[i] == 0 ? 1 : singular_ends_[i] / 2;
      if (line.multiplicity > 0) result.lines.push_back(line);
    }
    result.at_infinity = to_infinity_ / 2;
    if (result.accounted_for() < tangent_count)
      result.infinitely_many = dimension_of_weight_12(equations_) > tangent_count;
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
  const TangentEquations& equations_;
  WorkCounters& work_;
  CommonTangents found_;
  std::vector<int> singular_ends_;  ///< of each line
  int to_infinity_ = 0;
};

}  // namespace

TangentHomotopy::TangentHomotopy(const TangentEquations& equations, std::mt19937_64& random)
    : equations_(equations),
      gamma_(random_phase(random)),
      scale_1_(1 / std::max(std::abs(equations.h()), equations.kappa().cwiseAbs().maxCoeff())),
      scale_2_(1 / std::max(equations.l().cwiseAbs().maxCoeff(), equations.s().cwiseAbs().maxCoeff())),
      scale_3_(1 / std::max(1.0, equations.rho().cwiseAbs().maxCoeff())) {
  for (int axis = 0; axis < 3; ++axis) patch_[axis] = random_phase(random);
}

SystemValue<unknowns> TangentHomotopy::target(const Vector& x) const {
  const Eigen::Vector3cd u = x.head<3>();
  const Complex tau = x[3], on_patch = (patch_.transpose() * u).value();
  const Complex l = form_value<1>(equations_.l(), u);
  SystemValue<unknowns> system;
  system.value << on_patch * on_patch - 1.0,
      scale_1_ * (equations_.h() * tau - form_value<2>(equations_.kappa(), u)),
      scale_2_ * (tau * l + form_value<3>(equations_.s(), u)),
      scale_3_ * (tau * tau - form_value<4>(equations_.rho(), u));
  system.jacobian.row(0) << 2.0 * on_patch * patch_.transpose(), 0;
  system.jacobian.row(1) << -scale_1_ * form_gradient<2>(equations_.kappa(), u), scale_1_ * equations_.h();
  system.jacobian.row(2) << scale_2_ * (tau * form_gradient<1>(equations_.l(), u) +
                                        form_gradient<3>(equations_.s(), u)),
      scale_2_ * l;
  system.jacobian.row(3) << -scale_3_ * form_gradient<4>(equations_.rho(), u), scale_3_ * 2.0 * tau;
  return system;
}

HomotopyValue<unknowns> TangentHomotopy::at(const Vector& x, Complex t) const {
  return straight_line(start_system(x), target(x), gamma_, t);
}

std::vector<Vector> TangentHomotopy::starts() {
  const auto root = [](int k, int n) { return std::polar(1.0, 2 * std::numbers::pi * k / n); };
  std::vector<Vector> result;
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 4; ++y)  // y⁴ = τ² = 1
      for (int g = 0; g < 3; ++g) result.push_back({root(x, 2), root(y, 4), root(g, 3), root(2 * y, 4)});
  return result;
}

FollowedTangents follow_tangents(const FourSpheres& spheres, std::uint64_t seed, const std::stop_token& stop,
                                 Monitor* monitor, WorkCounters& work) {
  std::mt19937_64 random(seed);
  const TangentEquations equations(spheres, Eigen::Matrix3d::Identity());
  const TangentHomotopy homotopy(equations, random);
  PathTracker<TangentHomotopy> tracker(homotopy, work);
  EndCollector collector(spheres, equations, work);
  const std::vector<Vector> starts = TangentHomotopy::starts();
  FollowedTangents followed;
  for (const Vector& start : starts) {
    if (monitor)
      monitor->progress("following paths",
                        static_cast<double>(followed.paths.size()) / static_cast<double>(starts.size()));
    if (stop.stop_requested()) break;
    followed.paths.push_back(collector.take(tracker.follow(start)));
  }
  followed.paths.resize(starts.size(), {PathRecord::End::stopped, "stopped on request", 0, {}});
  followed.found = collector.lines();
  return followed;
}

}  // namespace gcs
