#pragma once
/// The page of `gcsbench report --format html`: one file that needs nothing else.

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

/// The whole HTML document: what is proven, the tables and figures of every run, and every instance of any
/// run once, as the first run with a stored scene has it. Equal runs give equal text.
std::string page_html(const std::vector<PageRun>& runs, const Publications& publications);

}  // namespace gcs
