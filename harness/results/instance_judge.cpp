#include "harness/results/instance_judge.hpp"

#include <fmt/format.h>

#include <utility>

#include "harness/base/stop_conditions.hpp"
#include "harness/results/reference_list.hpp"
#include "solvers/certificates/scene_equations.hpp"

namespace gcs {
namespace {

/// In seconds: for every strategy where a reference must be made, and for S.
constexpr double reference_limit_s = 20;

}  // namespace

InstanceJudge::InstanceJudge(const Instance& instance, const Scene& scene)
    : instance_(instance), scene_(scene) {}

const AccuracyJudge* InstanceJudge::judge(Monitor& progress) {
  if (reference_.empty()) find_reference(progress);
  return judge_ ? &*judge_ : nullptr;
}

void InstanceJudge::find_reference(Monitor& progress) {
  if (const auto reason = why_not_certified(scene_)) {
    reference_ = "none: " + *reason;
    return;
  }
  progress.progress("reference", -1);
  ReferenceList list = reference_for(instance_, scene_, reference_limit_s, progress);
  if (interrupted()) return;
  if (list.solutions.empty()) {
    reference_ = "none: no solution is proven";
    return;
  }
  reference_ = fmt::format("{}, {} solutions", list.source, list.solutions.size());
  judge_.emplace(scene_, std::move(list));
}

}  // namespace gcs
