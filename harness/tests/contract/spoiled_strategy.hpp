#pragma once
/// Strategies that are wrong in one way: full-space with something done to its report.

#include <memory>
#include <optional>
#include <string>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs::contract {

/// The strategy that is spoiled.
StrategyEntry sound_strategy();

/// What a wrong strategy may go by when it spoils a report.
struct Circumstances {
  const SolveRequest& request;
  int call = 0;                  ///< of this object, from 0
  int object = 0;                ///< of this class, from 0
  bool saw_other_scene = false;  ///< this object has solved another scene before
};

using Spoil = void (*)(SolveReport&, const Circumstances&);

/// The sound strategy, whose report is spoiled afterwards. One that is deaf does not hear of a stop.
template <Spoil spoil, bool is_deaf>
class SpoiledStrategy final : public Strategy {
 public:
  explicit SpoiledStrategy(const OptionMap& options)
      : sound_(sound_strategy().make(options)), object_(objects++) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    return sound_->why_unsupported(request);
  }

  SolveReport solve(const SolveRequest& request) override {
    SolveRequest asked = request;
    if (is_deaf) asked.stop = {};
    SolveReport report = sound_->solve(asked);
    saw_other_scene_ = saw_other_scene_ || (scene_ && scene_ != &request.scene);
    scene_ = &request.scene;
    spoil(report, {request, call_++, object_, saw_other_scene_});
    return report;
  }

 private:
  static inline int objects = 0;
  std::unique_ptr<Strategy> sound_;
  int object_;
  int call_ = 0;
  const Scene* scene_ = nullptr;
  bool saw_other_scene_ = false;
};

/// An entry like the sound strategy's that makes `Wrong` from the options.
template <class Wrong>
StrategyEntry wrong_entry() {
  StrategyEntry entry = sound_strategy();
  entry.name = "wrong";
  entry.make = [](const OptionMap& options) -> std::unique_ptr<Strategy> {
    return std::make_unique<Wrong>(options);
  };
  return entry;
}

template <Spoil spoil>
StrategyEntry spoiled() {
  return wrong_entry<SpoiledStrategy<spoil, false>>();
}

template <Spoil spoil>
StrategyEntry deaf() {
  return wrong_entry<SpoiledStrategy<spoil, true>>();
}

}  // namespace gcs::contract
