#pragma once
/// Certifies a stored result anew, from nothing but its file: the instance and the numbers that it lists.

#include <vector>

#include "harness/results/result_reader.hpp"

namespace gcs {

struct Verification {
  Proofs proofs;
  /// Names: solution, multiplicity, class, real, standing, conjugate, count, convention.
  std::vector<FailedCheck> mismatches;
};

/// Each solution lies within its error bound (where there is none, within 1e-12 of the scene's size) of a
/// proven solution that is simple, and real or not and as stated or not as listed, or of a proven cluster of as
/// many solutions as its multiplicity says; no two are the same class; a list that claims to hold all complex
/// solutions of a complete run holds their conjugates; every count equals what the list gives. Completeness that
/// is only found is no mismatch. Precondition: certificates reach the scene (see why_not_certified). The same for
/// any number of threads. `monitor` may be null.
Verification verify(const StoredResult& result, int threads, Monitor* monitor = nullptr);

}  // namespace gcs
