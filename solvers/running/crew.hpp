#pragma once
/// Other processes that take over parts of a solve.

#include <functional>
#include <string>
#include <vector>

namespace gcs {

/// What another process does of each item of one task; throws where it cannot.
using ItemWork = std::function<std::string(const std::string& item)>;

class Crew {
 public:
  virtual ~Crew() = default;
  /// The processes that work, this one among them; at least 1.
  virtual int members() const = 0;
  /// The results of all items in their order, whoever did which: they are handed out on demand, and `here(i)` is what this
  /// process does of them. `task` is what they have in common; it, items and results are bytes that travel between
  /// machines of one kind. Empty where `stopped()` came first. Throws std::runtime_error where another process fails.
  virtual std::vector<std::string> results(const std::string& task, const std::vector<std::string>& items,
                                           const std::function<std::string(std::size_t)>& here,
                                           const std::function<bool()>& stopped) = 0;
};

}  // namespace gcs
