#include "solvers/tangents/published_tangents.hpp"

#include <Eigen/LU>
#include <array>
#include <numbers>

#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// The centres from the first one.
struct CentredSpheres {
  explicit CentredSpheres(const FourSpheres& spheres)
      : origin(spheres[0].center), first_square(spheres[0].square.value()) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d c = spheres[i + 1].center - origin;
      centers.row(i) = c;
      constants[i] = c.squaredNorm() - spheres[i + 1].square.value();
    }
  }

  Eigen::Vector3d origin;
  double first_square;        ///< r_1²
  Eigen::Matrix3d centers;    ///< rows
  Eigen::Vector3d constants;  ///< c·c − r²
};

/// A homogeneous system in X = (h, …) on the patch a·X = 1, whose equation k has the degree degrees[k].
template <class System>
class OnPatch {
 public:
  static constexpr int unknowns = System::equations + 1;
  using Vector = ComplexVector<unknowns>;

  OnPatch(const CentredSpheres& spheres, std::mt19937_64& random)
      : system_(spheres), origin_(spheres.origin), gamma_(random_phase(random)) {
    for (int k = 0; k < unknowns; ++k) patch_[k] = random_phase(random);
  }

  HomotopyValue<unknowns> at(const Vector& x, Complex t) const {
    SystemValue<unknowns> target;
    system_.evaluate(x, target);
    set_patch(x, target);
    return straight_line(start_system(x), target, gamma_, t);
  }

  /// All X with X_k^d = h^d on the patch.
  std::vector<Vector> starts() const {
    std::vector<Vector> result{Vector::Ones()};
    for (int k = 0; k < System::equations; ++k) {
      const std::vector<Vector> before = std::move(result);
      result.clear();
      for (Vector x : before)
        for (int root = 0; root < System::degrees[k]; ++root) {
          x[k + 1] = std::polar(1.0, 2 * std::numbers::pi * root / System::degrees[k]);
          result.push_back(x);
        }
    }
    for (Vector& x : result) x /= bilinear(patch_, x);
    return result;
  }

  bool is_at_infinity(const Vector& x) const { return std::norm(x[0]) <= isotropic * x.squaredNorm(); }

  ComplexTangent line(const Vector& x) const {
    const auto [point, direction] = system_.line(x);
    return line_through<Complex>(direction, point * bilinear_product(direction, direction), origin_);
  }

 private:
  static Complex bilinear(const Vector& a, const Vector& b) { return (a.array() * b.array()).sum(); }

  void set_patch(const Vector& x, SystemValue<unknowns>& system) const {
    system.value[0] = bilinear(patch_, x) - 1.0;
    system.jacobian.row(0) = patch_.transpose();
  }

  SystemValue<unknowns> start_system(const Vector& x) const {
    SystemValue<unknowns> system;
    system.jacobian.setZero();
    for (int k = 1; k < unknowns; ++k) {
      const int degree = System::degrees[k - 1];
      const Complex of_x = std::pow(x[k], degree - 1), of_h = std::pow(x[0], degree - 1);
      system.value[k] = of_x * x[k] - of_h * x[0];
      system.jacobian(k, k) = static_cast<double>(degree) * of_x;
      system.jacobian(k, 0) = -static_cast<double>(degree) * of_h;
    }
    set_patch(x, system);
    return system;
  }

  System system_;
  Eigen::Vector3d origin_;
  Complex gamma_;
  Vector patch_;  ///< a
};

/// X = (h, p, u).
class Quadrics {
 public:
  static constexpr int equations = 6;
  static constexpr std::array<int, equations> degrees{2, 2, 2, 2, 2, 2};

  explicit Quadrics(const CentredSpheres& spheres) : spheres_(spheres) {}

  void evaluate(const ComplexVector<7>& x, SystemValue<7>& system) const {
    const Complex h = x[0];
    const Eigen::Vector3cd p = x.segment<3>(1), u = x.segment<3>(4);
    const Complex pp = bilinear_product(p, p);
    system.jacobian.setZero();
    system.value[1] = pp - spheres_.first_square * h * h;
    system.jacobian.row(1) << -2.0 * spheres_.first_square * h, 2.0 * p.transpose(), 0, 0, 0;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3cd c = spheres_.centers.row(i).transpose().cast<Complex>();
      const Complex cp = bilinear_product(c, p), cu = bilinear_product(c, u);
      system.value[2 + i] = pp - 2.0 * h * cp + spheres_.constants[i] * h * h - cu * cu;
      system.jacobian.row(2 + i) << 2.0 * (spheres_.constants[i] * h - cp), 2.0 * (p - h * c).transpose(),
          -2.0 * cu * c.transpose();
    }
    system.value[5] = bilinear_product(p, u);
    system.jacobian.row(5) << 0, u.transpose(), p.transpose();
    system.value[6] = bilinear_product(u, u) - h * h;
    system.jacobian.row(6) << -2.0 * h, 0, 0, 0, 2.0 * u.transpose();
  }

  Tangent<Complex> line(const ComplexVector<7>& x) const {
    return {x.segment<3>(1) / x[0], x.segment<3>(4) / x[0]};
  }

 private:
  CentredSpheres spheres_;
};

/// X = (h, u), P = p h².
class Cubic {
 public:
  static constexpr int equations = 3;
  static constexpr std::array<int, equations> degrees{2, 3, 4};

  explicit Cubic(const CentredSpheres& spheres)
      : spheres_(spheres),
        inverse_(spheres.centers.inverse()),
        constants_(spheres.constants.array() + spheres.first_square) {}

  void evaluate(const ComplexVector<4>& x, SystemValue<4>& system) const {
    const Complex h = x[0], first = spheres_.first_square;
    const Eigen::Vector3cd u = x.tail<3>(), p = point(x), along = spheres_.centers * u;
    Eigen::Matrix<Complex, 3, 4> slope;  // of P
    slope.col(0) = h * (inverse_ * constants_);
    slope.rightCols<3>() = -inverse_ * (along.asDiagonal() * spheres_.centers);
    system.value[1] = bilinear_product(u, u) - h * h;
    system.jacobian.row(1) << -2.0 * h, 2.0 * u.transpose();
    system.value[2] = bilinear_product(p, u);
    system.jacobian.row(2) = u.transpose() * slope;
    system.jacobian.row(2).tail<3>() += p.transpose();
    system.value[3] = bilinear_product(p, p) - first * h * h * h * h;
    system.jacobian.row(3) = 2.0 * p.transpose() * slope;
    system.jacobian(3, 0) -= 4.0 * first * h * h * h;
  }

  Tangent<Complex> line(const ComplexVector<4>& x) const {
    return {point(x) / (x[0] * x[0]), x.tail<3>() / x[0]};
  }

 private:
  Eigen::Vector3cd point(const ComplexVector<4>& x) const {
    const Eigen::Vector3cd along = spheres_.centers * x.tail<3>();
    return 0.5 * (inverse_ * (constants_ * (x[0] * x[0]) - along.cwiseProduct(along)));
  }

  CentredSpheres spheres_;
  Eigen::Matrix3d inverse_;    ///< C⁻¹
  Eigen::Vector3d constants_;  ///< c·c + r_1² − r²
};

template <class System>
FollowedTangents follow(const FourSpheres& spheres, std::uint64_t seed, const std::stop_token& stop,
                        Monitor* monitor, WorkCounters& work) {
  std::mt19937_64 random(seed);
  const OnPatch<System> homotopy(CentredSpheres(spheres), random);
  TangentEnds ends(spheres, work);
  std::vector<PathRecord> paths = follow_tangent_paths(homotopy, ends, stop, monitor, work);
  return {ends.lines(), std::move(paths)};
}

}  // namespace

std::optional<std::string> why_no_system(const FourSpheres& spheres, PublishedSystem system) {
  // From there on the rounding of the centres leaves nothing of the inverse.
  constexpr double singular = 1e-15;
  if (system == PublishedSystem::cubic &&
      !(Eigen::PartialPivLU<Eigen::MatrixXd>(CentredSpheres(spheres).centers).rcond() > singular))
    return "the published elimination of the point divides by the volume of the four centres, which are "
           "coplanar";
  return std::nullopt;
}

FollowedTangents follow_published_tangents(const FourSpheres& spheres, PublishedSystem system,
                                           std::uint64_t seed, const std::stop_token& stop, Monitor* monitor,
                                           WorkCounters& work) {
  if (system == PublishedSystem::cubic) return follow<Cubic>(spheres, seed, stop, monitor, work);
  FollowedTangents followed = follow<Quadrics>(spheres, seed, stop, monitor, work);
  followed.found.at_infinity = 0;
  return followed;
}

}  // namespace gcs
