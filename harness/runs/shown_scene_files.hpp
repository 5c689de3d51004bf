#pragma once
/// Stores, beside a run, what the page shows of its instances, so that `report` need not solve.

#include <filesystem>
#include <optional>

#include "harness/results/path_reader.hpp"
#include "harness/runs/run_file.hpp"
#include "harness/runs/shown_scene.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

/// More entities cannot be told apart in a drawing: of larger scenes nothing but the instance is stored.
inline constexpr std::size_t most_drawn_entities = 60;

bool can_be_drawn(const ProblemStatement& problem);

/// Solutions, the path S and the plans along it; the path as the text of gcsbench-path/1, where there is one.
struct MadeScene {
  ShownScene record;
  std::optional<std::string> path;
};

/// Solutions are the proven ones (reference_for) or, where nothing can be proven, those of the strategy that
/// lists most; the first thousand of them. S is followed with proof for some seconds, and written as finely
/// as a page can hold. Of the run's cells that changed plans, the first few are solved again to tell where, and so are those
/// that found what moves (shown_curves.hpp).
MadeScene make_scene(const Instance& instance, const Scene& scene, const RunFile& run, Monitor& progress);

/// Writes folder/scenes/<id>.json and folder/paths/<id>.json. Throws OutputError.
void store_scene(const MadeScene& made, const std::filesystem::path& folder);

/// Whether a page draws the instance of that id: of a family the first member in the run stands for all.
bool is_drawn(const RunFile& run, const std::string& id);

/// What was stored of an instance. `path` empty: there is none; its crossings are those of the record, and
/// their corners have the coordinates of the solutions.
struct StoredScene {
  ShownScene record;
  std::optional<StoredPath> path;
};

/// Nothing where nothing was stored. Throws InputError for files that do not hold what they should, or that
/// are of another instance.
std::optional<StoredScene> load_scene(const std::filesystem::path& folder, const std::string& id);

}  // namespace gcs
