#pragma once
/// A crew of the ranks of one run: the first one hands out, the others do what they get.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/ranks/message_passing.hpp"
#include "solvers/running/crew.hpp"

namespace gcs {

/// The rank that gets the next of the `left` items that nobody has, where `queued` are those that each rank has and has
/// not done: one to do, and up to `reserve` for when that is done while enough are left that nobody ends with several of
/// them and others with none. The first rank, which need not wait for a message, comes last among equals. Nullopt: nobody
/// gets one now.
std::optional<int> next_receiver(const std::vector<int>& queued, std::size_t left, std::size_t reserve);

/// Of the first rank. It works too, between messages; while the others wait it has the cores of those on its machine.
class RankCrew final : public Crew {
 public:
  /// Waits for the others. `build`: what all must have in common.
  RankCrew(const MessagePassing& passing, const std::string& build);
  /// Lets the others go.
  ~RankCrew() override;
  RankCrew(const RankCrew&) = delete;
  RankCrew& operator=(const RankCrew&) = delete;

  /// Why the ranks cannot work together, in a sentence; empty where they can.
  const std::string& misfit() const { return misfit_; }

  int members() const override { return passing_.size; }
  int members_here() const override { return passing_.on_this_machine; }
  std::unique_ptr<ItemWork> share(const std::string& task, ItemWork& here) override;

 private:
  class SharedWork;

  const MessagePassing& passing_;
  std::string misfit_;
  std::vector<std::string> told_;  ///< of each rank, its last task
};

/// Of every other rank: does what the first one sends, until it lets go. `build` as above; `begin` makes what is to be done
/// of the bytes of a task.
void serve(const MessagePassing& passing, const std::string& build,
           const std::function<std::unique_ptr<ItemWork>(const std::string& task)>& begin);

}  // namespace gcs
