#include "harness/table_run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <deque>
#include <tuple>

#include "harness/atomic_file.hpp"
#include "harness/commands.hpp"
#include "harness/instance_io.hpp"
#include "harness/strategy_choice.hpp"
#include "harness/table_output.hpp"
#include "harness/tables.hpp"

namespace gcs {
namespace {

/// Instances made ready. A deque, because tasks point to the scenes.
struct LoadedInstances {
  std::vector<Instance> instances;
  std::deque<Scene> scenes;
};

LoadedInstances load_all(const std::vector<std::string>& arguments) {
  LoadedInstances loaded;
  for (const std::string& argument : arguments) {
    Instance instance = load_instance(argument);
    const bool again = std::any_of(loaded.instances.begin(), loaded.instances.end(),
                                   [&](const Instance& other) { return other.id == instance.id; });
    if (again) throw UsageError(fmt::format("instance '{}' is given twice", instance.id));
    loaded.scenes.emplace_back(instance.problem);
    loaded.instances.push_back(std::move(instance));
  }
  return loaded;
}

/// Without duplicates, in the order of the tables.
std::vector<Variant> variants_of(const TableRequest& request) {
  std::vector<Variant> all;
  for (const std::string& name : request.tables) {
    const TableKind* kind = find_table(name);
    if (kind == nullptr) throw UsageError(fmt::format("there is no table '{}'", name));
    if (!kind->unavailable.empty()) continue;
    for (Variant& variant : kind->variants()) {
      const auto& wanted = request.strategies;
      const bool selected =
          wanted.empty() || std::find(wanted.begin(), wanted.end(), variant.strategy) != wanted.end();
      const bool known = std::find(all.begin(), all.end(), variant) != all.end();
      if (selected && !known) all.push_back(std::move(variant));
    }
  }
  return all;
}

std::vector<MeasureTask> tasks_of(const TableRequest& request, const LoadedInstances& loaded) {
  std::vector<MeasureTask> tasks;
  for (const Variant& variant : variants_of(request)) {
    const StrategyEntry& entry = find_strategy(variant.strategy);
    for (std::size_t i = 0; i < loaded.instances.size(); ++i) {
      tasks.push_back({variant.on(loaded.instances[i].id), &entry, &loaded.scenes[i]});
    }
  }
  return tasks;
}

/// Published counts on the path that are not known to be wrong.
ExpectedCounts expected_counts(const LoadedInstances& loaded, const Publication& paper) {
  ExpectedCounts expected;
  for (const Instance& instance : loaded.instances) {
    for (const PublishedFigure& figure : instance.published) {
      if (figure.quantity != "on path") continue;
      const bool corrected =
          std::any_of(paper.figures.begin(), paper.figures.end(), [&](const PrintedFigure& printed) {
            return printed.correction && printed.row == figure.quantity &&
                   figure.source.starts_with(paper.source) && printed.value == figure.value;
          });
      if (!corrected) expected[instance.id] = static_cast<std::uint64_t>(figure.value);
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

RunRecord new_record(const TableRequest& request, const LoadedInstances& loaded,
                     const MeasureSettings& settings) {
  RunRecord record;
  record.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  record.environment = capture_environment(settings.threads);
  record.seed = settings.seed;
  record.tables = request.tables;
  for (const Instance& instance : loaded.instances) {
    record.instances.push_back({instance.id, instance.origin, fingerprint(instance),
                                static_cast<int>(instance.problem.constraints.size()),
                                instance.problem.dimension});
  }
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
  if (request.full) {
    settings.cell_limit_s.reset();
    settings.total_limit_s.reset();
  }
  return settings;
}

void require_known_strategies(const TableRequest& request) {
  for (const std::string& name : request.strategies) find_strategy(name);
}

}  // namespace

RunRecord run_tables(const TableRequest& request, const Publication& paper, Monitor& progress) {
  require_known_strategies(request);
  const LoadedInstances loaded = load_all(request.instances.empty() ? paper_instances() : request.instances);
  const std::vector<MeasureTask> tasks = tasks_of(request, loaded);
  MeasureSettings settings = settings_of(request);
  settings.expected = expected_counts(loaded, paper);
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
