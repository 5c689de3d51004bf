#pragma once
/// Numbers as sets of bits, and as sources of bits.

#include <bit>
#include <cstddef>
#include <cstdint>

namespace gcs {

inline std::uint64_t single_bit(std::size_t place) { return std::uint64_t{1} << place; }

/// The place of the lowest bit. Precondition: there is one.
inline std::size_t first_place(std::uint64_t bits) {
  return static_cast<std::size_t>(std::countr_zero(bits));
}

/// The finaliser of SplitMix64: a bijection that spreads every bit.
inline std::uint64_t mixed_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

}  // namespace gcs
