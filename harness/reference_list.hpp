#pragma once
/// The solutions of an instance that are known by proof: what answers are measured against.

#include <optional>
#include <string>
#include <vector>

#include "harness/instance_io.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/work.hpp"

namespace gcs {

struct ReferenceList {
  std::string source;           ///< where they come from, for a person
  std::vector<Figure> figures;  ///< each in a class of its own, in the instance's frame and the file's unit
  bool has_all_real = false;    ///< of the real solutions none is missing: proven, or claimed by the source
  bool has_all_complex = false;
  /// Which of them lie on the path S through the sketch, by proof; empty: not known.
  std::optional<std::vector<bool>> on_path;
};

/// The list in results/reference, if it is of this very instance. Throws InputError for a file that is none.
std::optional<ReferenceList> shipped_reference(const Instance& instance);

/// The shipped list or, where there is none, what the strategies that can do the scene find with their
/// defaults in `limit_s` seconds each, as far as it is proven. S is followed with proof in the same time.
/// Throws InputError as shipped_reference does.
ReferenceList reference_for(const Instance& instance, const Scene& scene, double limit_s, Monitor& progress);

}  // namespace gcs
