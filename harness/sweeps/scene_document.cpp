#include "harness/sweeps/scene_document.hpp"

#include <nlohmann/json.hpp>

namespace gcs {

using Json = nlohmann::ordered_json;

std::string instance_text(const ProblemStatement& problem, const std::string& id) {
  Json document{{"format", "gcsbench-instance/1"}, {"id", id}, {"dimension", problem.dimension}};
  document["points"] = problem.points;
  for (const DistanceConstraint& c : problem.constraints)
    document["constraints"].push_back({{"id", c.id},
                                       {"type", "distance"},
                                       {"between", {problem.name(c.between[0]), problem.name(c.between[1])}},
                                       {c.is_squared ? "squared" : "length", c.given.value}});
  for (std::size_t p = 0; p < problem.points.size(); ++p)
    for (int axis = 0; axis < problem.dimension; ++axis)
      document["sketch"][problem.points[p]].push_back(
          problem.sketch->points(axis, static_cast<Eigen::Index>(p)));
  const InterpolationChoice& choice = problem.interpolation;
  const DistanceConstraint& bent =
      choice.bent < 0 ? problem.constraints.back() : problem.constraints[choice.bent];
  document["interpolation"] = {{"bent", bent.id}, {"bend", choice.bend}};
  return document.dump(1) + "\n";
}

}  // namespace gcs
