/// The program behind scripts/sweep-step-bound: checks on many random scenes that the solutions on S do not
/// depend on the bound of the steps. Exit code 1 when a scene disagrees or gives up.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/instances/problem_text.hpp"
#include "harness/sweeps/step_bound_report.hpp"
#include "harness/sweeps/sweep_main.hpp"
#include "solvers/model/scene.hpp"

namespace {

using namespace gcs;

struct SweepOptions {
  std::uint64_t scenes = 200;
  std::uint64_t first_seed = 1;
  std::string out;
  std::string failures;
  double time_limit_s = 600;
  std::vector<std::string> also;
};

void add_options(CLI::App& app, SweepOptions& options) {
  app.add_option("--scenes", options.scenes, "How many random scenes")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  app.add_option("--first-seed", options.first_seed, "Seed of the first scene")->capture_default_str();
  app.add_option("--out", options.out, "Markdown file for the results")->required();
  app.add_option("--failures", options.failures,
                 "Folder for the scenes that disagree or give up, as instances random-SEED.json");
  app.add_option("--time-limit", options.time_limit_s, "Seconds for one run")->capture_default_str();
  app.add_option("--also", options.also,
                 "Options NAME=VALUE of one more run, such as tolerance=1e-12 step_max=0.015625");
}

/// Throws std::invalid_argument for what is not NAME=VALUE.
StepBound further_bound(const std::vector<std::string>& given) {
  StepBound bound;
  for (const std::string& text : given) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw std::invalid_argument("--also " + text + ": expected NAME=VALUE");
    bound.options[text.substr(0, equals)] = text.substr(equals + 1);
    bound.name += (bound.name.empty() ? "" : ", ") + text;
  }
  return bound;
}

SweptScene sweep_scene(std::span<const StepBound> bounds, const SweepOptions& options, std::uint64_t seed) {
  const SceneKind kind = random_scene_kind(seed);
  return {seed, kind, check_step_bounds(Scene(random_problem(kind, seed)), bounds, options.time_limit_s)};
}

/// A scene that fails is shown and kept as an instance.
void report_scene(const SweepOptions& options, const SweptScene& scene) {
  if (scene.verdict.agrees()) return;
  std::cerr << "seed " << scene.seed << ":\n" << scene.verdict.explanation() << '\n';
  if (options.failures.empty()) return;
  std::filesystem::create_directories(options.failures);
  const std::string id = fmt::format("random-{}", scene.seed);
  AtomicFile(std::filesystem::path(options.failures) / (id + ".json"))
      .commit(problem_text(Scene(random_problem(scene.kind, scene.seed)), id));
}

/// Scenes one after the other; an interrupt ends the series before the scene that it met.
std::vector<SweptScene> sweep_scenes(const SweepOptions& options, std::span<const StepBound> bounds) {
  std::vector<SweptScene> scenes;
  for (std::uint64_t i = 0; i < options.scenes; ++i) {
    SweptScene scene = sweep_scene(bounds, options, options.first_seed + i);
    if (interrupted()) break;
    report_scene(options, scene);
    scenes.push_back(std::move(scene));
    if (scenes.size() % 200 == 0) std::cerr << scenes.size() << " of " << options.scenes << " scenes\n";
  }
  return scenes;
}

int sweep(const SweepOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  AtomicFile out(options.out);
  SweepHeader header{default_step_bounds(), options.first_seed, 0};
  if (!options.also.empty()) header.bounds.push_back(further_bound(options.also));
  const std::vector<SweptScene> scenes = sweep_scenes(options, header.bounds);
  header.total_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!scenes.empty()) out.commit(step_bound_report(header, scenes));
  const auto agrees = [](const SweptScene& scene) { return scene.verdict.agrees(); };
  const auto agreeing = std::count_if(scenes.begin(), scenes.end(), agrees);
  std::cout << agreeing << " of " << scenes.size() << " scenes agree; " << options.out << '\n';
  return agreeing == static_cast<std::ptrdiff_t>(options.scenes) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return gcs::sweep_main(
      argc, argv, "step_bound_sweep",
      "Checks on random scenes that the solutions on S do not depend on the bound of the steps.", add_options,
      sweep);
}
