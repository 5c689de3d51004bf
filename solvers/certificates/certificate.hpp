#pragma once
/// Proofs that numbers lie next to a solution: Krawczyk's test in doubles where these suffice, else in balls
/// of more and more bits. Where it does not succeed at all, how many solutions lie together there.

#include <array>
#include <complex>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "solvers/certificates/disc_krawczyk.hpp"
#include "solvers/model/ball_krawczyk.hpp"

namespace gcs {

inline constexpr int bits_of_doubles = 53;
/// In bits, of balls. What 1024 do not separate, lengths of any use do not separate either.
inline constexpr std::array<slong, 4> ball_precisions{128, 256, 512, 1024};

/// What is proven about one point x.
struct Certificate {
  enum class Realness { undecided, real, not_real };

  bool is_proven = false;  ///< the solution in `enclosure` exists and is alone there
  /// Solutions in `enclosure`, with multiplicities, that are not proven to be different or to be one; 0: the
  /// point was not found to be in a cluster.
  int cluster = 0;
  bool is_multiple = false;  ///< the cluster is one solution, which has fractions for unknowns
  int bits = 0;              ///< the precision that it took; 53: doubles
  Enclosure enclosure;
  Realness realness = Realness::undecided;  ///< of the solution: of all its unknowns together
  std::string cause;                        ///< why no simple solution is proven, in words; empty when one is

  /// Whether the point has been looked at.
  bool is_tried() const { return is_proven || !cause.empty(); }
  /// Whether one solution is known to be there, and no other one.
  bool holds_one() const { return is_proven || is_multiple; }
  /// Whether `enclosure` is one.
  bool is_isolated() const { return is_proven || cluster > 0; }
  /// At least |x_i − solution_i|, for every solution of a cluster.
  double offset(std::size_t i, std::complex<double> x_i) const;
};

/// Of the solution in an enclosure, the system having real coefficients.
Certificate::Realness realness(const Enclosure& enclosure);

class Certifier {
 public:
  explicit Certifier(QuadraticSystem system);

  const QuadraticSystem& system() const { return system_; }
  /// About the solution that Newton's method reaches from x, one number per unknown. The precision is raised
  /// until the solution is proven and, of a system with real coefficients, is known to be real or not to be.
  /// `least_bits`: where to begin; above 53 the enclosure is as small as the rounding of its doubles.
  Certificate certify(const std::vector<std::complex<double>>& x, int least_bits = 53) const;
  /// The proof in balls of that precision, for many digits; nothing where it does not suffice.
  std::optional<BallKrawczyk::Proof> prove(const std::vector<std::complex<double>>& x, slong bits) const;

 private:
  void find_cluster(const std::vector<std::complex<double>>& x, Certificate& certificate) const;

  /// The balls of one precision, made when they are first needed: most proofs need none.
  const BallKrawczyk& level(std::size_t number) const;

  QuadraticSystem system_;
  bool is_real_;
  std::optional<DiscKrawczyk> discs_;
  struct Level {
    std::once_flag is_made;
    std::optional<BallKrawczyk> balls;
  };
  std::unique_ptr<Level[]> levels_;
};

}  // namespace gcs
