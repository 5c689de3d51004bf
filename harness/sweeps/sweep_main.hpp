#pragma once
/// What the programs behind scripts/sweep-* share.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace gcs {

/// The main function of a sweep: options that `add_options` declares on the command line, then `sweep`, whose exit code it
/// returns; that of CLI11 for a wrong command line, and 2 with one message for what is thrown. Interrupts are caught (see
/// stop_conditions.hpp).
int sweep_main(int argc, char** argv, const std::string& name, const std::string& description,
               const std::function<void(CLI::App&)>& add_options, const std::function<int()>& sweep);

/// The same with options in a struct.
template <class Options>
int sweep_main(int argc, char** argv, const std::string& name, const std::string& description,
               void (*add_options)(CLI::App&, Options&), int (*sweep)(const Options&)) {
  Options options;
  return sweep_main(
      argc, argv, name, description, [&](CLI::App& app) { add_options(app, options); },
      [&] { return sweep(options); });
}

/// Commit, compiler and processor, as results name them.
std::string where_measured();

}  // namespace gcs
