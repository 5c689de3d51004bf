#include "solvers/octahedron/exact_squares.hpp"

#include <algorithm>

#include "solvers/octahedron/pair_entries.hpp"

namespace gcs {
namespace {

/// The signs of a closed walk, but for a common one.
std::array<int, 4> signs_of(int number) {
  return {1, number & 1 ? -1 : 1, number & 2 ? -1 : 1, number & 4 ? -1 : 1};
}

}  // namespace

RootSum::RootSum(const std::array<Rational, 4>& squares) {
  for (std::size_t i = 0; i < 4; ++i) {
    class_[i] = i;
    factor_[i] = Rational(1);
    for (std::size_t j = 0; j < i && class_[i] == i; ++j)
      if (const auto root = (squares[i] / squares[j]).root(); root && class_[j] == j) {
        class_[i] = j;
        factor_[i] = *root;
      }
  }
}

bool RootSum::vanishes(const std::array<int, 4>& signs) const {
  std::array<Rational, 4> sums;
  for (std::size_t i = 0; i < 4; ++i) sums[class_[i]] = sums[class_[i]] + Rational(signs[i]) * factor_[i];
  return std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum.sign() == 0; });
}

int stretched_walks(const Scene& scene, const Octahedron& octahedron) {
  const ExactEntries squares(scene);
  int walks = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [b, b2] = octahedron.pair[i];
    const auto [c, c2] = octahedron.pair[(i + 1) % 3];
    const RootSum sum({squares(b, c), squares(c, b2), squares(b2, c2), squares(c2, b)});
    for (int number = 0; number < 8; ++number) walks += sum.vanishes(signs_of(number)) ? 1 : 0;
  }
  return walks;
}

}  // namespace gcs
