#include "solvers/homotopies/total_degree.hpp"

#include <algorithm>
#include <complex>
#include <numbers>
#include <utility>

#include "solvers/lanes/square_system.hpp"

namespace gcs {

std::vector<ComplexVectorX> roots_of_unity(const std::vector<int>& degrees) {
  std::vector<ComplexVectorX> all{{}};
  for (const int degree : degrees) {
    std::vector<ComplexVectorX> longer;
    for (const ComplexVectorX& x : all)
      for (int root = 0; root < degree; ++root) {
        longer.push_back(x);
        longer.back().push_back(std::polar(1.0, 2 * std::numbers::pi * root / degree));
      }
    all = std::move(longer);
  }
  return all;
}

Elimination order_elimination(const MonomialSystem& system, const std::vector<ComplexVectorX>& starts,
                              const ComplexVectorX& from, const ComplexVectorX& to, std::mt19937_64& random) {
  constexpr std::size_t samples = 3;  // of each kind
  std::vector<ComplexVectorX> jacobians;
  for (std::size_t i = 0; i < std::min(samples, starts.size()); ++i)
    jacobians.push_back(jacobian_at(system, from, starts[i * (starts.size() - 1) / samples]));
  ComplexVectorX middle = from;
  for (std::size_t j = 0; j < middle.size(); ++j) middle[j] += to[j];
  for (std::size_t i = 0; i < samples; ++i)
    jacobians.push_back(jacobian_at(system, middle, random_complex_vector(system.unknowns, random)));
  return order_elimination(system, jacobians);
}

}  // namespace gcs
