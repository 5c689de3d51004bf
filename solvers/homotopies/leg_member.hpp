#pragma once
/// Follows what another process sends.

#include <memory>
#include <string>
#include <string_view>

#include "solvers/homotopies/leg_tracking.hpp"

namespace gcs {

/// The other side of LegTracking with a crew: one task at a time.
class LegMember {
 public:
  /// `task` is that of a Crew. Throws std::invalid_argument for bytes that are none.
  explicit LegMember(std::string_view task);

  /// The result of an item, with the same bits wherever it is followed: instructions that this machine does not have are
  /// replaced. Throws likewise.
  std::string result(std::string_view item);

 private:
  LegTask task_;
  std::unique_ptr<LegTracking> tracking_;
};

}  // namespace gcs
