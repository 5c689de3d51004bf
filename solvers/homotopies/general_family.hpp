#pragma once
/// The equations of a general scene as trackers take them. Parameters are all coefficients; those that may change are the
/// values that the file gives to constraints, each alone on the right-hand side of an equation.
///
/// All figures that meet what has no value, with the values that they give, are the graph of a polynomial map; monodromy
/// over the values reaches all solutions of a random member that are on one component of it with the first.

#include <complex>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/homotopies/monodromy_search.hpp"
#include "solvers/lanes/elimination.hpp"
#include "solvers/lanes/monomial_system.hpp"

namespace gcs {

/// Of each product of two unknowns, the higher one first, its coefficient; −1 stands for a factor 1.
using Expansion = std::map<std::pair<int, int>, std::complex<double>>;

/// Σ left·right − given, multiplied out in doubles.
Expansion expanded(const QuadraticEquation& equation);

/// Sparse equations with coefficients.
struct GeneralEquations {
  MonomialSystem system;
  ComplexVectorX coefficients;  ///< one per monomial
  /// Of each equation the monomial whose coefficient is a constant minus its value; −1: it has none.
  std::vector<int> value_monomial;
  ComplexVectorX constants;  ///< one per equation
  SignMasks signs;
  QuadraticSystem exact;  ///< the same equations
};

GeneralEquations general_equations(const SceneSystem& scene);

/// The same for paths along which values change and nothing else: monomials with one coefficient are said to share it.
GeneralEquations sharing_coefficients(GeneralEquations equations);

/// The values on the right-hand sides, of the equations that have one in their order, for these coefficients; and the
/// coefficients for these values.
ComplexVectorX values_of(const GeneralEquations& equations, const ComplexVectorX& coefficients);
ComplexVectorX with_values(const GeneralEquations& equations, const ComplexVectorX& values);

/// A figure at random that meets the equations without a value, to rounding, with the coefficients that make it a zero of
/// all. Throws std::runtime_error where none is found. Time: some singular value decompositions.
FamilyMember random_member(const GeneralEquations& equations, std::mt19937_64& random);

HomotopyFamily family_of(const GeneralEquations& equations);

/// The equations with all coefficients free, but that monomials which share one still do; members are random zeros of
/// random coefficients. It holds the equations of the same bodies in other shapes.
HomotopyFamily family_of_coefficients(const GeneralEquations& equations);

/// The samples are Jacobians at random members.
Elimination order_elimination(const MonomialSystem& system, const HomotopyFamily& family,
                              std::mt19937_64& random);

/// Newton's method from x for these coefficients: whether it settles, at a point that replaces x. Where x is real it
/// stays so if the coefficients are.
bool newton(const MonomialSystem& system, const ComplexVectorX& coefficients, ComplexVectorX& x);

}  // namespace gcs
