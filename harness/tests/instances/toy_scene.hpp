#pragma once
/// A scene whose solutions can be written down: points on whole coordinates, in the plane.

#include <string>
#include <string_view>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs::toy {

/// p3 and p4 hang on the segment p1–p2 of length 6: two classes, p4 on the side of p3 or on the other one.
/// `fourth` are the distances of p4 from p1 and p2; 8 and 10 put it at (0, ±8), 2 and 4 at (2, 0), a double
/// solution.
inline std::string instance_text(std::string_view first = "8", std::string_view second = "10",
                                 bool with_sketch = true) {
  std::string text =
      R"({"format": "gcsbench-instance/1", "id": "toy", "title": "Toy", "dimension": 2,
 "points": ["p1", "p2", "p3", "p4"],
 "constraints": [
  {"id": "base", "type": "distance", "between": ["p1", "p2"], "length": 6},
  {"id": "a2", "type": "distance", "between": ["p1", "p3"], "length": 5.0},
  {"id": "a3", "type": "distance", "between": ["p2", "p3"], "squared": 25},
  {"id": "a4", "type": "distance", "between": ["p1", "p4"], "length": )";
  text += std::string(first) + R"(},
  {"id": "a5", "type": "distance", "between": ["p2", "p4"], "length": )" +
          std::string(second) + "}],\n";
  if (with_sketch) text += R"( "sketch": {"p1": [0, 0], "p2": [5, 0], "p3": [2, 3], "p4": [1, 7]},)";
  return text + R"( "reference": {"origin": "p1", "axis": "p2"}})";
}

inline Instance instance(std::string_view first = "8", std::string_view second = "10",
                         bool with_sketch = true) {
  return parse_instance(instance_text(first, second, with_sketch), "toy.json", "toy");
}

/// A candidate with p1 at (0, 0), p2 at (6, 0), and p3 and p4 as given in the file's unit.
inline Candidate candidate(const Scene& scene, Eigen::Vector2d p3, Eigen::Vector2d p4) {
  Candidate result;
  result.figure.points = Eigen::Matrix3Xd::Zero(3, 4);
  result.figure.points(0, 1) = 6;
  result.figure.points.col(2).head<2>() = p3;
  result.figure.points.col(3).head<2>() = p4;
  result.figure.points *= std::ldexp(1.0, -scene.unit_exponent());
  return result;
}

/// A closed path through all four solutions of the 8–10 scene: same side, opposite, and their mirror images.
inline SolveReport good_report(const Scene& scene) {
  SolveReport report;
  report.status = SolveStatus::complete;
  report.claim = Claim::on_path;
  report.candidates = {candidate(scene, {3, 4}, {0, 8}), candidate(scene, {3, 4}, {0, -8}),
                       candidate(scene, {3, -4}, {0, -8}), candidate(scene, {3, -4}, {0, 8})};
  PathRecord path;
  path.end = PathRecord::End::closed;
  path.crossings = {{0, 1}, {1, -1}, {2, 1}, {3, -1}};
  report.paths = {path};
  return report;
}

}  // namespace gcs::toy
