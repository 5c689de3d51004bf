#pragma once
/// What holds the answers about one instance, made when it is first asked for: finding a reference may take
/// longer than measuring.

#include <optional>
#include <string>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/accuracy.hpp"

namespace gcs {

class InstanceJudge {
 public:
  /// Keeps references to both.
  InstanceJudge(const Instance& instance, const Scene& scene);

  /// Null where there is no reference, or an interrupt came before there was one. Throws InputError as
  /// shipped_reference does.
  const AccuracyJudge* judge(Monitor& progress);
  /// What errors are measured against, or why they are not, for a person. Empty before judge() was asked.
  const std::string& reference() const { return reference_; }

 private:
  void find_reference(Monitor& progress);

  const Instance& instance_;
  const Scene& scene_;
  std::string reference_;
  std::optional<AccuracyJudge> judge_;
};

}  // namespace gcs
