#pragma once
/// Who proves, and how far.

#include <stop_token>

#include "solvers/running/work.hpp"

namespace gcs {

class Crew;

/// What is proven is the same for any number of threads, and any crew, unless it is stopped.
struct ProofSetup {
  int threads = 1;  ///< with a crew: of all its members here, while the others wait
  Monitor* monitor = nullptr;
  std::stop_token stop{};
  Crew* crew = nullptr;
};

}  // namespace gcs
