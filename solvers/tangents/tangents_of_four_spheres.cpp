#include "solvers/tangents/tangents_of_four_spheres.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "solvers/numeric/dense_factors.hpp"
#include "solvers/tangents/eigenvalue_clusters.hpp"
#include "solvers/tangents/squeezed_tangents.hpp"
#include "solvers/tangents/strip_refinement.hpp"
#include "solvers/tangents/tangent_refinement.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
using Line = ComplexTangent;

/// Which combination of x and y tells solutions apart, and the rotations that one after the other are tried:
/// any will do for which no two solutions agree and none has g near 0.
constexpr double mix_angle = 0.7;
constexpr std::array<std::array<double, 4>, 3> turns{
    {{0.31, 0.47, 0.83, 0.9}, {-0.72, 0.55, 0.42, 2.0}, {0.64, -0.21, 0.74, 3.3}}};

Eigen::Matrix3d rotation(const std::array<double, 4>& turn) {
  return Eigen::AngleAxisd(turn[3], Eigen::Vector3d(turn[0], turn[1], turn[2]).normalized())
      .toRotationMatrix();
}

/// One choice of coordinates.
class Attempt {
 public:
  Attempt(const FourSpheres& spheres, const TangentEquations& equations, const TangentAlgebra& algebra,
          WorkCounters& work)
      : spheres_(spheres), equations_(equations), algebra_(algebra), work_(work) {}

  FoundTangents run() {
    mixed_ = std::cos(mix_angle) * algebra_.times_x() + std::sin(mix_angle) * algebra_.times_y();
    const EigenSystem eigen = eigen_system(mixed_);
    for (Eigen::Index i = 0; i < eigen.values.size(); ++i) {
      eigenvalue_ = eigen.values[i];
      if (eigenvalue_.imag() < 0) continue;  // the conjugate comes with the other one
      const bool taken = eigenvalue_.imag() == 0 ? take_simple<double>(eigen.real_vectors.col(i))
                                                 : take_simple<Complex>(eigen.vectors.col(i));
      if (!taken) leave(eigenvalue_);
    }
    give_back_doubtful();
    if (!left_.empty()) take_clusters();
    return std::move(found_);
  }

 private:
  void leave(Complex eigenvalue) {
    left_.push_back(eigenvalue);
    if (eigenvalue.imag() > 0) left_.push_back(std::conj(eigenvalue));
  }

  /// Eigenvalues that lead to one line come from two that are close together, or from a double one: they are
  /// judged together.
  void give_back_doubtful() {
    for (const Complex doubtful : doubtful_) {
      std::vector<FoundTangent> rest;
      std::vector<Complex> of_rest;
      for (std::size_t i = 0; i < found_.lines.size(); ++i) {
        if (eigenvalues_[i] == doubtful) continue;
        rest.push_back(found_.lines[i]);
        of_rest.push_back(eigenvalues_[i]);
      }
      if (rest.size() < found_.lines.size()) leave(doubtful);
      found_.lines = std::move(rest);
      eigenvalues_ = std::move(of_rest);
    }
  }

  /// A solution by its eigenvector. False when it is not simple or comes out twice.
  template <class Scalar>
  bool take_simple(const AlgebraVector<Scalar>& w) {
    const auto eigenvalue = [&w](const AlgebraMatrix& matrix) {
      return Scalar(w.dot(matrix.template cast<Scalar>() * w) / w.squaredNorm());
    };
    const Scalar x = eigenvalue(algebra_.times_x()), y = eigenvalue(algebra_.times_y());
    return take_at<Scalar>({x, y, Scalar(1)}, algebra_.tau(w, x, y));
  }

  template <class Scalar>
  bool take_at(const Eigen::Matrix<Scalar, 3, 1>& u, Scalar tau) {
    constexpr bool real = std::is_same_v<Scalar, double>;
    if (nearness_to_isotropic(u) <= isotropic) {
      found_.at_infinity += real ? 1 : 2;
      return true;
    }
    Tangent<Scalar> line = equations_.line<Scalar>(u, tau);
    const TangentRefinement refinement = refine(spheres_, line);
    work_.newton_iterations += refinement.iterations;
    if (!refinement.is_regular) return false;
    const Line complex{line.point.template cast<Complex>(), line.direction.template cast<Complex>()};
    const auto known = found_.find(complex);
    if (known && *known < eigenvalues_.size()) doubtful_.push_back(eigenvalues_[*known]);
    if (known || (!real && is_own_conjugate(complex))) return false;
    add(complex, real);
    return true;
  }

  static bool is_own_conjugate(const Line& line) { return difference(line, conjugate(line)) <= same_line; }

  /// A simple line with its conjugate.
  void add(const Line& line, bool is_real) {
    found_.lines.push_back({line, is_real, 1});
    if (!is_real) found_.lines.push_back({conjugate(line), false, 1});
    eigenvalues_.resize(found_.lines.size(), eigenvalue_);
  }

  /// From coarse to fine: a part of a cluster may look like a whole one.
  void take_clusters() {
    times_tau_ = algebra_.times_tau(equations_);
    for (double tolerance = 0.05; tolerance > 1e-8 && !left_.empty(); tolerance /= 4) {
      std::vector<Complex> rest;
      for (const EigenvalueCluster& cluster : clusters_of(left_, tolerance)) {
        const Complex center = mean_of(left_, cluster);
        const bool with_conjugate = std::abs(center.imag()) > tolerance;
        if (with_conjugate && center.imag() < 0) continue;
        if (may_be_one(left_, cluster) && take_cluster(center, cluster.size(), with_conjugate, tolerance))
          continue;
        for (const int i : cluster) {
          rest.push_back(left_[i]);
          if (with_conjugate) rest.push_back(std::conj(left_[i]));
        }
      }
      left_ = std::move(rest);
    }
  }

  /// Lines of one direction differ in τ.
  bool take_cluster(Complex center, std::size_t size, bool with_conjugate, double tolerance) {
    const int dimension = static_cast<int>(size);
    const Subspace subspace = invariant_subspace(mixed_, center, dimension);
    const auto mean = [&](const AlgebraMatrix& matrix) {
      return restricted(matrix, subspace).trace() / static_cast<double>(dimension);
    };
    const Eigen::Vector3cd u(mean(algebra_.times_x()), mean(algebra_.times_y()), 1);
    const Eigen::VectorXcd eigenvalues = schur_form(restricted(times_tau_, subspace)).t.diagonal();
    const std::span<const Complex> taus(eigenvalues.data(), size);
    const FoundTangents before = found_;
    for (const EigenvalueCluster& cluster : clusters_of(taus, tolerance)) {
      if (may_be_one(taus, cluster) &&
          take_multiple(u, mean_of(taus, cluster), static_cast<int>(cluster.size()), with_conjugate))
        continue;
      found_ = before;
      return false;
    }
    return true;
  }

  bool take_multiple(const Eigen::Vector3cd& u, Complex tau, int multiplicity, bool with_conjugate) {
    if (nearness_to_isotropic(u) <= isotropic) {
      found_.at_infinity += with_conjugate ? 2 * multiplicity : multiplicity;
      return true;
    }
    const Line line = equations_.line<Complex>(u, tau);
    const bool is_real = !with_conjugate && is_nearly_real(line);
    if (multiplicity == 2 && take_pair(line, is_real, with_conjugate)) return true;
    if (multiplicity == 1) return take_one_of_parallels(u, tau, is_real, with_conjugate);
    const auto found = multiple_tangent(spheres_, line, is_real, multiplicity);
    if (!found || found_.find(found->line)) return false;
    found_.lines.push_back(*found);
    if (with_conjugate) found_.lines.push_back({conjugate(found->line), false, multiplicity});
    return true;
  }

  /// A simple line that shares its direction with others.
  bool take_one_of_parallels(const Eigen::Vector3cd& u, Complex tau, bool is_real, bool with_conjugate) {
    if (is_real) return take_at<double>(u.real(), tau.real());
    Line line = equations_.line<Complex>(u, tau);
    const TangentRefinement refinement = refine(spheres_, line);
    work_.newton_iterations += refinement.iterations;
    if (!refinement.is_regular || found_.find(line) || (with_conjugate && is_own_conjugate(line)))
      return false;
    found_.lines.push_back({line, false, 1});
    if (with_conjugate) found_.lines.push_back({conjugate(line), false, 1});
    return true;
  }

  /// Two simple lines, or with their conjugates four, that are so close together that only the mean of their
  /// eigenvalues is right to rounding.
  bool take_pair(const Line& mean, bool is_real, bool with_conjugate) {
    const FoundTangents before = found_;
    for (const Line& start : split(spheres_, is_real ? real_part(mean) : mean)) {
      if (take_near(start, is_real && is_nearly_real(start), with_conjugate)) continue;
      found_ = before;
      return false;
    }
    return true;
  }

  bool take_near(Line line, bool is_real, bool with_conjugate) {
    const auto is_refined = [&](auto& start) {
      const TangentRefinement refinement = refine(spheres_, start);
      work_.newton_iterations += refinement.iterations;
      return refinement.is_regular;
    };
    if (is_real) {
      Tangent<double> real{line.point.real(), line.direction.real()};
      if (!is_refined(real)) return false;
      line = {real.point.cast<Complex>(), real.direction.cast<Complex>()};
    } else if (!is_refined(line) || is_own_conjugate(line)) {
      return false;
    }
    if (found_.find(line)) return false;
    found_.lines.push_back({line, is_real, 1});
    if (with_conjugate) found_.lines.push_back({conjugate(line), false, 1});
    return true;
  }

  const FourSpheres& spheres_;
  const TangentEquations& equations_;
  const TangentAlgebra& algebra_;
  WorkCounters& work_;
  AlgebraMatrix mixed_;
  AlgebraMatrix times_tau_;
  FoundTangents found_;
  Complex eigenvalue_;                ///< of the solution at hand
  std::vector<Complex> eigenvalues_;  ///< of the simple lines found
  std::vector<Complex> doubtful_;     ///< of those that another eigenvalue leads to as well
  std::vector<Complex> left_;         ///< of solutions that are not simple
};

FoundTangents tangents_by_eigenvalues(const FourSpheres& spheres, WorkCounters& work) {
  FoundTangents best;
  for (const auto& turn : turns) {
    const TangentEquations equations(spheres, rotation(turn));
    const auto algebra = TangentAlgebra::of(equations);
    ++work.factorisations;
    if (!algebra) continue;
    FoundTangents found = Attempt(spheres, equations, *algebra, work).run();
    if (found.accounted_for() > best.accounted_for()) best = std::move(found);
    if (best.accounted_for() == tangent_count) return best;
  }
  return best;
}

/// The simple lines that are so in isotropic coordinates too, each once.
FoundTangents confirmed(const FourSpheres& spheres, const Strip& strip, const FoundTangents& tangents,
                        WorkCounters& work) {
  TangentsInStrip lines(strip);
  for (const FoundTangent& found : tangents.lines) {
    if (found.multiplicity > 1) continue;
    const auto refined = refined_in_strip(spheres, strip, ScaledLine::of(strip, found.line), work);
    if (refined) lines.take(*refined);
  }
  return std::move(lines.found);
}

FoundTangents tangents_by_squeezing(const FourSpheres& spheres, const Strip& strip, WorkCounters& work) {
  constexpr std::uint64_t seed = 1;  // any will do
  if (strip.widening() == 1) return {};
  std::mt19937_64 random(seed);
  return squeezed_tangents(spheres, strip, tangents_by_eigenvalues(strip.widened_spheres(), work), random,
                           work)
      .found;
}

}  // namespace

FoundTangents common_tangents(const FourSpheres& spheres, WorkCounters& work) {
  const double width = relative_width(spheres);
  FoundTangents best = tangents_by_eigenvalues(spheres, work);
  if (width >= deceptive && best.are_all_simple()) return best;
  const Strip strip(spheres);
  if (width < deceptive) best = confirmed(spheres, strip, best, work);
  if (best.are_all_simple()) return best;
  FoundTangents squeezed = tangents_by_squeezing(spheres, strip, work);
  if (squeezed.tell_more_than(best)) best = std::move(squeezed);
  return best;
}

}  // namespace gcs
