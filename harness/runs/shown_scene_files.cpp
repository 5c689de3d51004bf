#include "harness/runs/shown_scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/instances/families.hpp"
#include "harness/results/path_io.hpp"
#include "harness/results/reference_list.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/runs/shown_curves.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/answers/certify.hpp"
#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

/// In seconds: for S, for every strategy where solutions must be found, and for every trail.
constexpr double limit_s = 10;

/// So that a page with some long paths still opens at once.
constexpr std::size_t most_path_bytes = 1 << 20;

/// Nobody looks at more.
constexpr std::size_t most_solutions = 1000;

/// Trails of one instance: the cells that are left add nothing that a plot could still show.
constexpr std::size_t most_trails = 3;

// ---- solutions

void take_proven(const ReferenceList& list, const Scene& scene, ShownScene& record) {
  const std::vector<StatedSign> signs = stated_signs(scene.problem());
  bool is_cut = false;
  for (const KnownSolution& known : list.solutions) {
    const double error = std::ldexp(known.exact.error, -scene.unit_exponent());
    if (!known.figure.is_real() || verdict_on(signs, known.figure, error).standing != Standing::as_stated)
      continue;
    is_cut = record.solutions.size() == most_solutions;
    if (is_cut) break;
    record.solutions.push_back({scene.in_file_unit(known.figure), 1});
  }
  record.source = list.source;
  record.are_proven = true;
  record.has_all_real = list.has_all_real && !is_cut;
  record.is_real_proven = list.is_real_proven && !is_cut;
}

bool claims_all_real(const SolveRun& run) {
  return run.status == RunStatus::complete &&
         (run.claim == Claim::all_real || run.claim == Claim::all_complex);
}

/// The real solutions of the first strategy that claims to list all of them, or else of the one that lists most;
/// certified where certificates reach the scene.
void take_listed(const Scene& scene, Monitor& progress, ShownScene& record) {
  RunLimits limits;
  limits.time_limit_s = limit_s;
  limits.max_solutions = most_solutions;
  limits.only_real = true;
  limits.certify = true;
  for (const StrategyEntry& entry : all_strategies()) {
    if (interrupted() || record.has_all_real) return;
    SolveRun run = run_strategy(entry, {}, scene, limits, {&progress, nullptr});
    std::erase_if(run.solutions, [](const AssessedSolution& solution) { return !solution.is_as_stated(); });
    if (run.solutions.size() < record.solutions.size() + (claims_all_real(run) ? 0 : 1)) continue;
    record.solutions.clear();
    for (const AssessedSolution& solution : run.solutions)
      record.solutions.push_back({solution.placement(), solution.multiplicity});
    record.are_proven = run.proofs && run.proofs->real == run.solutions.size();
    record.source = fmt::format("found by {}{}", entry.name, record.are_proven ? "" : ", not proven");
    record.is_real_proven = record.are_proven && run.proofs->decide_real();
    record.has_all_real = claims_all_real(run);
  }
}

void take_solutions(const Instance& instance, const Scene& scene, Monitor& progress, ShownScene& record) {
  std::optional<ReferenceList> list;
  if (!instance.problem.is_general() && !why_not_certified(scene))
    list = reference_for(instance, scene, limit_s, progress);
  if (list && (!list->solutions.empty() || list->is_real_proven))
    take_proven(*list, scene, record);
  else
    take_listed(scene, progress, record);
}

// ---- the path

/// As fine as fits; the coarsest one, whatever its size, where none does.
std::string fitting_path(const Instance& instance, const Scene& scene, const std::vector<ProvenArc>& arcs) {
  std::string text;
  for (const double within : {1e-4, 1e-3, 1e-2, 1e-1}) {
    text = path_text(instance, scene, arcs, within);
    if (text.size() <= most_path_bytes) break;
  }
  return text;
}

// ---- plans

/// Solves again.
std::vector<PlanUse> plans_used(const CellRecord& cell, const Scene& scene) {
  const StrategyEntry& entry = find_strategy(cell.spec.strategy);
  const auto strategy = entry.make(complete_options(entry, cell.spec.given));
  const StopWatch watch(limit_s);
  const SolveRequest request(scene, {.stop = watch.token()});
  const SolveReport report = strategy->solve(request);
  return report.paths.empty() ? std::vector<PlanUse>() : report.paths.front().plans;
}

PlanTrail make_trail(const CellRecord& cell, const Scene& scene, const std::vector<ProvenArc>& arcs) {
  PlanTrail trail{label_of(cell.spec), {}, ""};
  const std::vector<PlanUse> uses = plans_used(cell, scene);
  if (uses.empty()) trail.cause = "it follows the path of a core";
  const DistanceSystem system(scene);
  PathPlaces places(arcs, same_place * scene.size());
  for (const PlanUse& use : uses) {
    Eigen::VectorXd point(system.unknowns() + 1);
    point << system.coordinates(scene.in_frame(use.figure)), use.t;
    const auto length = places.find(point);
    if (!length) {
      trail.places.clear();
      trail.cause = fmt::format("at t = {:.4f} it is not on S: it has jumped to another path", use.t);
      return trail;
    }
    const double before =
        trail.places.empty() ? 0 : std::ldexp(trail.places.back().length, -scene.unit_exponent());
    if (*length < before - same_place * scene.size()) {
      if (&use == &uses.back()) break;  // the last step passes the sketch, where S begins again
      trail.places.clear();
      trail.cause = fmt::format("at t = {:.4f} it is on an earlier part of S: it has jumped", use.t);
      return trail;
    }
    PlanPlace place{use.t, std::ldexp(*length, scene.unit_exponent()), {}};
    for (const int constraint : use.removed)
      place.removed.push_back(scene.problem().constraints[static_cast<std::size_t>(constraint)].id);
    trail.places.push_back(std::move(place));
  }
  return trail;
}

bool changed_plans(const CellRecord& cell, const std::string& id) {
  return cell.spec.instance == id && cell.spec.digits == 0 && cell.work.plan_changes > 0 &&
         cell.status == RunStatus::complete;
}

void take_trails(const RunFile& run, const Scene& scene, const std::vector<ProvenArc>& arcs,
                 ShownScene& record) {
  for (const CellRecord& cell : run.cells) {
    if (record.trails.size() == most_trails || interrupted()) return;
    if (changed_plans(cell, record.instance.id)) record.trails.push_back(make_trail(cell, scene, arcs));
  }
}

/// S and all that is known of places on it; or why it is not there.
std::optional<std::string> take_path(const Scene& scene, const RunFile& run, ShownScene& record) {
  if (const auto reason = why_no_path_text(scene)) {
    record.no_path = *reason;
    return std::nullopt;
  }
  const StopWatch watch(limit_s);
  CertifiedTracker tracker(scene, {}, {watch.token(), nullptr});
  tracker.keep_arcs();
  const TrackedPath path = tracker.run();
  if (!path.proven) {
    const bool is_late = watch.cause() == StopWatch::Cause::time_limit;
    record.no_path = is_late ? fmt::format("following S takes more than {} s", limit_s) : path.cause;
    return std::nullopt;
  }
  for (const PathCrossing& crossing : path.crossings)
    record.crossings.push_back(
        nearest_solution(scene, scene.in_file_unit(tracker.figure(crossing.point)), record.solutions));
  take_trails(run, scene, tracker.arcs(), record);
  return fitting_path(record.instance, scene, tracker.arcs());
}

std::filesystem::path scene_file(const std::filesystem::path& folder, const std::string& id) {
  return folder / "scenes" / (id + ".json");
}

std::filesystem::path path_file(const std::filesystem::path& folder, const std::string& id) {
  return folder / "paths" / (id + ".json");
}

/// Polylines are rounded, solutions are not.
void put_solutions_on_path(StoredScene& scene) {
  for (std::size_t i = 0; i < scene.path->crossings.size(); ++i) {
    const auto& met = scene.record.crossings[i];
    if (!met) continue;
    Figure& figure = scene.path->corners[scene.path->crossings[i].corner].figure;
    figure.points = scene.record.solutions[static_cast<std::size_t>(met->solution)].figure.points;
    for (int axis = 0; axis < 3; ++axis)
      figure.points.row(axis) *= met->signs[static_cast<std::size_t>(axis)];
  }
}

}  // namespace

bool can_be_drawn(const ProblemStatement& problem) {
  return static_cast<std::size_t>(problem.entity_count()) <= most_drawn_entities;
}

MadeScene make_scene(const Instance& instance, const Scene& scene, const RunFile& run, Monitor& progress) {
  progress.progress("scene of " + instance.id, -1);
  MadeScene made;
  made.record.instance = instance;
  if (!can_be_drawn(instance.problem)) {
    made.record.no_path = fmt::format("there are more than {} entities", most_drawn_entities);
    return made;
  }
  take_solutions(instance, scene, progress, made.record);
  made.path = take_path(scene, run, made.record);
  made.record.curves = curves_to_show(scene, run, made.record, limit_s, progress);
  return made;
}

void store_scene(const MadeScene& made, const std::filesystem::path& folder) {
  const std::string& id = made.record.instance.id;
  for (const char* part : {"scenes", "paths"}) {
    make_folder(folder / part);
    remove_leftovers(folder / part);
  }
  // A path beside another scene than its own would be read as damaged.
  std::error_code ignored;
  std::filesystem::remove(path_file(folder, id), ignored);
  AtomicFile(scene_file(folder, id)).commit(to_json_text(made.record));
  if (made.path) AtomicFile(path_file(folder, id)).commit(*made.path);
}

bool is_drawn(const RunFile& run, const std::string& id) {
  const std::string family = id.substr(0, id.find('@'));
  if (family == id || find_family(family) == nullptr) return true;
  const auto first =
      std::find_if(run.instances.begin(), run.instances.end(),
                   [&](const InstanceSummary& instance) { return instance.id.starts_with(family + "@"); });
  return first != run.instances.end() && first->id == id;
}

std::optional<StoredScene> load_scene(const std::filesystem::path& folder, const std::string& id) {
  const std::string file = scene_file(folder, id).string(), path = path_file(folder, id).string();
  if (!std::filesystem::exists(file)) return std::nullopt;
  StoredScene scene{parse_shown_scene(read_file(file, "measure again"), file), std::nullopt};
  if (scene.record.instance.id != id)
    throw InputError(file, "/instance/id", "the scene is of '" + scene.record.instance.id + "'",
                     "measure '" + id + "' again");
  if (!std::filesystem::exists(path)) return scene;
  scene.path = parse_path(read_file(path, "measure again"), path, scene.record.instance);
  if (scene.path->crossings.size() != scene.record.crossings.size())
    throw InputError(path, "/crossings", "the path has other crossings than the scene beside it",
                     "measure again");
  put_solutions_on_path(scene);
  return scene;
}

}  // namespace gcs
