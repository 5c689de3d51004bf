#include "solvers/systems/system_paths.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/homotopies/total_degree.hpp"
#include "solvers/polyhedral/polyhedral_homotopies.hpp"
#include "solvers/systems/quadratic_lift.hpp"

namespace gcs {
namespace {

/// Coefficients of the equations and then of the products ℓ − u·v.
ComplexVectorX flat(const std::vector<ComplexVectorX>& coefficients, const QuadraticLift& lift) {
  ComplexVectorX all;
  for (const ComplexVectorX& equation : coefficients) all.insert(all.end(), equation.begin(), equation.end());
  for (std::size_t k = 0; k < lift.products.size(); ++k) all.insert(all.end(), {1.0, -1.0});
  return all;
}

/// The equations with x_i^(d_i) and 1 among the monomials of equation i, and the coefficients on both ends.
struct DegreeHomotopy {
  Supports supports;
  std::vector<ComplexVectorX> from, to;
  std::vector<int> degrees;

  DegreeHomotopy(const PolynomialSystem& system, std::mt19937_64& random)
      : supports(supports_of(system)), to(coefficients_of(system)) {
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
    for (std::size_t i = 0; i < supports.size(); ++i) {
      degrees.push_back(system.equations[i].total_degree());
      Exponents power(supports.size(), 0);
      const Exponents one = power;
      power[i] = degrees.back();
      const std::size_t first = place_of(power, i), second = place_of(one, i);
      from.emplace_back(to[i].size(), 0.0);
      const std::complex<double> gamma = std::polar(1.0, turn(random));
      from[i][first] = gamma;
      from[i][second] = -gamma;
    }
  }

 private:
  std::size_t place_of(const Exponents& monomial, std::size_t i) {
    Support& support = supports[i];
    const auto found = std::find(support.begin(), support.end(), monomial);
    const std::size_t place = static_cast<std::size_t>(found - support.begin());
    if (found == support.end()) {
      support.push_back(monomial);
      to[i].push_back(0);
    }
    return place;
  }
};

class Following {
 public:
  Following(const SystemPathsRequest& request, WorkCounters& work)
      : request_(request), work_(work), random_(request.seed) {}

  FollowedSystem run() {
    if (request_.start == PathStart::mixed_cells)
      from_mixed_cells();
    else
      from_degrees();
    result_.is_stopped = stopped_();
    count_jumps();
    return std::move(result_);
  }

 private:
  void from_mixed_cells() {
    const QuadraticLift lift = quadratic_lift(supports_of(request_.system));
    request_.progress("mixed cells", -1);
    const MixedCells cells =
        mixed_cells(lift.supports, {request_.seed, request_.setup.threads, request_.stop});
    if (cells.status != MixedCellStatus::complete) {
      result_.why_none = "the mixed cells of the equations' monomials were not found";
      return;
    }
    const std::vector<int> no_axes(lift.supports.size(), -1);
    const GenericZeros zeros = follow_polyhedral_homotopies(
        cells, no_axes, request_.setup, random_, stopped_,
        [&](double fraction) { request_.progress("polyhedral homotopies", fraction); }, work_);
    const std::int64_t lost = zeros.paths - static_cast<std::int64_t>(zeros.zeros.size());
    if (!zeros.zeros.empty())
      follow(lift, zeros.zeros, zeros.coefficients, flat(coefficients_of(request_.system), lift));
    PathEnd failed;
    failed.cause = "it got lost on the way from a mixed cell";
    result_.ends.insert(result_.ends.end(), static_cast<std::size_t>(lost), failed);
    if (zeros.unsolved_cells > 0) result_.why_none = "a binomial system was too large to be solved";
  }

  void from_degrees() {
    const DegreeHomotopy homotopy(request_.system, random_);
    const QuadraticLift lift = quadratic_lift(homotopy.supports);
    std::vector<ComplexVectorX> starts;
    for (ComplexVectorX& x : roots_of_unity(homotopy.degrees)) starts.push_back(lift.lifted(std::move(x)));
    follow(lift, starts, flat(homotopy.from, lift), flat(homotopy.to, lift));
  }

  void follow(const QuadraticLift& lift, const std::vector<ComplexVectorX>& starts,
              const ComplexVectorX& from, const ComplexVectorX& to) {
    const MonomialSystem system = monomial_system(lift.supports);
    const Elimination elimination = order_elimination(system, starts, from, to, random_);
    LegTracking tracking(system, elimination, request_.setup);
    const auto is_zero = [&](const ComplexVectorX& x) { return is_zero_at(system, to, x); };
    result_.ends = follow_to_end(
        tracking, starts, from, to, is_zero, stopped_,
        [&](double fraction) { request_.progress("paths to the system", fraction); }, work_);
    settle(system, to, request_.setup.threads, result_.ends);
    for (PathEnd& end : result_.ends)
      if (!end.x.empty()) end.x.resize(static_cast<std::size_t>(lift.unknowns));
  }

  void count_jumps() {
    SolutionSet distinct(std::vector<int>(static_cast<std::size_t>(request_.system.unknowns), -1), random_);
    for (const PathEnd& end : result_.ends) {
      if (end.kind != PathEnd::Kind::regular) continue;
      const int known = distinct.size();
      distinct.insert(end.x, regular_uncertainty);
      result_.jumps += distinct.size() == known;
    }
  }

  const SystemPathsRequest& request_;
  WorkCounters& work_;
  std::mt19937_64 random_;
  const std::function<bool()> stopped_ = [this] { return request_.stop.stop_requested(); };
  FollowedSystem result_;
};

}  // namespace

std::optional<Natural> mixed_volume(const Supports& supports, std::uint64_t seed, int threads,
                                    const std::stop_token& stop) {
  const MixedCells cells = mixed_cells(supports, {seed, threads, stop});
  if (cells.status != MixedCellStatus::complete) return std::nullopt;
  return cells.total_volume();
}

FollowedSystem follow_system_paths(const SystemPathsRequest& request, WorkCounters& work) {
  return Following(request, work).run();
}

}  // namespace gcs
