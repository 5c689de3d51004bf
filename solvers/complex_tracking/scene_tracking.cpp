#include "solvers/complex_tracking/scene_tracking.hpp"

#include <limits>

#include "solvers/complex_tracking/complex_report.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/options.hpp"

namespace gcs {
namespace {

constexpr std::string_view instruction_sets = "auto|portable|avx2|avx512";

InstructionSet read_instruction_set(const OptionMap& options) {
  const int choice = choice_option(options, "instructions", instruction_sets);
  if (choice == 0) return widest_instruction_set();
  const auto set = static_cast<InstructionSet>(choice - 1);
  if (!is_available(set))
    throw OptionError("option instructions=" + options.find("instructions")->second +
                      ": this machine does not have them; auto takes the widest that it has");
  return set;
}

/// The squared lengths that the file gives.
ComplexVectorX given_squares(const Scene& scene) {
  ComplexVectorX squares;
  for (const DoubleDouble& square : target_squares(scene)) squares.push_back(square.value());
  return squares;
}

}  // namespace

std::vector<OptionSpec> tracking_option_specs() {
  return {
      {"order", "14", "whole number from 4 to 40", "of the Taylor predictor"},
      {"tolerance", "1e-6", "number from 1e-12 to 1e-3",
       "error of a prediction, relative to how far the path goes until its series diverges"},
      {"instructions", "auto", instruction_sets, "SIMD instructions; the result does not depend on them"}};
}

TrackingSetup tracking_setup(const OptionMap& options) {
  TrackingSetup setup;
  setup.options.order = static_cast<int>(integer_option(options, "order", 4, 40));
  setup.options.tolerance = number_option(options, "tolerance", 1e-12, 1e-3);
  setup.set = read_instruction_set(options);
  return setup;
}

std::optional<std::string> why_not_tracked(const Scene& scene) {
  if (scene.problem().lines.size() > 1) return "it places one line at most";
  if (scene.has_lines() && (scene.is_anchored() || scene.reference().line < 0))
    return "it puts the line on the x-axis, which given positions or a reference of points do not allow";
  return std::nullopt;
}

std::optional<std::uint64_t> most_classes(const Scene& scene) {
  const TheoreticalCounts counts = theoretical_counts(scene.problem());
  const SolutionCount* limit = counts.upper_limit();
  if (!limit) return std::nullopt;
  const Natural classes = limit->up_to_reflection();
  if (classes > Natural(std::numeric_limits<std::uint32_t>::max())) return std::nullopt;
  return static_cast<std::uint64_t>(classes.approximate());
}

SceneTracking::SceneTracking(const Scene& scene, const TrackingSetup& setup, std::mt19937_64& random)
    : coordinates_(scene),
      system_(square_system(coordinates_)),
      elimination_(order_elimination(system_, random)),
      tracking_(system_, elimination_, setup) {}

SolveReport SceneTracking::solve(const std::vector<ComplexVectorX>& solutions, const ComplexVectorX& from,
                                 const SolveRequest& request, WorkCounters work) {
  const auto stopped = [&] { return request.stop.stop_requested(); };
  const auto progress = [&](double fraction) {
    if (request.monitor) request.monitor->progress("paths to the given lengths", fraction);
  };
  const std::vector<PathEnd> ends =
      follow_to_end(tracking_, solutions, from, given_squares(request.scene), stopped, progress, work);
  std::mt19937_64 random(request.seed);
  return complex_report(request.scene, coordinates_, ends, work, random);
}

}  // namespace gcs
