#include "solvers/polyhedral/polyhedral_homotopies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/polyhedral/binomial_roots.hpp"

namespace gcs {
namespace {

constexpr double start_size = 1e-8;       // of the lowest factor e^(h τ) at the start
constexpr std::int64_t most_legs = 1024;  // of a cell between two reports of progress

SignMask sign_of(const Exponents& exponents, const SignMasks& signs) {
  SignMask sign = 0;
  for (std::size_t v = 0; v < exponents.size(); ++v)
    if (exponents[v] % 2 != 0) sign ^= signs[v];
  return sign;
}

/// Unknowns that the group gives every pattern of signs, each by one of its patterns.
std::vector<int> independent_unknowns(const SignMasks& signs) {
  std::vector<int> result;
  SignEquations equations;
  for (std::size_t v = 0; v < signs.size(); ++v) {
    const int rank = equations.rank();
    equations.add(signs[v], true);
    if (equations.rank() > rank) result.push_back(static_cast<int>(v));
  }
  return result;
}

/// h_a of every monomial, in the order of the MonomialSystem.
std::vector<double> heights(const MixedCells& cells, const MixedCell& cell) {
  std::vector<double> result;
  for (std::size_t i = 0; i < cells.supports.size(); ++i) {
    const Support& support = cells.supports[i];
    const auto [lowest, other] = cell.edges[i];
    for (int c = 0; c < static_cast<int>(support.size()); ++c) {
      if (c == lowest || c == other) {
        result.push_back(0);
        continue;
      }
      double height = static_cast<double>(cells.lifting[i][c] - cells.lifting[i][lowest]);
      for (std::size_t v = 0; v < support[c].size(); ++v)
        height += (support[c][v] - support[lowest][v]) * cell.normal[v];
      result.push_back(height);
    }
  }
  return result;
}

/// The way from the binomial system of a cell to all monomials.
Route route_of(const ComplexVectorX& coefficients, const std::vector<double>& heights) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const double height : heights)
    if (height > 0) smallest = std::min(smallest, height);
  const ComplexVectorX zero(coefficients.size());
  Route route{{coefficients, zero, zero, zero}, coefficients, {}};
  for (const double height : heights) route.rates.push_back(-std::log(start_size) * (height / smallest));
  return route;
}

struct BinomialSystem {
  IntegerMatrix exponents;
  std::vector<double> turns;  ///< arguments of the right-hand sides, of modulus 1
};

/// c_a x^a + c_b x^b = 0 for the edges {a, b} of a cell.
BinomialSystem binomial_system(const MixedCells& cells, const MixedCell& cell, const MonomialSystem& system,
                               const ComplexVectorX& coefficients) {
  BinomialSystem result;
  for (std::size_t i = 0; i < cells.supports.size(); ++i) {
    const auto [a, b] = cell.edges[i];
    std::vector<std::int64_t>& row = result.exponents.emplace_back();
    for (std::size_t v = 0; v < cells.supports.size(); ++v)
      row.push_back(cells.supports[i][a][v] - cells.supports[i][b][v]);
    const int first = system.first[i];
    const std::complex<double> ratio = -coefficients[first + b] / coefficients[first + a];
    result.turns.push_back(std::arg(ratio) / (2 * std::numbers::pi));
  }
  return result;
}

ComplexVectorX on_torus(const std::vector<double>& turns) {
  ComplexVectorX x;
  for (const double turn : turns) x.push_back(std::polar(1.0, 2 * std::numbers::pi * turn));
  return x;
}

/// Jacobians at starts of a cell, where only its own monomials count, and at random points at its end.
std::vector<ComplexVectorX> sample_jacobians(const MonomialSystem& system, const ComplexVectorX& coefficients,
                                             const std::vector<double>& heights,
                                             const std::vector<ComplexVectorX>& starts,
                                             std::mt19937_64& random) {
  constexpr std::size_t samples = 3;
  ComplexVectorX lowest = coefficients;
  for (std::size_t j = 0; j < lowest.size(); ++j)
    if (heights[j] > 0) lowest[j] = 0;
  std::vector<ComplexVectorX> jacobians;
  for (std::size_t i = 0; i < std::min(samples, starts.size()); ++i)
    jacobians.push_back(jacobian_at(system, lowest, starts[i * (starts.size() - 1) / samples]));
  for (std::size_t i = 0; i < samples; ++i)
    jacobians.push_back(jacobian_at(system, coefficients, random_complex_vector(system.unknowns, random)));
  return jacobians;
}

class Homotopies {
 public:
  Homotopies(const MixedCells& cells, const SignMasks& signs, const TrackingSetup& setup,
             std::mt19937_64& random, const std::function<bool()>& stopped,
             const std::function<void(double)>& progress, WorkCounters& work)
      : cells_(cells),
        setup_(setup),
        random_(random),
        stopped_(stopped),
        progress_(progress),
        work_(work),
        system_(monomial_system(cells.supports)),
        signs_(symmetric_signs(cells.supports, signs)),
        mirrored_(independent_unknowns(signs_)),
        distinct_(signs_, random) {
    std::uniform_real_distribution<double> turn;
    std::vector<double> turns;
    for (std::size_t j = 0; j < system_.monomials.size(); ++j) turns.push_back(turn(random));
    result_.coefficients = on_torus(turns);
    result_.mirror_images = std::int64_t{1} << mirrored_.size();
  }

  GenericZeros run() {
    for (std::size_t i = 0; i < cells_.cells.size() && !result_.stopped; ++i) follow(cells_.cells[i]);
    result_.zeros = distinct_.solutions();
    return std::move(result_);
  }

 private:
  void follow(const MixedCell& cell) {
    const BinomialSystem binomials = binomial_system(cells_, cell, system_, result_.coefficients);
    const std::optional<BinomialRoots> roots = BinomialRoots::of(binomials.exponents);
    if (!roots || roots->volume() != cell.volume) {
      ++result_.unsolved_cells;
      return;
    }
    const std::vector<double> h = heights(cells_, cell);
    const Route route = route_of(result_.coefficients, h);
    std::int64_t first = 0;
    std::vector<ComplexVectorX> starts = starts_of(*roots, binomials, first);
    while (starts.empty()) starts = starts_of(*roots, binomials, first += most_legs);
    const Elimination elimination =
        order_elimination(system_, sample_jacobians(system_, result_.coefficients, h, starts, random_));
    LegTracking tracking(system_, elimination, setup_);
    while (true) {
      follow(starts, route, tracking);
      first += most_legs;
      if (first >= roots->volume() || result_.stopped) return;
      starts = starts_of(*roots, binomials, first);
    }
  }

  /// One of each set of mirror images among the roots from number `first` on, at most `most_legs` of them.
  std::vector<ComplexVectorX> starts_of(const BinomialRoots& roots, const BinomialSystem& binomials,
                                        std::int64_t first) const {
    std::vector<ComplexVectorX> starts;
    for (std::int64_t i = first; i < std::min(first + most_legs, roots.volume()); ++i) {
      const std::vector<double> angles = roots.angles(binomials.turns, i);
      if (std::all_of(mirrored_.begin(), mirrored_.end(), [&](int v) { return angles[v] < 0.5; }))
        starts.push_back(on_torus(angles));
    }
    return starts;
  }

  void follow(const std::vector<ComplexVectorX>& starts, const Route& route, LegTracking& tracking) {
    std::vector<Leg> legs;
    for (const ComplexVectorX& start : starts) legs.push_back({start.data(), &route});
    const std::vector<LegResult> ends = tracking.follow(legs, stopped_, work_);
    result_.stopped = stopped_();
    if (result_.stopped) return;
    result_.paths += static_cast<std::int64_t>(starts.size());
    progress_(static_cast<double>(result_.paths * result_.mirror_images) / all_paths_);
    for (const LegResult& end : ends) sort_in(end);
  }

  void sort_in(const LegResult& end) {
    if (end.state.end != LegEnd::arrived) {
      ++result_.lost;
      return;
    }
    const int known = distinct_.size();
    distinct_.insert(end.x, end.state.last_correction);
    result_.repeated += distinct_.size() == known;
  }

  const MixedCells& cells_;
  const TrackingSetup& setup_;
  std::mt19937_64& random_;
  const std::function<bool()>& stopped_;
  const std::function<void(double)>& progress_;
  WorkCounters& work_;
  const double all_paths_ = cells_.total_volume().approximate();
  MonomialSystem system_;
  SignMasks signs_;            ///< that are divided out
  std::vector<int> mirrored_;  ///< a start is followed where these have arguments in [0, π)
  SolutionSet distinct_;
  GenericZeros result_;
};

}  // namespace

MonomialSystem monomial_system(const Supports& supports) {
  MonomialSystem system;
  system.unknowns = static_cast<int>(supports.size());
  for (const Support& support : supports) {
    for (const Exponents& exponents : support) {
      Monomial monomial;
      for (int v = 0; v < system.unknowns; ++v)
        for (int i = 0; i < exponents[v]; ++i) (monomial.u < 0 ? monomial.u : monomial.v) = v;
      system.monomials.push_back(monomial);
    }
    system.first.push_back(static_cast<int>(system.monomials.size()));
  }
  return system;
}

Supports supports_of(const MonomialSystem& system) {
  Supports supports;
  for (int e = 0; e < system.equations(); ++e) {
    Support& support = supports.emplace_back();
    for (int j = system.first[e]; j < system.first[e + 1]; ++j) {
      Exponents& exponents = support.emplace_back(static_cast<std::size_t>(system.unknowns), 0);
      for (const int factor : {system.monomials[j].u, system.monomials[j].v})
        if (factor >= 0) ++exponents[factor];
    }
  }
  return supports;
}

SignMasks symmetric_signs(const Supports& supports, const SignMasks& signs) {
  SignMask changed = 0;
  for (const Support& support : supports)
    for (const Exponents& exponents : support)
      changed |= sign_of(exponents, signs) ^ sign_of(support.front(), signs);
  SignMasks result;
  for (const SignMask mask : signs) result.push_back(mask & ~changed);
  return result;
}

GenericZeros follow_polyhedral_homotopies(const MixedCells& cells, const SignMasks& signs,
                                          const TrackingSetup& setup, std::mt19937_64& random,
                                          const std::function<bool()>& stopped,
                                          const std::function<void(double)>& progress, WorkCounters& work) {
  return Homotopies(cells, signs, setup, random, stopped, progress, work).run();
}

}  // namespace gcs
