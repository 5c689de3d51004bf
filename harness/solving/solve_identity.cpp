#include "harness/solving/solve_identity.hpp"

#include "solvers/reading/json_build.hpp"

namespace gcs {

JsonValue solve_identity(const Instance& instance, const StrategyEntry& entry, const OptionMap& options,
                         std::uint64_t seed, const Environment& environment) {
  JsonMembers settings;
  for (const OptionSpec& spec : entry.options)
    if (spec.changes_result) settings.emplace_back(spec.name, json_text(options.find(spec.name)->second));
  JsonValue program = json_object({{"commit", json_text(environment.commit)},
                                   {"compiler", json_text(environment.compiler)},
                                   {"flags", json_text(environment.flags)}});
  return json_object({{"program", std::move(program)},
                      {"instance", instance.document},
                      {"strategy", json_text(std::string(entry.name))},
                      {"options", json_object(std::move(settings))},
                      {"seed", json_count(seed)}});
}

}  // namespace gcs
