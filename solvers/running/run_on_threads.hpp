#pragma once
/// The one place where the library starts threads.

#include <functional>

namespace gcs {

/// Calls function(0), …, function(count − 1), side by side as far as the machine has cores, and returns when
/// all have returned. No call may wait for another one: they may also run one after the other.
void run_on_threads(int count, const std::function<void(int)>& function);

}  // namespace gcs
