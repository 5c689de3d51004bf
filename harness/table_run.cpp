#include "harness/table_run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <deque>
#include <tuple>

#include "harness/accuracy.hpp"
#include "harness/atomic_file.hpp"
#include "harness/commands.hpp"
#include "harness/counts_view.hpp"
#include "harness/instance_io.hpp"
#include "harness/strategy_choice.hpp"
#include "harness/table_output.hpp"
#include "harness/tables.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"

namespace gcs {
namespace {

/// Instances made ready. Deques, because tasks point to the scenes and judges.
struct LoadedInstances {
  std::vector<Instance> instances;
  std::deque<Scene> scenes;
  std::deque<std::optional<AccuracyJudge>> judges{};  ///< empty: not asked for; nothing: no reference
  std::vector<std::string> references{};              ///< of each instance, in words

  /// Precondition: an instance of that id is loaded.
  std::size_t number(const std::string& id) const {
    const auto found = std::find_if(instances.begin(), instances.end(),
                                    [&](const Instance& instance) { return instance.id == id; });
    return static_cast<std::size_t>(found - instances.begin());
  }
  const Scene& scene(const std::string& id) const { return scenes[number(id)]; }
  const AccuracyJudge* judge(const std::string& id) const {
    if (judges.empty() || !judges[number(id)]) return nullptr;
    return &*judges[number(id)];
  }
};

LoadedInstances load_all(const std::vector<std::string>& arguments, Instance (*load)(const std::string&)) {
  LoadedInstances loaded;
  for (const std::string& argument : arguments) {
    Instance instance = load(argument);
    const bool again = std::any_of(loaded.instances.begin(), loaded.instances.end(),
                                   [&](const Instance& other) { return other.id == instance.id; });
    if (again) throw UsageError(fmt::format("instance '{}' is given twice", instance.id));
    loaded.scenes.emplace_back(instance.problem);
    loaded.instances.push_back(std::move(instance));
  }
  return loaded;
}

/// In seconds: for every strategy where a reference must be made, and for S.
constexpr double reference_limit_s = 20;

void add_judge(const Instance& instance, const Scene& scene, Monitor& progress, LoadedInstances& loaded) {
  loaded.judges.emplace_back();
  loaded.references.emplace_back();
  std::string& words = loaded.references.back();
  if (const auto reason = why_not_certified(scene)) {
    words = "none: " + *reason;
    return;
  }
  progress.progress("reference of " + instance.id, -1);
  ReferenceList list = reference_for(instance, scene, reference_limit_s, progress);
  if (list.solutions.empty()) {
    words = "none: no solution is proven";
    return;
  }
  words = fmt::format("{}, {} solutions", list.source, list.solutions.size());
  loaded.judges.back().emplace(scene, std::move(list));
}

void add_judges(const TableRequest& request, Monitor& progress, LoadedInstances& loaded) {
  const bool is_wanted =
      std::any_of(request.tables.begin(), request.tables.end(), [](const std::string& name) {
        const TableKind* kind = find_table(name);
        return kind != nullptr && kind->measures_accuracy;
      });
  for (std::size_t i = 0; is_wanted && i < loaded.instances.size(); ++i)
    add_judge(loaded.instances[i], loaded.scenes[i], progress, loaded);
}

const TableKind& table_named(const std::string& name) {
  const TableKind* kind = find_table(name);
  if (kind == nullptr) throw UsageError(fmt::format("there is no table '{}'", name));
  return *kind;
}

/// What a table shows: its own instances, or those that were asked for.
std::vector<std::string> ids_for(const TableKind& kind, const TableRequest& request,
                                 const LoadedInstances& loaded) {
  if (request.instances.empty()) return kind.instances();
  std::vector<std::string> ids;
  for (const Instance& instance : loaded.instances) {
    const auto& own = kind.instances();
    if (kind.has_free_columns || std::find(own.begin(), own.end(), instance.id) != own.end())
      ids.push_back(instance.id);
  }
  return ids;
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

bool is_selected(const TableRequest& request, const Variant& variant) {
  const auto& wanted = request.strategies;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), variant.strategy) != wanted.end();
}

/// Adds the cell, unless another table has it already.
void add_task(std::vector<MeasureTask>& tasks, MeasureTask task) {
  const auto known = std::find_if(tasks.begin(), tasks.end(),
                                  [&](const MeasureTask& other) { return other.spec == task.spec; });
  if (known == tasks.end())
    tasks.push_back(std::move(task));
  else
    known->keeps_solutions = known->keeps_solutions || task.keeps_solutions;
}

/// In the order of the tables; those that this version cannot measure are left out.
std::vector<MeasureTask> tasks_of(const TableRequest& request, const LoadedInstances& loaded) {
  std::vector<MeasureTask> tasks;
  for (const std::string& name : request.tables) {
    const TableKind& kind = table_named(name);
    if (why_unavailable(kind)) continue;
    const std::vector<std::string> ids = ids_for(kind, request, loaded);
    for (const Variant& variant : kind.variants()) {
      if (!is_selected(request, variant)) continue;
      const StrategyEntry& entry = find_strategy(variant.strategy);
      for (const std::string& id : ids)
        if (variant.is_for(id))
          add_task(tasks, {variant.on(id), &entry, &loaded.scene(id), kind.shows_solutions,
                           kind.measures_accuracy ? loaded.judge(id) : nullptr});
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

/// Published counts on the path that are not known to be wrong.
ExpectedCounts expected_counts(const LoadedInstances& loaded, const Publications& publications) {
  ExpectedCounts expected;
  for (const Instance& instance : loaded.instances) {
    for (const PublishedFigure& figure : instance.published) {
      if (figure.quantity != "on path") continue;
      if (!is_corrected(figure, publications))
        expected[instance.id] = static_cast<std::uint64_t>(figure.value);
    }
  }
  return expected;
}

/// FNV-1a over the file's values: equal for equal instances, whatever their layout.
std::string fingerprint(const Instance& instance) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : to_text(instance.document, -1)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

std::vector<GivenLength> given_lengths(const Problem& problem) {
  std::vector<GivenLength> lengths;
  for (const DistanceConstraint& c : problem.constraints)
    lengths.push_back({{problem.name(c.between[0]), problem.name(c.between[1])}, c.given.text, c.is_squared});
  return lengths;
}

std::optional<RecordedLimit> complex_limit(const Problem& problem) {
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

RunRecord new_record(const TableRequest& request, const LoadedInstances& loaded,
                     const MeasureSettings& settings) {
  RunRecord record;
  record.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  record.environment = capture_environment(settings.threads);
  record.seed = settings.seed;
  for (const std::string& name : request.tables)
    record.tables.push_back({name, ids_for(table_named(name), request, loaded)});
  for (const Instance& instance : loaded.instances) {
    record.instances.push_back(
        {instance.id, instance.origin, fingerprint(instance),
         static_cast<int>(instance.problem.constraints.size()), instance.problem.dimension,
         given_lengths(instance.problem), complex_limit(instance.problem),
         loaded.scene(instance.id).is_anchored(),
         loaded.references.empty() ? "" : loaded.references[loaded.number(instance.id)]});
  }
  record.curves = curves_of(request, loaded);
  return record;
}

/// Times of two builds or machines, or answers to two problems, must not meet in one run.
void require_same_origin(const RunRecord& earlier, const RunRecord& now, const std::string& file) {
  const auto origin = [](const Environment& e) {
    return std::tie(e.cpu, e.compiler, e.flags, e.commit, e.threads);
  };
  const std::string remedy = "choose another --out, or leave --resume out to start again";
  if (origin(earlier.environment) != origin(now.environment)) {
    throw InputError(file, "/environment", "the run was made by another build or on another machine", remedy);
  }
  for (const MeasuredInstance& instance : earlier.instances) {
    const bool changed =
        std::any_of(now.instances.begin(), now.instances.end(), [&](const MeasuredInstance& other) {
          return other.id == instance.id && other.fingerprint != instance.fingerprint;
        });
    if (changed)
      throw InputError(file, "/instances", "instance '" + instance.id + "' has changed since", remedy);
  }
}

/// The cells of the run that is resumed; none when there is no such run yet.
std::vector<CellRecord> earlier_cells(const TableRequest& request, const RunRecord& record) {
  if (!request.resume) return {};
  if (!request.out) throw UsageError("--resume needs --out: the folder of the run to go on with");
  const std::filesystem::path file = *request.out / "run.json";
  if (!std::filesystem::exists(file)) return {};
  RunRecord earlier = load_run_record(file);
  require_same_origin(earlier, record, file.string());
  return std::move(earlier.cells);
}

MeasureSettings settings_of(const TableRequest& request) {
  MeasureSettings settings;
  settings.repetitions = request.repetitions;
  settings.limits = request.limits;
  if (request.full) {
    settings.limits.cell_limit_s.reset();
    settings.limits.total_limit_s.reset();
    settings.limits.skips_variants = false;
  }
  return settings;
}

void require_known_strategies(const TableRequest& request) {
  for (const std::string& name : request.strategies) find_strategy(name);
}

}  // namespace

RunRecord run_tables(const TableRequest& request, const Publications& publications, Monitor& progress) {
  require_known_strategies(request);
  LoadedInstances loaded = load_all(instances_to_load(request), table_named(request.tables.front()).load);
  add_judges(request, progress, loaded);
  const std::vector<MeasureTask> tasks = tasks_of(request, loaded);
  MeasureSettings settings = settings_of(request);
  settings.expected = expected_counts(loaded, publications);
  RunRecord record = new_record(request, loaded, settings);
  const std::vector<CellRecord> known = earlier_cells(request, record);

  const auto store = [&](const std::vector<CellRecord>& cells) {
    record.cells = cells;
    if (request.out) AtomicFile(*request.out / "run.json").commit(to_json_text(record));
  };
  if (request.out) make_folder(*request.out);
  store(measure(tasks, settings, known, progress, store));
  return record;
}

}  // namespace gcs
