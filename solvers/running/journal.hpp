#pragma once
/// What lets an interrupted solve go on: a journal of the results of its expensive steps.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace gcs {

/// Of a strategy that keeps a journal, everything between its expensive steps is cheap, and the steps and
/// their order follow from the input alone. So a second run from the beginning asks for the same steps again,
/// and takes the results that the first one had from the journal.
class Journal {
 public:
  using Block = std::vector<double>;

  virtual ~Journal() = default;
  /// The result of the next step: the recorded one, or what `compute` gives, which is then recorded.
  /// `fingerprint`: of all that the step depends on; a record of another step is never returned (how that is
  /// refused is the journal's choice). `compute` gives nothing when it was stopped; then nothing is recorded
  /// or returned. Called from one thread.
  virtual std::optional<Block> result(std::uint64_t fingerprint,
                                      const std::function<std::optional<Block>()>& compute) = 0;
};

}  // namespace gcs
