#pragma once
/// What cayley_menger.cpp can be asked for.

#include "solvers/interface/options.hpp"
#include "solvers/octahedron/core_solutions.hpp"

namespace gcs {

struct CayleyMenger {
  static constexpr std::string_view strategy = "cayley-menger";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  DiagonalMethod method = DiagonalMethod::eigenvalues;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("method", self.method, OneOf<DiagonalMethod>{"eigenvalues|univariate"},
           "eigenvalues: of a matrix in doubles, or univariate where these miss some; univariate: roots of "
           "one polynomial, "
           "eliminated exactly");
  }
  bool operator==(const CayleyMenger&) const = default;
};

}  // namespace gcs
