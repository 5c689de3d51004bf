#pragma once
/// A fingerprint of numbers, to the bit: no protection against malice, but against every mistake.

#include <bit>
#include <complex>
#include <cstdint>
#include <span>

namespace gcs {

/// Each word is mixed in by the finaliser of SplitMix64 (Steele, Lea, Flood 2014), which is one to one: two
/// sequences that differ in one word never have one digest.
class Digest {
 public:
  void add(std::uint64_t word) {
    state_ ^= word + 0x9e3779b97f4a7c15;
    state_ = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9;
    state_ = (state_ ^ (state_ >> 27)) * 0x94d049bb133111eb;
    state_ ^= state_ >> 31;
  }
  void add(std::span<const double> values) {
    for (const double value : values) add(std::bit_cast<std::uint64_t>(value));
  }
  void add(std::span<const std::complex<double>> values) {
    for (const std::complex<double>& value : values)
      for (const double part : {value.real(), value.imag()}) add(std::bit_cast<std::uint64_t>(part));
  }

  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace gcs
