/// gcsbench path: S, proven, as a polyline for plots.

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/cli/progress_line.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/results/path_io.hpp"
#include "solvers/proven_paths/certified_tracker.hpp"

namespace gcs {

namespace {

/// Finer series than for counting crossings: the tubes around them are thinner than the finest polyline
/// needs.
constexpr double series_tolerance = 1e-10;

struct PathArguments {
  std::string instance;
  std::string out;
  double within = 1e-3;
};

ExitCode give_up(const std::string& reason, ExitCode code) {
  std::cerr << "gcsbench: " << reason << '\n';
  return code;
}

ExitCode write_path(const PathArguments& arguments, bool quiet) {
  const Instance instance = load_instance(arguments.instance);
  require_another_file(arguments.out, instance.origin);
  const Scene scene = instance;
  if (const auto reason = why_no_path_text(scene)) return give_up(*reason, ExitCode::not_solved);
  Output out(arguments.out);
  catch_interrupts();
  const StopWatch watch(std::nullopt);
  ProgressLine progress(!quiet);
  SeriesTrackerOptions options;
  options.tolerance = series_tolerance;
  CertifiedTracker tracker(scene, options, {watch.token(), &progress});
  tracker.keep_arcs();
  const TrackedPath path = tracker.run();
  if (path.end == TrackedPath::End::stopped) return give_up("interrupted", ExitCode::interrupted);
  if (!path.proven) return give_up("gave up: " + path.cause, ExitCode::not_solved);
  out.commit(path_text(instance, scene, tracker.arcs(), arguments.within));
  return ExitCode::done;
}

}  // namespace

void add_path_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<PathArguments>();
  CLI::App* command = app.add_subcommand("path", "Write the path S, proven, as a polyline for plots");
  add_instance_argument(*command, arguments->instance);
  command->add_option("--out", arguments->out, "The file to write, as JSON; - is standard output")
      ->check(output_name())
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--within", arguments->within,
                   "How far S may be from the polyline, relative to the scene's size")
      ->check(number_between(1e-5, 0.1, "a number from 1e-5 to 0.1"))
      ->type_name("R")
      ->capture_default_str();
  command->footer(
      "Each row of the file is a corner: t, the arc length from the sketch, the radius around the\n"
      "segment to the next corner that provably holds that part of S, and all coordinates that move.\n"
      "The crossings of t = 1, the solutions on S, are corners and listed. S is tracked as by full-space\n"
      "with mode=certified, in thinner tubes.\n"
      "\nExample:\n"
      "  gcsbench path disulfide --within 1e-2 --out disulfide-path.json\n");
  command->callback([&invocation, arguments] {
    invocation.action = [&invocation, arguments] { return write_path(*arguments, invocation.quiet); };
  });
}

}  // namespace gcs
