#include "solvers/reduction/part_reports.hpp"

#include <algorithm>

namespace gcs {

void add(const std::vector<Particular>& more, std::vector<Particular>& particulars) {
  for (const Particular& particular : more) {
    const auto same = std::find_if(particulars.begin(), particulars.end(),
                                   [&](const Particular& other) { return other.name == particular.name; });
    if (same == particulars.end())
      particulars.push_back(particular);
    else
      same->value += particular.value;
  }
}

bool claims_all(Claim claim) { return claim == Claim::all_real || claim == Claim::all_complex; }

SolveStatus common_status(const std::vector<SolveReport>& reports, bool is_empty) {
  const auto any = [&](SolveStatus status) {
    return std::any_of(reports.begin(), reports.end(),
                       [&](const SolveReport& r) { return r.status == status; });
  };
  if (any(SolveStatus::stopped)) return SolveStatus::stopped;
  if (is_empty) return SolveStatus::complete;
  for (const SolveStatus status : {SolveStatus::gave_up, SolveStatus::infinite, SolveStatus::partial})
    if (any(status)) return status;
  return SolveStatus::complete;
}

Claim common_claim(const std::vector<SolveReport>& reports) {
  Claim claim = Claim::all_complex;
  for (const SolveReport& report : reports)
    if (report.claim != Claim::all_complex && claim != Claim::some_real) claim = report.claim;
  return claim;
}

}  // namespace gcs
