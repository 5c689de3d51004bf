#pragma once
/// The one place where the library starts threads.

#include <cstddef>
#include <functional>

namespace gcs {

/// Calls function(0), …, function(count − 1), side by side as far as the machine has cores, and returns when
/// all have returned. No call may wait for another one: they may also run one after the other.
void run_on_threads(int count, const std::function<void(int)>& function);

/// Calls function(0), …, function(items − 1) on at most `threads` ≥ 1 threads, each of which takes every threads-th.
void share_on_threads(std::size_t items, int threads, const std::function<void(std::size_t)>& function);

}  // namespace gcs
