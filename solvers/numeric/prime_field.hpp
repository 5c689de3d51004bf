#pragma once
/// Exact arithmetic modulo the prime 2^61 − 1, and linear algebra over it.

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace gcs {

/// An element of the field with 2^61 − 1 elements.
class Residue {
 public:
  static constexpr std::uint64_t modulus = (std::uint64_t{1} << 61) - 1;

  constexpr Residue() = default;
  constexpr explicit Residue(std::uint64_t value) : value_(value % modulus) {}

  constexpr std::uint64_t value() const { return value_; }
  constexpr bool is_zero() const { return value_ == 0; }

  friend constexpr bool operator==(Residue, Residue) = default;
  friend constexpr Residue operator+(Residue a, Residue b) { return below_twice(a.value_ + b.value_); }
  friend constexpr Residue operator-(Residue a, Residue b) {
    return below_twice(a.value_ + modulus - b.value_);
  }
  friend constexpr Residue operator-(Residue a) { return below_twice(modulus - a.value_); }
  friend constexpr Residue operator*(Residue a, Residue b) {
    const Wide product = Wide{a.value_} * b.value_;
    return below_twice(static_cast<std::uint64_t>(product & modulus) +
                       static_cast<std::uint64_t>(product >> 61));
  }
  constexpr Residue& operator+=(Residue other) { return *this = *this + other; }
  constexpr Residue& operator-=(Residue other) { return *this = *this - other; }

  /// 1 / this. Precondition: not zero.
  constexpr Residue inverse() const {
    Residue result(1);
    Residue power = *this;
    for (std::uint64_t exponent = modulus - 2; exponent != 0; exponent >>= 1) {  // Fermat
      if (exponent & 1U) result = result * power;
      power = power * power;
    }
    return result;
  }

  /// The next element of a random sequence; the same on every machine, unlike std::uniform_int_distribution.
  static Residue random(std::mt19937_64& engine) { return Residue(engine()); }

 private:
  __extension__ typedef unsigned __int128 Wide;

  /// The residue of a value up to 2 · modulus − 1, without a division.
  static constexpr Residue below_twice(std::uint64_t value) {
    Residue result;
    result.value_ = value < modulus ? value : value - modulus;
    return result;
  }

  std::uint64_t value_ = 0;
};

using ResidueVector = std::vector<Residue>;
/// Rows of equal length.
using ResidueMatrix = std::vector<ResidueVector>;
using Residue3 = std::array<Residue, 3>;

Residue3 operator+(const Residue3& a, const Residue3& b);
Residue3 operator-(const Residue3& a, const Residue3& b);
Residue3 operator*(Residue factor, const Residue3& a);
Residue dot(const Residue3& a, const Residue3& b);
Residue3 cross(const Residue3& a, const Residue3& b);
/// Sum of a[i]·b[i]. Precondition: equal lengths.
Residue dot(const ResidueVector& a, const ResidueVector& b);

/// Rank of the matrix, in O(rows · columns · rank).
int rank(ResidueMatrix matrix);

/// A basis of the vectors x of length `columns` with matrix·x = 0. Vector i of the basis is the only one with
/// a non-zero entry in the i-th column without pivot, so that its support is minimal.
ResidueMatrix null_space(ResidueMatrix matrix, int columns);

/// The solution of a square system, times its determinant.
struct ScaledSolution {
  Residue determinant;
  ResidueVector numerators;
};

/// Of n rows with n + 1 entries, the last column being the right-hand side. Nothing for a singular system.
std::optional<ScaledSolution> solve(const ResidueMatrix& augmented);

/// Rows and columns exchanged. `columns` is the length of the rows.
ResidueMatrix transposed(const ResidueMatrix& matrix, int columns);

}  // namespace gcs
