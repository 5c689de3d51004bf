#include "harness/tables/table_tasks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/base/errors.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/results/strategy_choice.hpp"
#include "solvers/reading/nearest_name.hpp"

namespace gcs {

const TableKind& table_named(const std::string& name) {
  const TableKind* kind = find_table(name);
  if (kind == nullptr) throw UsageError(fmt::format("there is no table '{}'", name));
  return *kind;
}

namespace {

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

void add_judges(const TableRequest& request, LoadedInstances& loaded) {
  const bool is_wanted =
      std::any_of(request.tables.begin(), request.tables.end(), [](const std::string& name) {
        const TableKind* kind = find_table(name);
        return kind != nullptr && kind->measures_accuracy;
      });
  for (std::size_t i = 0; is_wanted && i < loaded.instances.size(); ++i)
    loaded.judges.emplace_back(loaded.instances[i], loaded.scenes[i]);
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

}  // namespace

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
  add_judges(request, loaded);
  return loaded;
}

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

std::deque<StrategyEntry> programs_of(const TableRequest& request) {
  std::deque<StrategyEntry> programs;
  for (const std::string& name : request.strategies)
    if (exec_command(name)) programs.push_back(exec_entry(name));
  return programs;
}

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

}  // namespace gcs
