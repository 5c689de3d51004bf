#include "solvers/lanes/square_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/model/distance_system.hpp"

namespace gcs {
namespace {

/// One coordinate of the difference of an edge's ends: an unknown's index, or −1 and the value.
struct Coordinate {
  int unknown = -1;
  double value = 0;
};

Coordinate coordinate(const DistanceSystem& system, int entity, int axis) {
  if (const int unknown = system.unknown(entity, axis); unknown >= 0) return {unknown, 0};
  return {-1, system.given_coordinate(entity, axis)};
}

}  // namespace

void SquareSystem::add_equation(const std::vector<Difference>& squares, const std::vector<LinearTerm>& terms,
                                double constant) {
  differences.insert(differences.end(), squares.begin(), squares.end());
  linear.insert(linear.end(), terms.begin(), terms.end());
  first.push_back(static_cast<int>(differences.size()));
  first_linear.push_back(static_cast<int>(linear.size()));
  given.push_back(constant);
}

SquareSystem square_system(const DistanceSystem& system) {
  SquareSystem result;
  result.unknowns = system.unknowns();
  for (const auto [a, b] : system.edges()) {
    std::vector<Difference> squares;
    double given = 0;
    for (int axis = system.is_line(b) ? 1 : 0; axis < system.dimension(); ++axis) {
      Coordinate u = coordinate(system, a, axis);
      Coordinate v = system.is_line(b) ? Coordinate{} : coordinate(system, b, axis);
      if (u.unknown < 0) std::swap(u, v);
      if (u.unknown >= 0)
        squares.push_back({u.unknown, v.unknown, v.value});
      else
        given += (u.value - v.value) * (u.value - v.value);
    }
    result.add_equation(squares, {}, given);
  }
  return result;
}

ComplexVectorX squares_at(const SquareSystem& system, const ComplexVectorX& x) {
  ComplexVectorX squares;
  for (int e = 0; e < system.equations(); ++e) {
    std::complex<double> sum = system.given[e];
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, constant] = system.differences[d];
      const std::complex<double> difference = x[minuend] - (subtrahend < 0 ? constant : x[subtrahend]);
      sum += difference * difference;
    }
    for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l)
      sum += system.linear[l].coefficient * x[system.linear[l].unknown];
    squares.push_back(sum);
  }
  return squares;
}

bool is_zero_at(const SquareSystem& system, const ComplexVectorX& squares, const ComplexVectorX& x) {
  const double uncertainty = 1e-13 * largest(x);
  const ComplexVectorX found = squares_at(system, x);
  for (std::size_t e = 0; e < found.size(); ++e) {
    const double allowed = uncertainty * (2 * std::sqrt(std::abs(squares[e])) + uncertainty);
    if (!(std::abs(found[e] - squares[e]) <= allowed)) return false;
  }
  return true;
}

ComplexVectorX jacobian_at(const SquareSystem& system, const ComplexVectorX& x) {
  const int n = system.unknowns;
  ComplexVectorX jacobian(static_cast<std::size_t>(system.equations() * n));
  for (int e = 0; e < system.equations(); ++e) {
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, constant] = system.differences[d];
      const std::complex<double> difference = x[minuend] - (subtrahend < 0 ? constant : x[subtrahend]);
      jacobian[e * n + minuend] = difference;
      if (subtrahend >= 0) jacobian[e * n + subtrahend] = -difference;
    }
    for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l)
      jacobian[e * n + system.linear[l].unknown] = system.linear[l].coefficient / 2.0;
  }
  return jacobian;
}

// Of squares, since the standard's absolute value takes many times as long to guard against overflow beyond
// 1e154, which no coordinate of a scene reaches.
double largest(const ComplexVectorX& x) {
  double square = 0;
  for (const std::complex<double>& value : x) square = std::max(square, std::norm(value));
  return std::sqrt(square);
}

double distance(const ComplexVectorX& x, const ComplexVectorX& y) {
  double square = 0;
  for (std::size_t i = 0; i < x.size(); ++i) square = std::max(square, std::norm(x[i] - y[i]));
  return std::sqrt(square);
}

ComplexVectorX random_complex_vector(int size, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  ComplexVectorX x;
  for (int i = 0; i < size; ++i) {
    const double re = normal(random), im = normal(random);
    x.emplace_back(re, im);
  }
  return x;
}

}  // namespace gcs
