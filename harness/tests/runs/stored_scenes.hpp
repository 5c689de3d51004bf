#pragma once
/// Scenes as a run stores them, made in the test.

#include "harness/runs/shown_scene_files.hpp"
#include "harness/tests/test_folder.hpp"

namespace gcs {

class SilentMonitor final : public Monitor {
 public:
  void progress(std::string_view, double) override {}
};

/// A run that has followed S with a plan.
inline RunFile run_with_plans(const std::string& id) {
  RunFile run;
  CellRecord cell;
  cell.spec = {id, "rcp", {{"mode", "paper"}}};
  cell.status = RunStatus::complete;
  cell.work.plan_changes = 1;
  run.cells.push_back(std::move(cell));
  return run;
}

/// What make_scene makes of the instance, stored and read again.
inline StoredScene stored_scene(const Instance& instance) {
  SilentMonitor monitor;
  const TestFolder folder;
  store_scene(make_scene(instance, Scene(instance.problem), run_with_plans(instance.id), monitor),
              folder / "");
  return *load_scene(folder / "", instance.id);
}

}  // namespace gcs
