#pragma once
/// The solutions of an instance that are known by proof: what answers are measured against.

#include <optional>
#include <string>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

/// In the instance's frame.
struct KnownSolution {
  DecimalFigure exact;  ///< to 30 digits at least, in the file's unit
  Figure figure;        ///< the nearest doubles, in the scene's unit
};

struct ReferenceList {
  std::string source;                    ///< where they come from, for a person
  std::vector<KnownSolution> solutions;  ///< each in a class of its own
  bool has_all_real = false;             ///< none is missing, by proof or by what a shipped list claims
  bool has_all_complex = false;          ///< likewise
  bool is_real_proven = false;           ///< that no real one is missing is proven
  /// Which of them lie on the path S through the sketch, by proof; empty: not known.
  std::optional<std::vector<bool>> on_path;
};

/// The list in results/reference, if it is of this very instance, whose scene is `scene`. Throws InputError for
/// a file that is none.
std::optional<ReferenceList> shipped_reference(const Instance& instance, const Scene& scene);

/// The shipped list or, where there is none, what is proven of what the strategies that can do the scene find
/// with their defaults in `limit_s` seconds each, and of what lies next to multiple and ill-conditioned
/// solutions. It holds all where the theoretical count is met, be it with proven solutions at infinity, and all real ones
/// where a scan with proof says so. S is followed with proof in the same time. Precondition: certificates reach the
/// scene (see why_not_certified). Throws InputError as shipped_reference does.
ReferenceList reference_for(const Instance& instance, const Scene& scene, double limit_s, Monitor& progress);

}  // namespace gcs
