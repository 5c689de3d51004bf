#include <fmt/format.h>

#include "harness/tests/contract/strategy_contract.hpp"
#include "solvers/answers/certify.hpp"

namespace gcs::contract {

Violations check_certificates(const Scene& scene, const SolveReport& report) {
  Violations found;
  Assessment assessment = assess(scene, report);
  certify(scene, theoretical_counts(scene.problem()), report.generic_member, {.threads = 2}, assessment);
  for (const FailedCheck& check : assessment.failed_checks)
    if (check.name == "certificate") found.push_back({"certificate", check.what});
  const Proofs& proofs = *assessment.proofs;
  for (const std::uint64_t classes : {proofs.classes, proofs.generic.value_or(0)})
    if (proofs.limit && Natural(classes) > *proofs.limit)
      found.push_back(
          {"certificate", fmt::format("{} classes proven, at most {}", classes, proofs.limit->decimal())});
  if (proofs.figure_limit && Natural(proofs.classes + proofs.with_image) > *proofs.figure_limit)
    found.push_back(
        {"certificate", fmt::format("{} figures proven, at most {}", proofs.classes + proofs.with_image,
                                    proofs.figure_limit->decimal())});
  return found;
}

}  // namespace gcs::contract
