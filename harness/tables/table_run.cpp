#include "harness/tables/table_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <memory>
#include <set>

#include "harness/base/errors.hpp"
#include "harness/base/record_json.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/runs/run_folder.hpp"
#include "harness/runs/shown_scene_files.hpp"
#include "harness/solving/counts_view.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"
#include "solvers/reading/nearest_name.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {

void visit_fields(RecordOf<TableRequest> auto& request, const auto& visit) {
  visit("tables", request.tables);
  visit("instances", request.instances);
  visit("strategies", request.strategies);
  visit("full", request.full);
  visit("cell_limit_s", request.limits.cell_limit_s);
  visit("total_limit_s", request.limits.total_limit_s);
  visit("skips_variants", request.limits.skips_variants);
}

namespace {

/// True when the paper that the instance cites is known to be wrong about it.
bool is_corrected(const PublishedFigure& figure, const Publications& publications) {
  return std::any_of(publications.begin(), publications.end(), [&](const auto& entry) {
    const Publication& paper = entry.second;
    return figure.source.starts_with(paper.source) &&
           std::any_of(paper.figures.begin(), paper.figures.end(), [&](const PrintedFigure& printed) {
             return printed.correction && printed.row == figure.quantity && printed.value == figure.value;
           });
  });
}

/// Published counts on the path that are not known to be wrong. What another file publishes is shown only.
ExpectedCounts expected_counts(const LoadedInstances& loaded, const std::vector<InstanceSummary>& measured,
                               const Publications& publications) {
  ExpectedCounts expected;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!measured[i].is_shipped) continue;
    const Instance& instance = loaded.instances[i];
    for (const PublishedFigure& figure : instance.published) {
      if (figure.quantity != "on path") continue;
      if (!is_corrected(figure, publications))
        expected[instance.id] = static_cast<std::uint64_t>(figure.value);
    }
  }
  return expected;
}

/// FNV-1a over a file's values: equal for equal instances, whatever their layout.
std::string fingerprint(const JsonValue& document) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : to_text(document, -1)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

std::vector<GivenLength> given_lengths(const ProblemStatement& problem) {
  std::vector<GivenLength> lengths;
  for (const DistanceConstraint& c : problem.constraints)
    lengths.push_back({{problem.name(c.between[0]), problem.name(c.between[1])}, c.given.text, c.is_squared});
  return lengths;
}

std::optional<RecordedLimit> complex_limit(const ProblemStatement& problem) {
  const TheoreticalCounts counts = theoretical_counts(problem);
  const SolutionCount* limit = counts.upper_limit();
  if (limit == nullptr) return std::nullopt;
  RecordedLimit recorded{counts.exact.has_value(), limit->all_signs().decimal(), {}};
  if (!recorded.is_exact) recorded.bound = names_of(problem, *counts.bound);
  return recorded;
}

/// The curve as the figure shows it: one sample a degree, as the paper's Fig. 7.
RecordedCurve sampled_curve(const std::string& id, const Scene& scene, const Pyramid& pyramid) {
  constexpr int samples = 360;
  const auto in_file_unit = [&](double length) { return std::ldexp(length, scene.unit_exponent()); };
  RecordedCurve curve{id, in_file_unit(pyramid.side[2]), {}, {}};
  for (const GapSample& sample : sample_gap_curve(pyramid, samples)) {
    curve.theta.push_back(sample.theta);
    curve.gap.push_back(in_file_unit(sample.gap));
  }
  return curve;
}

/// Of the instances of 5p1L that tables with a figure show.
std::vector<RecordedCurve> curves_of(const TableRequest& request, const LoadedInstances& loaded) {
  std::vector<RecordedCurve> curves;
  for (const std::string& name : request.tables) {
    const TableKind& kind = table_named(name);
    if (kind.draw == nullptr) continue;
    for (const std::string& id : ids_for(kind, request, loaded))
      if (const auto pyramid = find_pyramid(loaded.scene(id)))
        curves.push_back(sampled_curve(id, loaded.scene(id), *pyramid));
  }
  return curves;
}

RunSession new_session(const TableRequest& request, const TimingSettings& settings) {
  RunSession session = start_session(request.arguments);
  session.repetitions = settings.repetitions;
  session.budget_s = settings.limits.budget_s;
  session.cell_limit_s = settings.limits.cell_limit_s;
  session.total_limit_s = settings.limits.total_limit_s;
  return session;
}

InstanceSummary summary_of(const Instance& instance, const Scene& scene) {
  const ProblemStatement& problem = instance.problem;
  InstanceSummary record{instance.id,
                         instance.origin,
                         fingerprint(instance.document),
                         static_cast<int>(problem.constraints.size() + problem.relations.size()),
                         problem.dimension,
                         given_lengths(problem),
                         complex_limit(problem),
                         scene.is_anchored()};
  record.is_shipped = is_shipped(instance);
  record.convention = word(convention_of(problem));
  return record;
}

RunFile new_record(const TableRequest& request, const LoadedInstances& loaded,
                   const TimingSettings& settings) {
  RunFile record;
  record.sessions = {new_session(request, settings)};
  record.started = record.sessions.front().started;
  record.environment = capture_environment(settings.threads);
  record.seed = settings.seed;
  for (const std::string& name : request.tables)
    record.tables.push_back({name, ids_for(table_named(name), request, loaded)});
  for (const Instance& instance : loaded.instances)
    record.instances.push_back(summary_of(instance, loaded.scene(instance.id)));
  record.curves = curves_of(request, loaded);
  return record;
}

/// What the earlier sessions of the run left. Returns its cells.
std::vector<CellRecord> go_on_from(RunFile earlier, RunFile& record) {
  record.started = earlier.started;
  record.sessions.insert(record.sessions.begin(), earlier.sessions.begin(), earlier.sessions.end());
  for (InstanceSummary& now : record.instances)
    for (const InstanceSummary& then : earlier.instances)
      if (now.id == then.id) now.reference = then.reference;
  return std::move(earlier.cells);
}

std::vector<CellSpec> specs_of(const std::vector<CellTask>& tasks) {
  std::vector<CellSpec> specs;
  for (const CellTask& task : tasks) specs.push_back(task.spec);
  return specs;
}

/// Those that have been found by now.
void note_references(const LoadedInstances& loaded, RunFile& record) {
  for (std::size_t i = 0; i < loaded.judges.size(); ++i)
    if (const std::string& reference = loaded.judges[i].reference(); !reference.empty())
      record.instances[i].reference = reference;
}

/// What the page shows of the instances beside the measurements.
void store_scenes(const LoadedInstances& loaded, const RunFile& record, const std::filesystem::path& folder,
                  Monitor& progress) {
  for (const Instance& instance : loaded.instances) {
    if (!is_drawn(record, instance.id)) continue;
    const MadeScene made = make_scene(instance, loaded.scene(instance.id), record, progress);
    if (interrupted()) return;  // and left something out
    store_scene(made, folder);
  }
}

// ---- cells that a crew shares

constexpr std::string_view cells_task = "gcsbench-cells/1\n";

class Silence final : public Monitor {
 public:
  void progress(std::string_view, double) override {}
};

/// Assesses cells of one instance after another. The limit for everything is one of what this process solves.
class CellAssessor {
 public:
  CellAssessor(std::vector<CellTask> tasks, const LoadedInstances& loaded, TimingSettings settings)
      : tasks_(std::move(tasks)), loaded_(loaded), settings_(std::move(settings)) {
    for (CellTask& task : tasks_) task.is_timed = false;
  }

  /// `item` is a run with one instance and what is known of its cells; so is what it returns.
  std::string result(const std::string& item) {
    RunFile part = parse_run_file(item, "cells");
    InstanceSummary& instance = part.instances.at(0);
    std::vector<CellTask> own;
    std::ranges::copy_if(tasks_, std::back_inserter(own),
                         [&](const CellTask& task) { return task.spec.instance == instance.id; });
    const std::vector<CellRecord> known = std::move(part.cells);
    Silence silence;
    part.cells = time_cells(own, settings_, known, silence, [](const std::vector<CellRecord>&) {});
    take_from_limit(solved_s(part.cells) - solved_s(known));
    instance.reference = loaded_.judges.at(loaded_.number(instance.id)).reference();
    return to_json_text(part);
  }

  std::optional<double> left_s() const { return settings_.limits.total_limit_s; }

 private:
  static double solved_s(const std::vector<CellRecord>& cells) {
    double sum_s = 0;
    for (const CellRecord& cell : cells) sum_s += cell.warm_up_s;
    return sum_s;
  }

  void take_from_limit(double time_s) {
    if (settings_.limits.total_limit_s) *settings_.limits.total_limit_s -= std::max(0.0, time_s);
  }

  std::vector<CellTask> tasks_;
  const LoadedInstances& loaded_;
  TimingSettings settings_;
};

/// What other processes need of the request to measure what it asks for.
struct SharedRequest {
  explicit SharedRequest(TableRequest asked) : request(std::move(asked)) {}

  TableRequest request;
  std::deque<StrategyEntry> programs = programs_of(request);
  LoadedInstances loaded = load_all(request);
  CellAssessor assessor{tasks_of(request, loaded, programs), loaded, settings_of(request)};
};

/// Standard input is read once, and what is not held against a reference is measured for its time.
bool is_shared(const TableRequest& request) {
  const auto is_judged = [](const std::string& name) { return table_named(name).measures_accuracy; };
  return std::ranges::all_of(request.tables, is_judged) && std::ranges::count(request.instances, "-") == 0;
}

std::string item_of(const InstanceSummary& instance, const std::vector<CellRecord>& known) {
  RunFile part;
  part.instances = {instance};
  std::ranges::copy_if(known, std::back_inserter(part.cells),
                       [&](const CellRecord& cell) { return cell.spec.instance == instance.id; });
  return to_json_text(part);
}

/// Takes over what was found for one instance.
void take_part(RunFile part, RunFile& record, std::vector<CellRecord>& known) {
  const InstanceSummary& instance = part.instances.at(0);
  for (InstanceSummary& own : record.instances)
    if (own.id == instance.id && !instance.reference.empty()) own.reference = instance.reference;
  std::erase_if(known, [&](const CellRecord& cell) { return cell.spec.instance == instance.id; });
  std::ranges::move(part.cells, std::back_inserter(known));
}

/// What is known of all cells when the crew has assessed them. It is stored when each member has done some instances, for
/// a run that is killed.
void assess_with(Crew& crew, const TableRequest& request, CellAssessor& here, RunFile& record,
                 std::vector<CellRecord>& known, Monitor& progress, const CellCheckpoint& store) {
  const std::size_t most = 4 * static_cast<std::size_t>(crew.members());
  const std::string task = std::string(cells_task) + to_text(json_of(request), -1);
  for (std::size_t first = 0; first < record.instances.size() && !interrupted(); first += most) {
    progress.progress("answers", static_cast<double>(first) / static_cast<double>(record.instances.size()));
    std::vector<std::string> items;
    for (std::size_t i = first; i < std::min(first + most, record.instances.size()); ++i)
      items.push_back(item_of(record.instances[i], known));
    OneByOne own([&](const NumberedItem& item) { return here.result(item.bytes); });
    std::vector<std::string> results(items.size());
    crew.each_result(
        task, items.size(), [&](std::size_t i) { return std::move(items[i]); }, own,
        [] { return interrupted(); },
        [&](NumberedItem result) { results[result.number] = std::move(result.bytes); });
    for (const std::string& result : results)
      if (!result.empty()) take_part(parse_run_file(result, "cells"), record, known);
    store(known);
  }
}

void require_known_strategies(const TableRequest& request) {
  for (const std::string& name : request.strategies)
    if (!exec_command(name)) find_strategy(name);
}

/// Throws UsageError where no table shows anything of what was asked for.
void require_tasks(const TableRequest& request, const std::vector<CellTask>& tasks) {
  if (!tasks.empty()) return;
  std::set<std::string> strategies, instances;
  for (const std::string& name : request.tables) {
    const TableKind& kind = table_named(name);
    if (why_unavailable(kind)) return;
    instances.insert(kind.instances().begin(), kind.instances().end());
    for (const Variant& variant : kind.variants()) strategies.insert(variant.strategy);
  }
  const auto listed = [](const std::set<std::string>& names) {
    return quoted_list(std::vector<std::string>(names.begin(), names.end()));
  };
  throw UsageError(fmt::format("nothing to measure: {} shows {} on {}, and nothing that was asked for",
                               quoted_list(request.tables), listed(strategies), listed(instances)));
}

}  // namespace

RunFile run_tables(const TableRequest& request, const Publications& publications, Monitor& progress,
                   Crew* crew) {
  require_known_strategies(request);
  if (request.resume && !request.out)
    throw UsageError("--resume needs --out: the folder of the run to go on with");
  const std::deque<StrategyEntry> programs = programs_of(request);
  LoadedInstances loaded = load_all(request);
  const std::vector<CellTask> tasks = tasks_of(request, loaded, programs);
  require_tasks(request, tasks);
  TimingSettings settings = settings_of(request);
  RunFile record = new_record(request, loaded, settings);
  settings.expected = expected_counts(loaded, record.instances, publications);

  std::optional<RunFolder> folder;
  if (request.out) folder.emplace(*request.out);
  std::optional<RunFile> earlier;
  if (request.resume) earlier = folder->resumed(record, specs_of(tasks));
  std::vector<CellRecord> known;
  if (earlier) known = go_on_from(std::move(*earlier), record);

  const auto store = [&](const std::vector<CellRecord>& cells) {
    record.cells = cells;
    note_references(loaded, record);
    if (folder) folder->store(record);
  };
  if (crew != nullptr && is_shared(request)) {
    CellAssessor here(tasks, loaded, settings);
    assess_with(*crew, request, here, record, known, progress, store);
    settings.limits.total_limit_s = here.left_s();
  }
  store(time_cells(tasks, settings, known, progress, store));
  if (request.out) store_scenes(loaded, record, *request.out, progress);
  return record;
}

std::unique_ptr<ItemWork> begin_cells(const std::string& task) {
  if (!task.starts_with(cells_task)) return nullptr;
  const JsonValue document = parse_json(std::string_view(task).substr(cells_task.size()), "cells");
  TableRequest request;
  const std::string name = "cells";
  read_json(JsonCursor(document, name), request);
  const auto shared = std::make_shared<SharedRequest>(std::move(request));
  return std::make_unique<OneByOne>(
      [shared](const NumberedItem& item) { return shared->assessor.result(item.bytes); });
}

}  // namespace gcs
