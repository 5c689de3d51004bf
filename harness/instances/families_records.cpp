/// Graphs at lengths with many real realisations: what scripts/sweep-records wrote into results/records.

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "harness/base/shipped_data.hpp"
#include "harness/instances/families.hpp"
#include "harness/instances/problem_text.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/reading/instance_parser.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

namespace fs = std::filesystem;

fs::path record_folder() { return fs::path("results") / "records"; }

std::string record_text(const std::string& id, const std::string& value) {
  const std::string file = shipped_file(record_folder() / (value + ".json")).value();
  return problem_text(Scene(parse_instance(read_file(file, ""), file).problem), id);
}

std::vector<std::string> record_names() {
  std::vector<std::string> names;
  for (const fs::path& data : data_folders()) {
    std::error_code none;
    for (const fs::directory_entry& file : fs::directory_iterator(data / record_folder(), none))
      names.push_back(file.path().stem());
    if (!names.empty()) break;
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::span<const InstanceFamily> record_families() {
  static const std::vector<InstanceFamily> all{
      {"record", "a graph at lengths with many real realisations", record_names(), record_text}};
  return all;
}

}  // namespace gcs
