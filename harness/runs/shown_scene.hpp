#pragma once
/// What the page shows of an instance beside its measurements, as versioned JSON (gcsbench-scene/1): the
/// instance itself, its real solutions, and what is known of places along the path S. S itself lies beside
/// it as gcsbench-path/1 (path_io.hpp).

#include <optional>
#include <string>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/certificates/figure_distance.hpp"

namespace gcs {

/// In the instance's frame and the file's unit.
struct ShownSolution {
  Figure figure;
  int multiplicity = 1;
};

/// A crossing of t = 1: the point of S is the mirror image of the solution by `signs`.
struct MetSolution {
  int solution = 0;  ///< index into ShownScene::solutions
  AxisSigns signs{1, 1, 1};
};

/// From here on S was followed with a plan that leaves the constraints `removed` out.
struct PlanPlace {
  double t = 0;
  double length = 0;  ///< arc length of S from the sketch, in the file's unit
  std::vector<std::string> removed;
};

/// The plans with which one cell of the run followed S, the first from the sketch on.
struct PlanTrail {
  std::string label;  ///< strategy and options
  std::vector<PlanPlace> places;
  std::string cause;  ///< why there are no places; empty when there are
};

/// Figures to move through, a polyline: of a motion of the scene, or without one of its values from one solution to the next.
struct ShownCurve {
  std::string label;            ///< for a person
  std::string constraint;       ///< the one whose value the figures need not meet; empty: they meet all
  std::optional<int> from, to;  ///< indices into ShownScene::solutions; empty of a motion
  std::vector<Figure> figures;  ///< in the file's unit; of a motion in the instance's frame
};

struct ShownScene {
  Instance instance;
  std::vector<ShownSolution> solutions;               ///< real ones, one of each class
  std::string source;                                 ///< where the solutions come from, for a person
  bool are_proven = false;                            ///< each of them
  bool has_all_real = false;                          ///< none is missing, as far as the source can tell
  bool is_real_proven = false;                        ///< that none is missing is proven
  std::string no_path;                                ///< why S is not stored; empty when it is
  std::vector<std::optional<MetSolution>> crossings;  ///< of t = 1, in the order of S; empty: in no list
  std::vector<PlanTrail> trails;
  std::vector<ShownCurve> curves;
};

/// The record as JSON, ending in a newline.
std::string to_json_text(const ShownScene& record);

/// Reads what to_json_text wrote. `file` is for messages. Throws InputError.
ShownScene parse_shown_scene(const std::string& text, const std::string& file);

}  // namespace gcs
