#pragma once
/// The page of `gcsbench report --format html`: one file that needs nothing else.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "harness/runs/shown_scene_files.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {

/// A run as a page shows it.
struct PageRun {
  std::string name;  ///< of its folder
  RunFile record;
  TableSet tables;
  std::map<std::string, StoredScene> scenes;  ///< by id of the instance; those that were stored
};

/// The run in that folder, or in that run.json, with its tables and what is stored of its instances. Throws InputError.
PageRun load_page_run(const std::filesystem::path& run, const Publications& publications);

/// That folder, or the one that holds that run.json.
std::filesystem::path folder_of_run(const std::filesystem::path& run);

/// The whole HTML document: what is proven, the tables and figures of every run, and every instance of any
/// run once, as the first run with a stored scene has it. Equal runs give equal text.
std::string page_html(const std::vector<PageRun>& runs, const Publications& publications);

/// Writes it to the file report.html of that folder. Throws OutputError.
void write_page(const std::vector<PageRun>& runs, const Publications& publications,
                const std::filesystem::path& folder);

}  // namespace gcs
