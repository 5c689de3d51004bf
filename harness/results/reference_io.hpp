#pragma once
/// Writes gcsbench-reference/1: the proven solutions of an instance with many digits, for measuring errors.

#include <string>

#include "harness/results/result_reader.hpp"

namespace gcs {

struct ReferenceSettings {
  int digits = 30;         ///< significant ones of every number
  bool only_real = false;  ///< leave the complex solutions out
  int threads = 1;
};

/// The solutions that a result lists, each proven anew to be a solution of its own class and written in
/// decimals with a bound on their error, and what is proven of the whole list. Throws InputError where one of
/// them is not proven. Precondition: certificates reach the scene (see why_not_certified).
std::string reference_text(const StoredResult& result, const ReferenceSettings& settings, Monitor& progress);

}  // namespace gcs
