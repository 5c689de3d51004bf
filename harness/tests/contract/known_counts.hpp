#pragma once
/// What is known of the shipped instances, up to reflection.

#include <cstdint>
#include <optional>
#include <string_view>

namespace gcs::contract {

struct KnownCounts {
  std::string_view instance;
  std::optional<std::uint64_t> on_path;  ///< on S; empty: no sketch
  std::uint64_t real = 0;
  std::optional<std::uint64_t> complex;  ///< finite ones, real ones included; empty: not known
};

/// Nothing for an instance that is not in the list.
std::optional<KnownCounts> known_counts(std::string_view instance);

}  // namespace gcs::contract
