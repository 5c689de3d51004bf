#include "harness/tables/pyramid_solutions.hpp"

namespace gcs {
namespace {

RecordedSolution mirrored(RecordedSolution solution, double x_sign, double y_sign) {
  for (auto& [name, point] : solution.points) {
    point[0] *= x_sign;
    point[1] *= y_sign;
  }
  return solution;
}

}  // namespace

const CellRecord* richest_cell(const RunFile& run, const std::string& instance) {
  const CellRecord* richest = nullptr;
  for (const CellRecord& cell : run.cells) {
    if (cell.spec.instance != instance || !cell.is_right()) continue;
    if (richest == nullptr || cell.solutions.size() > richest->solutions.size()) richest = &cell;
  }
  return richest;
}

std::vector<RecordedSolution> fixed_frame_solutions(const CellRecord* cell) {
  std::vector<RecordedSolution> all;
  if (cell == nullptr) return all;
  for (const RecordedSolution& solution : cell->solutions)
    for (const double x_sign : {1.0, -1.0})
      for (const double y_sign : {1.0, -1.0})
        if (solution.is_real) all.push_back(mirrored(solution, x_sign, y_sign));
  return all;
}

}  // namespace gcs
