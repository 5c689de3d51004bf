/// The program behind scripts/sweep-explore: what explore reaches of all real solutions of many random scenes, and how many
/// it finds in time where nothing can count them. Exit code 1 when explore finds a solution that monodromy does not.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/drawings/svg_plot.hpp"
#include "harness/sweeps/explore_check.hpp"
#include "harness/sweeps/random_scenes.hpp"
#include "harness/sweeps/sweep_main.hpp"
#include "solvers/structure/decomposition.hpp"

namespace {

using namespace gcs;

constexpr std::array dimensions{2, 3};
constexpr std::array counted_points{6, 7, 8, 9};
constexpr std::array large_points{20, 40, 60};
constexpr std::array strategies{"explore", "newton-multistart"};
constexpr double solve_limit_s = 20;

struct SweepOptions {
  int scenes = 25;
  double longest_s = 8;
  std::string out, plot;
};

void add_options(CLI::App& app, SweepOptions& options) {
  app.add_option("--scenes", options.scenes, "How many random scenes of each size, in the plane and in space")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--longest", options.longest_s, "Seconds for each strategy on a scene of 20 to 60 points")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--out", options.out, "Markdown file for the results")->required();
  app.add_option("--plot", options.plot, "SVG file for the numbers over time")->required();
}

std::string name_of(const SceneKind& kind) {
  return fmt::format("{}, {} points", kind.dimension == 2 ? "plane" : "space", kind.points);
}

struct CheckedScene {
  SceneKind kind;
  std::uint64_t seed = 0;
  ExploreVerdict verdict;
};
using Scenes = std::vector<CheckedScene>;

/// The next seed from `seed` on that gives a scene which is not taken apart.
std::uint64_t whole_scene(const SceneKind& kind, std::uint64_t seed) {
  while (decompose(random_problem(kind, seed), Split::all).size() > 1) ++seed;
  return seed;
}

/// An interrupt ends the series before the scene that it met.
Scenes check_scenes(const SweepOptions& options) {
  Scenes scenes;
  for (const int dimension : dimensions)
    for (const int points : counted_points) {
      std::uint64_t seed = 0;
      for (int i = 0; i < options.scenes; ++i) {
        const SceneKind kind{dimension, points};
        seed = whole_scene(kind, seed + 1);
        ExploreVerdict verdict = check_explore(random_problem(kind, seed), solve_limit_s);
        if (interrupted()) return scenes;
        scenes.push_back({kind, seed, std::move(verdict)});
      }
      std::cerr << scenes.size() << " scenes\n";
    }
  return scenes;
}

/// How much one strategy found on one large scene, at each time.
struct FoundOverTime {
  SceneKind kind;
  std::uint64_t seed = 0;
  std::string strategy;
  std::vector<FoundSoFar> found;
};

std::vector<double> times_of(const SweepOptions& options) {
  return {options.longest_s / 8, options.longest_s / 4, options.longest_s / 2, options.longest_s};
}

std::vector<FoundOverTime> race(const SweepOptions& options) {
  std::vector<FoundOverTime> rows;
  for (const int dimension : dimensions)
    for (const int points : large_points)
      for (const char* strategy : strategies) {
        const SceneKind kind{dimension, points};
        const std::uint64_t seed = whole_scene(kind, 1);
        std::vector<FoundSoFar> found =
            found_after(random_problem_of_sketch(kind, seed), strategy, times_of(options));
        if (interrupted()) return rows;
        rows.push_back({kind, seed, strategy, std::move(found)});
      }
  return rows;
}

// ---- what is written

template <class Value>
double mean(const Scenes& scenes, Value value) {
  double sum = 0;
  for (const CheckedScene& scene : scenes) sum += static_cast<double>(value(scene.verdict));
  return scenes.empty() ? 0 : sum / static_cast<double>(scenes.size());
}

template <class Condition>
std::ptrdiff_t count(const Scenes& scenes, Condition condition) {
  return std::ranges::count_if(scenes, [&](const CheckedScene& scene) { return condition(scene.verdict); });
}

std::string row(const std::string& name, const Scenes& all) {
  Scenes scenes;
  std::ranges::copy_if(all, std::back_inserter(scenes),
                       [](const CheckedScene& scene) { return scene.verdict.why_not.empty(); });
  return fmt::format(
      "| {} | {} | {} | {:.1f} | {} | {} | {} | {} | {:.0f} | {:.2f} | {:.2f} |\n", name, scenes.size(),
      count(scenes, [](const auto& v) { return v.is_proven; }),
      mean(scenes, [](const auto& v) { return v.real; }),
      count(scenes, [](const auto& v) { return v.from_sketch.solutions > 0; }),
      count(scenes, [](const auto& v) { return v.real > 0 && v.from_sketch.solutions == v.real; }),
      count(scenes, [](const auto& v) { return v.reaches_all(); }),
      count(scenes, [](const auto& v) { return v.components.size() > 1; }),
      mean(scenes, [](const auto& v) { return v.with_starts.curves; }),
      mean(scenes, [](const auto& v) { return v.from_sketch.cpu_s; }),
      mean(scenes, [](const auto& v) { return v.with_starts.cpu_s; }));
}

std::string counts_table(const Scenes& scenes) {
  std::map<std::pair<int, int>, Scenes> kinds;
  for (const CheckedScene& scene : scenes) kinds[{scene.kind.dimension, scene.kind.points}].push_back(scene);
  std::string table =
      "| scenes | number | proven | real solutions | sketch leads to one | reaches all | with starts | "
      "several "
      "components | curves | s from sketch | s with starts |\n"
      "| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |\n";
  for (const auto& [kind, members] : kinds) table += row(name_of({kind.first, kind.second}), members);
  return table + row("all", scenes);
}

std::string sizes(const std::vector<std::size_t>& components) {
  std::string text;
  for (const std::size_t size : components) text += fmt::format("{}{}", text.empty() ? "" : " + ", size);
  return text;
}

/// Scenes with several components, and what was not found or not known.
std::string remarkable_scenes(const Scenes& scenes) {
  std::string text;
  for (const auto& [kind, seed, v] : scenes) {
    const std::string name = fmt::format("- {}, seed {}: ", name_of(kind), seed);
    if (!v.why_not.empty())
      text += fmt::format("{}not counted: {}\n", name, v.why_not);
    else if (v.components.size() > 1 || !v.reaches_all() || v.unexpected > 0)
      text += fmt::format("{}{}; from the sketch {}, with random starts {}{}\n", name, sizes(v.components),
                          v.from_sketch.solutions, v.with_starts.solutions,
                          v.unexpected > 0 ? "; **not among all**: " + std::to_string(v.unexpected) : "");
  }
  return text.empty() ? "None.\n" : text;
}

std::string missing_in_words(const Scenes& scenes) {
  std::size_t missed = 0, largest_only = 0, real = 0, in_largest = 0;
  for (const CheckedScene& scene : scenes) {
    const ExploreVerdict& v = scene.verdict;
    missed += v.real - v.with_starts.solutions;
    real += v.real;
    if (!v.components.empty()) in_largest += v.components.front();
    largest_only += v.components.size() == 1 ? 1 : 0;
  }
  return fmt::format(
      "The graph of real solutions is connected in {} scenes; the largest components hold {} of all {} "
      "solutions. What a sketch's component lacks lies on other components of the curve of every constraint: "
      "none of its curves, each walked to its ends, meets it. Random starts miss {} solutions.",
      largest_only, in_largest, real, missed);
}

std::string race_table(const std::vector<FoundOverTime>& rows) {
  std::string table = "| scene | strategy | solutions in seconds |\n| --- | --- | --- |\n";
  for (const FoundOverTime& one : rows) {
    std::string cell;
    for (const FoundSoFar& found : one.found)
      cell += fmt::format("{}{} in {:.2f}", cell.empty() ? "" : ", ", found.solutions, found.cpu_s);
    table += fmt::format("| {} | {} | {} |\n", name_of(one.kind), one.strategy, cell);
  }
  return table;
}

PlotSeries series_of(const FoundOverTime& one, int style) {
  const bool is_explore = one.strategy == strategies.front();
  PlotSeries series{is_explore ? "explore, " + name_of(one.kind) : one.strategy,
                    is_explore ? PlotMark::curve : PlotMark::dot,
                    {},
                    style};
  for (const auto& [cpu_s, solutions] : one.found)
    series.points.push_back({cpu_s, static_cast<double>(solutions)});
  return series;
}

Plot race_plot(const std::vector<FoundOverTime>& rows) {
  Plot plot;
  plot.description = "Real solutions found over time on random scenes of 20 to 60 points";
  double most = 1, longest_s = 0.1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    PlotSeries series = series_of(rows[i], static_cast<int>(i / strategies.size()));
    for (const auto& [cpu_s, solutions] : series.points) {
      longest_s = std::max(longest_s, cpu_s);
      most = std::max(most, solutions);
    }
    if (std::ranges::count(plot.series, series.label, &PlotSeries::label) > 0) series.label.clear();
    plot.series.push_back(std::move(series));
  }
  plot.x = axis_over("processor time in s", 0, longest_s);
  plot.y = axis_over("solutions", 0, most);
  return plot;
}

std::string report(const Scenes& scenes, const std::vector<FoundOverTime>& rows, double total_s) {
  return fmt::format(
      "# What exploring reaches\n\n"
      "`explore` with its defaults on random rigid graphs that are not taken apart, with random lengths and "
      "a "
      "random sketch, against all real solutions: those of `monodromy`, up to reflection, *proven* where "
      "their "
      "certificates meet the count or the bound. *sketch leads to one*: from S or by Newton's method, "
      "without "
      "random starts, which then *reaches all* or not; *with starts*: scenes of which it reaches all with 64 "
      "random starts. Solutions and curves are means of a scene, and so is processor time, on one thread. "
      "Written "
      "by `scripts/sweep-explore`.\n\n"
      "{}, {:.0f} s.\n\n{}\n{}\n\n"
      "## Where nothing can count\n\n"
      "Real solutions that are found in so much processor time, on a random rigid graph in its sketch's "
      "lengths, so that `explore` has one to begin at; `newton-multistart` begins anywhere. Without "
      "reduction, "
      "on one thread.\n\n{}\n"
      "![Solutions over time](../plots/explore.svg)\n\n"
      "## Scenes of several components\n\n"
      "Sizes of the components, and what explore reaches.\n\n{}",
      where_measured(), total_s, counts_table(scenes), missing_in_words(scenes), race_table(rows),
      remarkable_scenes(scenes));
}

int sweep(const SweepOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  AtomicFile out(options.out), plot(options.plot);
  const Scenes scenes = check_scenes(options);
  const std::vector<FoundOverTime> rows = race(options);
  const double total_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!interrupted()) {
    out.commit(report(scenes, rows, total_s));
    plot.commit(to_svg(race_plot(rows)));
  }
  const auto unexpected = count(scenes, [](const auto& v) { return v.unexpected > 0; });
  std::cout << scenes.size() << " scenes; " << options.out << '\n';
  return unexpected == 0 && !interrupted() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return gcs::sweep_main(argc, argv, "explore_sweep",
                         "Compares explore with all real solutions of random scenes.", add_options, sweep);
}
