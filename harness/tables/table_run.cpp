#include "harness/tables/table_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

#include "harness/base/errors.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/results/instance_judge.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/runs/run_folder.hpp"
#include "harness/runs/shown_scene_files.hpp"
#include "harness/solving/counts_view.hpp"
#include "harness/tables/tables.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"
#include "solvers/reading/nearest_name.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {
namespace {

/// Instances made ready. Deques, because tasks point to the scenes and judges point to both.
struct LoadedInstances {
  std::deque<Instance> instances;
  std::deque<Scene> scenes;
  std::deque<InstanceJudge> judges;  ///< empty: accuracy is not asked for

  /// Precondition: an instance of that id is loaded.
  std::size_t number(const std::string& id) const {
    const auto found = std::find_if(instances.begin(), instances.end(),
                                    [&](const Instance& instance) { return instance.id == id; });
    return static_cast<std::size_t>(found - instances.begin());
  }
  const Scene& scene(const std::string& id) const { return scenes[number(id)]; }
};

const TableKind& table_named(const std::string& name) {
  const TableKind* kind = find_table(name);
  if (kind == nullptr) throw UsageError(fmt::format("there is no table '{}'", name));
  return *kind;
}

/// The arguments for load_instance: what was asked for, or what the tables show, each once.
std::vector<std::string> instances_to_load(const TableRequest& request) {
  if (!request.instances.empty()) return request.instances;
  std::vector<std::string> ids;
  for (const std::string& name : request.tables)
    for (const std::string& id : table_named(name).instances())
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  return ids;
}

void require_known(const TableRequest& request, const Instance& instance) {
  const auto knows = [](const std::string& name) { return table_named(name).knows_general; };
  if (instance.problem.is_general() && std::ranges::none_of(request.tables, knows))
    throw UsageError(fmt::format(
        "'{}' has elements or constraints that {} does not know, but for points, lines in space and "
        "distances alone; `gcsbench solve` and `gcsbench tables general` know it",
        instance.id, quoted_list(request.tables)));
}

LoadedInstances load_all(const TableRequest& request) {
  LoadedInstances loaded{};
  for (const std::string& argument : instances_to_load(request)) {
    Instance instance = table_named(request.tables.front()).load(argument);
    require_known(request, instance);
    const bool again = std::any_of(loaded.instances.begin(), loaded.instances.end(),
                                   [&](const Instance& other) { return other.id == instance.id; });
    if (again) throw UsageError(fmt::format("instance '{}' is given twice", instance.id));
    loaded.scenes.emplace_back(instance.problem);
    loaded.instances.push_back(std::move(instance));
  }
  return loaded;
}

void add_judges(const TableRequest& request, LoadedInstances& loaded) {
  const bool is_wanted =
      std::any_of(request.tables.begin(), request.tables.end(), [](const std::string& name) {
        const TableKind* kind = find_table(name);
        return kind != nullptr && kind->measures_accuracy;
      });
  for (std::size_t i = 0; is_wanted && i < loaded.instances.size(); ++i)
    loaded.judges.emplace_back(loaded.instances[i], loaded.scenes[i]);
}

/// What a table shows: its own instances, or those that were asked for.
std::vector<std::string> ids_for(const TableKind& kind, const TableRequest& request,
                                 const LoadedInstances& loaded) {
  if (request.instances.empty()) return kind.instances();
  std::vector<std::string> ids;
  for (const Instance& instance : loaded.instances) {
    if (instance.problem.is_general() && !kind.knows_general) continue;
    const auto& own = kind.instances();
    if (kind.has_free_columns || std::find(own.begin(), own.end(), instance.id) != own.end())
      ids.push_back(instance.id);
  }
  return ids;
}

bool is_selected(const TableRequest& request, const Variant& variant) {
  const auto& wanted = request.strategies;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), variant.strategy) != wanted.end();
}

/// Adds the cell, unless another table has it already.
void add_task(std::vector<CellTask>& tasks, CellTask task) {
  const auto known = std::find_if(tasks.begin(), tasks.end(),
                                  [&](const CellTask& other) { return other.spec == task.spec; });
  if (known == tasks.end()) {
    tasks.push_back(std::move(task));
    return;
  }
  known->keeps_solutions = known->keeps_solutions || task.keeps_solutions;
  known->is_timed = known->is_timed || task.is_timed;
}

/// The external programs that were asked for, which no table names. Their entries refer to the request.
std::deque<StrategyEntry> programs_of(const TableRequest& request) {
  std::deque<StrategyEntry> programs;
  for (const std::string& name : request.strategies)
    if (exec_command(name)) programs.push_back(exec_entry(name));
  return programs;
}

struct Column {
  Variant variant;
  const StrategyEntry* entry;
};

/// What of a table is asked for, external programs last.
std::vector<Column> columns_in(const TableKind& kind, const TableRequest& request,
                               const std::deque<StrategyEntry>& programs) {
  std::vector<Column> columns;
  for (const Variant& variant : kind.variants())
    if (is_selected(request, variant)) columns.push_back({variant, &find_strategy(variant.strategy)});
  for (const StrategyEntry& program : programs)
    columns.push_back({{std::string(program.name), {}}, &program});
  return columns;
}

/// In the order of the tables; those that this version cannot measure are left out. What is measured on one
/// instance stands together, so that a run that is stopped has needed few references.
std::vector<CellTask> tasks_of(const TableRequest& request, LoadedInstances& loaded,
                               const std::deque<StrategyEntry>& programs) {
  std::vector<CellTask> tasks;
  for (const std::string& name : request.tables) {
    const TableKind& kind = table_named(name);
    if (why_unavailable(kind)) continue;
    const std::vector<Column> columns = columns_in(kind, request, programs);
    for (const std::string& id : ids_for(kind, request, loaded))
      for (const auto& [variant, entry] : columns) {
        if (!variant.is_for(id)) continue;
        CellTask task{variant.on(id), entry, &loaded.scene(id), kind.shows_solutions, kind.shows_times};
        if (kind.measures_accuracy)
          task.judge = [judge = &loaded.judges[loaded.number(id)]](Monitor& monitor) {
            return judge->judge(monitor);
          };
        add_task(tasks, std::move(task));
      }
  }
  return tasks;
}

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

TimingSettings settings_of(const TableRequest& request) {
  TimingSettings settings;
  settings.repetitions = request.repetitions;
  settings.limits = request.limits;
  if (request.full) {
    settings.limits.cell_limit_s.reset();
    settings.limits.total_limit_s.reset();
    settings.limits.skips_variants = false;
  }
  return settings;
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

RunFile run_tables(const TableRequest& request, const Publications& publications, Monitor& progress) {
  require_known_strategies(request);
  if (request.resume && !request.out)
    throw UsageError("--resume needs --out: the folder of the run to go on with");
  const std::deque<StrategyEntry> programs = programs_of(request);
  LoadedInstances loaded = load_all(request);
  add_judges(request, loaded);
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
  store(time_cells(tasks, settings, known, progress, store));
  if (request.out) store_scenes(loaded, record, *request.out, progress);
  return record;
}

}  // namespace gcs
