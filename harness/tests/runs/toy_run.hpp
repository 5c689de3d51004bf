#pragma once
/// A small run of invented figures: every kind of cell that a table has to show.

#include "harness/runs/run_file.hpp"

namespace gcs::toy {

inline CellRecord cell(CellSpec spec, std::uint64_t on_path, std::int64_t iterations, double median_s) {
  CellRecord record;
  record.options = spec.given;
  record.spec = std::move(spec);
  record.status = RunStatus::complete;
  record.counts.on_path = on_path;
  record.work.iterations = iterations;
  record.work.smallest_step = 0.1 / 3;
  record.residual = 2e-16;
  for (const double factor : {0.98, 1.0, 1.04}) {
    record.repetitions.push_back({.wall_s = median_s * factor * 7 / 8,
                                  .cpu_s = median_s * factor,
                                  .prepare_s = median_s * factor / 8});
  }
  return record;
}

inline CellRecord with_plan(CellRecord record) {
  record.work.plan_changes = 13;
  record.work.mean_driving_parameters = 1.3;
  record.work.max_driving_parameters = 2;
  return record;
}

/// All of `complex` classes, `real` of them real.
inline CellRecord with_all(CellRecord record, std::uint64_t real, std::uint64_t complex) {
  record.counts.on_path.reset();
  record.counts.real_up_to_reflection = real;
  record.counts.complex_up_to_reflection = complex;
  return record;
}

inline CellRecord unsupported(CellSpec spec) {
  CellRecord record;
  record.spec = std::move(spec);
  record.status = RunStatus::unsupported;
  record.reason = "it is made for another problem";
  return record;
}

inline CellRecord wrong(CellRecord record) {
  record.difference = "Found 178 on S instead of 174 (+4).";
  record.repetitions.clear();
  return record;
}

inline CellRecord timed_out(CellSpec spec) {
  CellRecord record;
  record.spec = std::move(spec);
  record.status = RunStatus::timed_out;
  record.estimate_s = 7200;
  record.reason = "the time limit of 20 s has passed";
  record.counts.on_path = 20;
  return record;
}

/// Right answers on the octahedron; on the icosahedron one wrong answer, one that was not ready in time, and
/// cells that were not measured.
inline RunFile run_record() {
  const OptionMap paper{{"mode", "paper"}};
  RunFile record;
  record.started = "2026-01-02T03:04:05Z";
  record.sessions = {
      {record.started, {"gcsbench", "tables", "--full"}, "/tmp", {}, {}, 90, {}, {}},
      {"2026-01-02T04:00:00Z", {"gcsbench"}, "/tmp", {{0.25, 1, 2}}, 3, 90, 60, 1500},
  };
  record.environment = {"Toy CPU", "GNU 12", "-O3", "0123abc", 1};
  const std::vector<std::string> both{"octahedron", "icosahedron"};
  record.tables = {
      {"table1", both}, {"table2", both}, {"table3", both}, {"hoffmann-yuan", {}}, {"ablation", both}};
  record.instances = {{"octahedron",
                       "octahedron.json",
                       "00ff",
                       12,
                       3,
                       {{{"p1", "p2"}, "1.10", false}},
                       RecordedLimit{false, "64", {{"p1", "p2", "p3"}, {}}}},
                      {"icosahedron", "icosahedron.json", "01ff", 30, 3}};
  record.cells = {
      cell({"octahedron", "full-space", {}}, 4, 31, 1.5e-3),
      cell({"octahedron", "full-space", paper}, 4, 160, 4.25e-3),
      with_plan(cell({"octahedron", "rcp", {}}, 4, 33, 2.5e-4)),
      with_plan(cell({"octahedron", "rcp", paper}, 4, 180, 1.25)),
      cell({"octahedron", "full-space", {{"mode", "paper"}, {"step_max", "0.2"}}}, 4, 80, 2.1e-3),
      cell({"icosahedron", "full-space", {}}, 174, 900, 0.25),
      wrong(cell({"icosahedron", "full-space", paper}, 178, 8000, 1.0)),
      timed_out({"icosahedron", "rcp", {}}),
      with_all(cell({"octahedron", "cayley-menger", {}}, 0, 0, 1.5e-4), 4, 8),
      unsupported({"icosahedron", "cayley-menger", {}}),
  };
  return record;
}

}  // namespace gcs::toy
