/// gcsbench report: rebuilds the tables, figures and the page of stored runs without solving.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/report/page.hpp"
#include "harness/report/page_scene.hpp"
#include "harness/report/verdicts.hpp"
#include "harness/tables/table_output.hpp"

namespace gcs {

namespace {

struct ReportArguments {
  std::vector<std::filesystem::path> runs;
  std::vector<std::string> formats;
  std::optional<std::filesystem::path> out;
};

constexpr const char *svg = "svg", *html = "html";

std::vector<std::string> all_formats() {
  std::vector<std::string> names;
  for (const TableFormat& format : table_formats()) names.emplace_back(format.name);
  names.insert(names.end(), {svg, html});
  return names;
}

bool is_wanted(const ReportArguments& arguments, std::string_view format) {
  const auto& formats = arguments.formats;
  return formats.empty() || std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// Beside the run, unless the user names a folder.
std::filesystem::path folder_of(const std::filesystem::path& run, const ReportArguments& arguments) {
  if (arguments.out) return *arguments.out;
  return folder_of_run(run);
}

/// Those of the tables and of the instances.
std::vector<Drawing> drawings_of(const PageRun& run) {
  std::vector<Drawing> drawings = run.tables.drawings;
  for (const auto& [id, scene] : run.scenes)
    for (Drawing& drawing : draw_scene(scene)) drawings.push_back(std::move(drawing));
  return drawings;
}

/// Two runs of different instances by one name would be shown as if they were of one.
void require_same_instances(const std::vector<PageRun>& runs) {
  std::map<std::string, std::pair<std::string, std::string>> known;  // run and fingerprint by id
  for (const PageRun& run : runs)
    for (const InstanceSummary& instance : run.record.instances) {
      const auto& [first, fingerprint] =
          known.try_emplace(instance.id, run.name, instance.fingerprint).first->second;
      if (fingerprint != instance.fingerprint)
        throw InputError(run.name, "",
                         "the instance '" + instance.id + "' has another content here than in " + first,
                         "report on these runs one by one");
    }
}

std::vector<TableFormat> wanted_tables(const ReportArguments& arguments) {
  std::vector<TableFormat> formats;
  for (const TableFormat& format : table_formats())
    if (is_wanted(arguments, format.name)) formats.push_back(format);
  return formats;
}

/// Reads all runs before it writes anything.
ExitCode report(const ReportArguments& arguments) {
  const std::vector<TableFormat> formats = wanted_tables(arguments);
  const bool with_figures = is_wanted(arguments, svg);
  if (arguments.out && arguments.runs.size() > 1 && (!formats.empty() || with_figures))
    throw UsageError("--out holds the tables and figures of one run; give one RUN, or --format html");
  const Publications publications = load_publications();
  std::vector<PageRun> runs;
  for (const std::filesystem::path& run : arguments.runs) runs.push_back(load_page_run(run, publications));
  require_same_instances(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::filesystem::path folder = folder_of(arguments.runs[i], arguments);
    make_folder(folder);
    write_tables(runs[i].tables, folder, formats);
    const Table verdicts = verdict_table(runs[i].record, runs[i].scenes, publications);
    if (!verdicts.rows.empty()) write_tables(std::span(&verdicts, 1), folder, formats);
    if (with_figures) write_drawings(drawings_of(runs[i]), folder);
    std::cout << shown_on_terminal(runs[i].tables);
  }
  if (is_wanted(arguments, html))
    write_page(runs, publications, folder_of(arguments.runs.front(), arguments));
  return ExitCode::done;
}

}  // namespace

void add_report_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command =
      app.add_subcommand("report", "Rebuild tables, figures and the page of stored runs without solving");
  command->add_option("RUN", arguments->runs, "A run.json, or the folder that holds it")->required();
  command
      ->add_option("--format", arguments->formats,
                   "md, csv, tex (tables), svg (figures), html (the page), separated by commas; default: all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(all_formats()));
  command
      ->add_option("--out", arguments->out,
                   "Folder for the files; default: beside each run, the page beside the first")
      ->check(place_name())
      ->type_name("DIR");
  command->footer(
      "The page, report.html, is one file that needs nothing else: tables, figures, and every instance with "
      "its\n"
      "constraint graph, its solutions, which can be turned, and its path S. It shows all RUNs together. "
      "What it\n"
      "shows of instances is stored by `tables`, `precision` and `stability` --out, in scenes/ and paths/ "
      "beside\n"
      "run.json; a finer path of `gcsbench path` may take the place of one there.\n"
      "\nExamples:\n"
      "  gcsbench report results/runs/today\n"
      "  gcsbench report results/runs/today --format html --out /tmp\n"
      "  gcsbench report tables/ precision/ stability/ --format html\n");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return report(*arguments); }; });
}

}  // namespace gcs
