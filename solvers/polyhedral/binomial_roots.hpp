#pragma once
/// Systems x^(a_i − b_i) = e^(2πi β_i) of binomials with integer exponents, in (C*)^n.

#include <cstdint>
#include <optional>
#include <vector>

namespace gcs {

/// Rows of exponents.
using IntegerMatrix = std::vector<std::vector<std::int64_t>>;

/// The homogeneous solutions e^(2πi g/volume) of x^M = 1, a finite group of |det M| elements: g runs through
/// the lattice that the columns of |det M|·M⁻¹ span, modulo |det M|.
class BinomialRoots {
 public:
  /// Nothing where M is singular, or where |det M|·M⁻¹, found in doubles, is not confirmed in integers.
  static std::optional<BinomialRoots> of(const IntegerMatrix& exponents);

  /// |det M|
  std::int64_t volume() const { return volume_; }
  /// The angles θ, in turns from 0 up to 1, of the solution x = e^(2πi θ) number `i` < volume:
  /// M·θ = β + integers.
  std::vector<double> angles(const std::vector<double>& turns, std::int64_t i) const;

 private:
  /// Multiples 0 … order − 1 of a group element.
  struct Generator {
    std::vector<std::int64_t> element;
    std::int64_t order = 1;
  };

  BinomialRoots(std::int64_t volume, IntegerMatrix adjugate);

  std::int64_t volume_;
  IntegerMatrix adjugate_;  ///< volume·M⁻¹
  std::vector<Generator> generators_;
};

}  // namespace gcs
