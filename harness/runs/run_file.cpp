#include "harness/runs/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "harness/base/record_fields.hpp"
#include "harness/base/record_json.hpp"
#include "harness/results/exec_strategy.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

constexpr std::string_view run_format = "gcsbench-run/1";

}  // namespace

CellRecord::CellRecord() = default;
CellRecord::CellRecord(const CellRecord&) = default;
CellRecord::CellRecord(CellRecord&&) noexcept = default;
CellRecord& CellRecord::operator=(const CellRecord&) = default;
CellRecord& CellRecord::operator=(CellRecord&&) noexcept = default;
CellRecord::~CellRecord() = default;

RunFile::RunFile() = default;
RunFile::RunFile(const RunFile&) = default;
RunFile::RunFile(RunFile&&) noexcept = default;
RunFile& RunFile::operator=(const RunFile&) = default;
RunFile& RunFile::operator=(RunFile&&) noexcept = default;
RunFile::~RunFile() = default;

// ---- what the file says of each record

void visit_fields(RecordOf<Environment> auto& environment, const auto& visit) {
  visit_environment(environment, visit);
}
void visit_fields(RecordOf<Counts> auto& counts, const auto& visit) { visit_counts(counts, visit); }
void visit_fields(RecordOf<WorkCounters> auto& work, const auto& visit) { visit_work(work, visit); }

/// An object of the counts, in the order of the strategy.
JsonValue json_of(const std::vector<Particular>& particulars) {
  JsonMembers members;
  for (const Particular& particular : particulars)
    members.emplace_back(particular.name, json_of(particular.value));
  return json_object(std::move(members));
}

void read_json(const JsonCursor& cursor, std::vector<Particular>& particulars) {
  for (const auto& [name, count] : cursor.members())
    read_json(count, particulars.emplace_back(Particular{name, 0}).value);
}

void visit_fields(RecordOf<Timing> auto& repetition, const auto& visit) {
  visit("prepare_s", repetition.prepare_s);
  visit("solve_s", repetition.wall_s);
  visit("cpu_s", repetition.cpu_s);
  visit("refine_s", repetition.refine_s);
}

void visit_fields(RecordOf<Accuracy> auto& accuracy, const auto& visit) {
  visit("met", accuracy.met);
  visit("missed", accuracy.missed);
  visit("spurious", accuracy.spurious);
  visit("largest_error", accuracy.largest_error);
  visit("median_error", accuracy.median_error);
  visit("largest_condition", accuracy.largest_condition);
  visit("largest_quotient", accuracy.largest_quotient);
}

void visit_fields(RecordOf<RecordedProofs> auto& proofs, const auto& visit) {
  visit("classes", proofs.classes);
  visit("real", proofs.real);
  visit("complete", proofs.is_complete);
  visit("real_complete", proofs.decides_real);
}

void visit_fields(RecordOf<RecordedSolution> auto& solution, const auto& visit) {
  visit("real", solution.is_real);
  visit("multiplicity", solution.multiplicity);
  visit("points", solution.points);
}

void visit_fields(RecordOf<CellRecord> auto& cell, const auto& visit) {
  visit("instance", cell.spec.instance);
  visit("strategy", cell.spec.strategy);
  visit("given", cell.spec.given);
  visit.later("digits", cell.spec.digits);
  visit("options", cell.options);
  visit.named("status", cell.status, all_statuses);
  visit("reason", cell.reason);
  visit("difference", cell.difference);
  visit("residual", cell.residual);
  visit.later("warm_up_s", cell.warm_up_s);
  visit.later("limit_s", cell.limit_s);
  visit.later("estimate_s", cell.estimate_s);
  visit("counts", cell.counts);
  visit.later("proofs", cell.proofs);
  visit.later("path_proven", cell.is_path_proven);
  visit.named("claim", cell.claim, all_claims);
  visit.later("accuracy", cell.accuracy);
  visit("work", cell.work);
  visit("particulars", cell.particulars);
  visit("solutions", cell.solutions);
  visit.later("planned", cell.planned);
  visit("repetitions", cell.repetitions);
}

void visit_fields(RecordOf<GivenLength> auto& length, const auto& visit) {
  visit("between", length.between);
  visit("text", length.text);
  visit("squared", length.is_squared);
}

void visit_fields(RecordOf<RecordedLimit> auto& limit, const auto& visit) {
  visit("exact", limit.is_exact);
  visit("all_signs", limit.all_signs);
  visit("reference", limit.bound.reference);
  visit("parts", limit.bound.parts);
  visit.later("ring", limit.bound.ring);
  visit.later("theorem", limit.bound.theorem);
  visit.later("at_infinity", limit.bound.at_infinity);
}

void visit_fields(RecordOf<InstanceSummary> auto& instance, const auto& visit) {
  visit("id", instance.id);
  visit("origin", instance.origin);
  visit("fingerprint", instance.fingerprint);
  visit("equations", instance.equations);
  visit("dimension", instance.dimension);
  visit("lengths", instance.lengths);
  visit.later("given_positions", instance.has_given_positions);
  visit.later("reference", instance.reference);
  visit.later("shipped", instance.is_shipped);
  visit.later("complex_limit", instance.limit);
  visit.later("convention", instance.convention);
}

void visit_fields(RecordOf<RequestedTable> auto& table, const auto& visit) {
  visit("name", table.name);
  visit("instances", table.instances);
}

void visit_fields(RecordOf<RunSession> auto& session, const auto& visit) {
  visit("started", session.started);
  visit("arguments", session.arguments);
  visit("folder", session.folder);
  visit("load_average", session.load_average);
  visit("repetitions", session.repetitions);
  visit("budget_s", session.budget_s);
  visit("cell_limit_s", session.cell_limit_s);
  visit("total_limit_s", session.total_limit_s);
}

void visit_fields(RecordOf<RecordedCurve> auto& curve, const auto& visit) {
  visit("instance", curve.instance);
  visit("given", curve.given);
  visit("theta", curve.theta);
  visit("gap", curve.gap);
}

void visit_fields(RecordOf<RunFile> auto& run, const auto& visit) {
  visit("started", run.started);
  visit.later("sessions", run.sessions);
  visit("seed", run.seed);
  visit("tables", run.tables);
  visit("environment", run.environment);
  visit("instances", run.instances);
  visit("curves", run.curves);
  visit("cells", run.cells);
}

// ---- the records

std::string CellRecord::flaw() const {
  if (!difference.empty() || !contradicts_reference()) return difference;
  return fmt::format("Held against proven solutions: {} missed, {} spurious.", accuracy->missed.value_or(0),
                     accuracy->spurious);
}

std::optional<std::int64_t> CellRecord::particular(std::string_view name) const {
  const auto found = std::find_if(particulars.begin(), particulars.end(),
                                  [&](const Particular& p) { return p.name == name; });
  return found == particulars.end() ? std::nullopt : std::optional(found->value);
}

const CellRecord* RunFile::find(const CellSpec& spec) const {
  const auto found =
      std::find_if(cells.begin(), cells.end(), [&](const CellRecord& c) { return c.spec == spec; });
  return found == cells.end() ? nullptr : &*found;
}

std::string to_json_text(const RunFile& record) {
  JsonMembers members{{"format", json_text(std::string(run_format))}};
  visit_fields(record, RecordWriter(members));
  return to_text(json_object(std::move(members)), 1) + "\n";
}

RunFile parse_run_file(const std::string& text, const std::string& file) {
  const JsonValue document = parse_json(text, file);
  const JsonCursor root(document, file);
  root.require_format(run_format);
  RunFile record;
  read_json(root, record);
  return record;
}

RunFile load_run_file(const std::filesystem::path& run) {
  const std::string file = (std::filesystem::is_directory(run) ? run / "run.json" : run).string();
  return parse_run_file(read_file(file, "give a run.json or the folder that holds it"), file);
}

std::string label_of(const CellSpec& spec) {
  std::string label = short_name(spec.strategy);
  for (const auto& [name, value] : spec.given) label += fmt::format(" {}={}", name, value);
  if (spec.digits > 0) label += fmt::format(", {} digits", spec.digits);
  return label;
}

std::optional<double> on_path(const CellRecord* cell) {
  if (cell == nullptr || !cell->counts.on_path) return std::nullopt;
  return static_cast<double>(*cell->counts.on_path);
}

}  // namespace gcs
