#pragma once
/// The one place where the library starts threads.

#include <cstddef>
#include <functional>
#include <memory>

namespace gcs {

/// Calls function(0), …, function(count − 1), side by side as far as the machine has cores, and returns when
/// all have returned. No call may wait for another one: they may also run one after the other.
void run_on_threads(int count, const std::function<void(int)>& function);

/// Calls function(0), …, function(items − 1) on at most `threads` ≥ 1 threads, each of which takes the next one in turn.
void share_on_threads(std::size_t items, int threads, const std::function<void(std::size_t)>& function);

/// Functions that run beside the caller, as far as the machine has cores; on one with a single core perhaps not before
/// wait().
class Background {
 public:
  explicit Background(int most);
  /// Waits.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// `which` < `most`. Precondition: the last function in this place returns without waiting for anything.
  /// `function` throws nothing.
  void run(int which, std::function<void()> function);
  /// Until all have returned.
  void wait();

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
  bool has_run_ = false;  ///< since wait()
};

}  // namespace gcs
