#include "solvers/systems/system_facts.hpp"

#include "solvers/systems/homogeneous_bound.hpp"
#include "solvers/systems/system_paths.hpp"

namespace gcs {

std::vector<Particular> system_facts(const PolynomialSystem& system, const SolveMeans& means) {
  const Supports supports = supports_of(system);
  const auto number = [](const Natural& value) { return static_cast<std::int64_t>(value.approximate()); };
  std::vector<Particular> facts{{"unknowns", system.unknowns},
                                {"terms", system.terms()},
                                {"total_degree", number(system.total_degree())},
                                {"homogeneous_bound", number(small_homogeneous_bound(supports).bound)}};
  if (const auto volume = mixed_volume(supports, means.seed, means.threads, means.stop))
    facts.push_back({"mixed_volume", number(*volume)});
  return facts;
}

}  // namespace gcs
