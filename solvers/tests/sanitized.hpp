#pragma once
/// Under sanitizers a solve takes twenty times as long, and what is repeated with other numbers is repeated
/// less often: they look for faults of memory and arithmetic, which do not hide from a sample.

namespace gcs {

#if defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

/// How often to repeat: a quarter under sanitizers.
constexpr int repetitions(int count) { return is_sanitized ? (count + 3) / 4 : count; }

}  // namespace gcs
