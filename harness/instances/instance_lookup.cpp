#include "harness/instances/instance_lookup.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

#include "harness/base/shipped_data.hpp"
#include "harness/instances/families.hpp"
#include "solvers/reading/nearest_name.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

namespace fs = std::filesystem;

/// schema.json lies beside the instances.
bool is_instance_file(const fs::path& path) {
  std::error_code ignored;
  return path.extension() == ".json" && path.stem() != "schema" && fs::is_regular_file(path, ignored);
}

Instance load_standard_input() {
  const std::string file = "standard input";
  Instance instance = parse_instance(read_all(std::cin, file), file);
  instance.origin = "-";
  return instance;
}

std::string find_shipped(const std::string& id) {
  const fs::path below = fs::path("instances") / (id + ".json");
  if (const auto file = shipped_file(below); file && is_instance_file(*file)) return file->string();
  const std::vector<std::string> ids = shipped_instances();
  if (ids.empty()) throw InputError("'" + id + "'", "", "there are no shipped instances here", "name a file");
  throw InputError("'" + id + "'", "", "there is no shipped instance of this id",
                   "did you mean '" + nearest_name(id, ids) +
                       "'? 'gcsbench list instances' shows all; a file needs a '/' or ends in .json");
}

std::string short_list(const InstanceFamily& family) {
  constexpr std::size_t most_named = 20;
  const std::vector<std::string> members = family.members();
  return members.size() <= most_named ? quoted_list(members)
                                      : "'" + members.front() + "' to '" + members.back() + "'";
}

/// A member of a family, "short-edge@1e-8".
Instance load_made(const std::string& id) {
  const std::string name = id.substr(0, id.find('@'));
  const InstanceFamily* family = find_family(name);
  if (family == nullptr) {
    std::vector<std::string> names;
    for (const auto kind : all_families())
      for (const InstanceFamily& one : kind) names.emplace_back(one.name);
    throw InputError("'" + id + "'", "", "there is no family '" + name + "'",
                     "did you mean '" + nearest_name(name, names) + "'?");
  }
  const std::vector<std::string> members = family->members();
  if (std::find(members.begin(), members.end(), id) == members.end())
    throw InputError("'" + id + "'", "", "the family has no such member",
                     "did you mean '" + nearest_name(id, members) + "'? It has " + short_list(*family));
  return load_member(id);
}

}  // namespace

Instance load_instance(const std::string& argument) {
  if (argument == "-") return load_standard_input();
  const bool is_file = argument.find('/') != std::string::npos || argument.ends_with(".json");
  if (!is_file && argument.find('@') != std::string::npos) return load_made(argument);
  return read_instance(is_file ? argument : find_shipped(argument),
                       "give a file, the id of a shipped instance, or -");
}

namespace {

std::optional<JsonValue> shipped_document(const std::string& id) {
  if (const InstanceFamily* family = find_family(id.substr(0, id.find('@'))); family != nullptr) {
    const std::vector<std::string> members = family->members();
    if (std::find(members.begin(), members.end(), id) != members.end()) return load_member(id).document;
  }
  const auto file = shipped_file(fs::path("instances") / (id + ".json"));
  return file ? std::optional(parse_json(read_file(*file, ""), *file)) : std::nullopt;
}

}  // namespace

bool is_shipped(const Instance& instance) {
  const auto document = shipped_document(instance.id);
  return document && to_text(*document, -1) == to_text(instance.document, -1);
}

std::vector<std::string> shipped_instances() {
  std::set<std::string> ids;
  for (const fs::path& folder : data_folders()) {
    std::error_code absent;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "instances", absent)) {
      if (is_instance_file(entry.path())) ids.insert(entry.path().stem().string());
    }
  }
  return {ids.begin(), ids.end()};
}

}  // namespace gcs
