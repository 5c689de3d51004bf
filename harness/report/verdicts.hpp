#pragma once
/// What is proven, refuted or open about the numbers of solutions of an instance.

#include <optional>
#include <string>
#include <vector>

#include "harness/runs/shown_scene_files.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {

enum class VerdictStanding { proven, refuted, open };

/// "proven", "refuted" or "open".
std::string_view word(VerdictStanding standing);

/// One number of one instance, as printed and as found.
struct Verdict {
  std::string quantity;  ///< "complex solutions"
  std::string printed;   ///< the published number with its convention; empty: none
  std::optional<VerdictStanding> printed_standing{};  ///< empty: nothing is printed
  std::string ours;                                   ///< up to reflection, unless it says otherwise
  VerdictStanding our_standing = VerdictStanding::open;
  std::string reason{};  ///< of both
};

/// Complex and real solutions, and those on S, as far as the run or the stored scene (may be null) know them.
std::vector<Verdict> verdicts(const RunFile& run, const InstanceSummary& instance, const StoredScene* scene,
                              const Publications& publications);

/// Those of all instances. `scenes`: by id, those that were stored.
Table verdict_table(const RunFile& run, const std::map<std::string, StoredScene>& scenes,
                    const Publications& publications);

}  // namespace gcs
