/// gcsbench report: rebuilds the tables of stored runs without solving.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/commands.hpp"
#include "harness/table_output.hpp"

namespace gcs {

namespace {

struct ReportArguments {
  std::vector<std::filesystem::path> runs;
  std::vector<std::string> formats;
  std::optional<std::filesystem::path> out;
};

TableFormat find_format(const std::string& name) {
  const auto formats = table_formats();
  const auto found =
      std::find_if(formats.begin(), formats.end(), [&](const TableFormat& f) { return f.name == name; });
  if (found != formats.end()) return *found;
  throw UsageError(
      fmt::format("--format {}: not available in this version; there are md, csv and tex", name));
}

std::vector<TableFormat> formats_of(const ReportArguments& arguments) {
  const auto all = table_formats();
  if (arguments.formats.empty()) return {all.begin(), all.end()};
  std::vector<TableFormat> formats;
  std::transform(arguments.formats.begin(), arguments.formats.end(), std::back_inserter(formats),
                 find_format);
  return formats;
}

/// Beside the run, unless the user names a folder.
std::filesystem::path folder_of(const std::filesystem::path& run, const ReportArguments& arguments) {
  if (arguments.out) return *arguments.out;
  return std::filesystem::is_directory(run) ? run : run.parent_path();
}

ExitCode report(const ReportArguments& arguments) {
  if (arguments.out && arguments.runs.size() > 1)
    throw UsageError("--out holds the tables of one run; give one RUN");
  const std::vector<TableFormat> formats = formats_of(arguments);
  const Publications publications = load_publications();
  for (const std::filesystem::path& run : arguments.runs) {
    const TableSet set = build_tables(load_run_record(run), publications);
    write_tables(set, folder_of(run, arguments), formats);
    std::cout << shown_on_terminal(set);
  }
  return ExitCode::done;
}

}  // namespace

void add_report_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", "Rebuild the tables of stored runs without solving");
  command->add_option("RUN", arguments->runs, "A run.json, or the folder that holds it")->required();
  command->add_option("--format", arguments->formats, "md, csv, tex, separated by commas; default: all three")
      ->delimiter(',');
  command->add_option("--out", arguments->out, "Folder for the files; default: beside the run");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return report(*arguments); }; });
}

}  // namespace gcs
