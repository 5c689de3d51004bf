#include "solvers/reduction/core_path.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "solvers/model/complex_points.hpp"
#include "solvers/reduction/hung_point.hpp"

namespace gcs {
namespace {

/// Hung points and the sides on which they are in the sketch.
class Placer {
 public:
  Placer(const Scene& scene, const std::vector<Part>& parts) : scene_(scene) {
    const Simplex sketch = complex_points(*scene.sketch());
    for (const Part& part : parts) {
      if (!part.is_hung_point()) continue;
      const double height =
          SimplexFrame(columns(sketch, part.base)).coordinates(sketch.col(part.points.front()))[2].real();
      hung_.push_back({&part, height < 0 ? -1.0 : 1.0, std::nullopt});
      if (part.has_given_base()) hung_.back().place = exact_place(scene, part);
    }
  }

  /// Places them all in the figure; or says why one cannot be placed.
  std::optional<std::string> place(Figure& figure) const {
    Simplex positions = figure.points.cast<std::complex<double>>();
    for (const Hung& hung : hung_) {
      const int point = hung.part->points.front();
      const Simplex base = columns(positions, hung.part->base);
      const HungPlace place = hung.place ? *hung.place : measured_place(scene_, *hung.part, base);
      if (!place.undecided.empty())
        return scene_.problem().name(point) + " is not placed: " + place.undecided;
      if (!place.is_real) return scene_.problem().name(point) + " has no real place";
      placer_.place(*hung.part, {place.coordinates}, hung.side, place.is_flat, positions);
    }
    figure.points = positions.real();
    return std::nullopt;
  }

 private:
  struct Hung {
    const Part* part;
    double side;
    std::optional<HungPlace> place;  ///< where it does not depend on the rest
  };

  const Scene& scene_;
  BasePlacer placer_{scene_};
  std::vector<Hung> hung_;
};

/// "at the solutions 0, 3 of the core's path"
std::string at_solutions(const std::vector<int>& numbers) {
  std::string text = numbers.size() == 1 ? "at the solution " : "at the solutions ";
  for (const int number : numbers) text += (number == numbers.front() ? "" : ", ") + std::to_string(number);
  return text + " of the core's path";
}

}  // namespace

SolveReport with_hung_points(const Scene& scene, const std::vector<Part>& parts, SolveReport report) {
  const Placer placer(scene, parts);
  std::vector<Candidate> placed;
  std::vector<int> number(report.candidates.size(), -1);
  std::map<std::string, std::vector<int>> causes;
  for (std::size_t i = 0; i < report.candidates.size(); ++i) {
    Candidate candidate = report.candidates[i];
    if (const auto cause = placer.place(candidate.figure)) {
      causes[*cause].push_back(static_cast<int>(i));
      continue;
    }
    number[i] = static_cast<int>(placed.size());
    placed.push_back(std::move(candidate));
  }
  report.candidates = std::move(placed);
  for (PathRecord& path : report.paths) {
    for (Crossing& crossing : path.crossings) crossing.candidate = number[crossing.candidate];
    std::erase_if(path.crossings, [](const Crossing& crossing) { return crossing.candidate < 0; });
    path.plans.clear();
  }
  for (const auto& [cause, numbers] : causes)
    report.reason += (report.reason.empty() ? "" : "; ") + cause + " " + at_solutions(numbers);
  if (!causes.empty() && report.status == SolveStatus::complete) report.status = SolveStatus::partial;
  report.claim = Claim::on_path_of_core;
  return report;
}

}  // namespace gcs
