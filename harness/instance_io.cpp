#include "harness/instance_io.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>

#include "harness/nearest_name.hpp"

namespace gcs {
namespace {

namespace fs = std::filesystem;

/// An instance of the largest size that the analysis takes has less than a megabyte; endless input must end.
constexpr std::size_t size_limit = std::size_t{64} << 20;

/// Where shipped instances are looked up, in this order.
std::vector<fs::path> instance_folders() {
  std::vector<fs::path> folders{"instances", fs::path(GCSBENCH_SOURCE_DIR) / "instances"};
#ifdef GCSBENCH_DATA_DIR
  folders.emplace_back(fs::path(GCSBENCH_DATA_DIR) / "instances");
#endif
  return folders;
}

/// schema.json lies beside the instances.
bool is_instance_file(const fs::path& path) {
  std::error_code ignored;
  return path.extension() == ".json" && path.stem() != "schema" && fs::is_regular_file(path, ignored);
}

std::string read_all(std::istream& stream, const std::string& file) {
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > size_limit)
      throw InputError(file, "", "the input is larger than 64 MiB", "this is no instance");
  }
  if (stream.bad()) throw InputError(file, "", std::string("cannot be read: ") + std::strerror(errno), "");
  return text;
}

std::string read_file(const std::string& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) {
    throw InputError(file, "", "there is no such file", "give a file, the id of a shipped instance, or -");
  }
  if (fs::is_directory(status)) throw InputError(file, "", "this is a directory", "name a file in it");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(file, "", std::string("cannot be opened: ") + std::strerror(errno),
                     "give a readable file");
  }
  return read_all(stream, file);
}

/// A pipe's name says nothing, so that only the name of a true file is compared with the id.
Instance load_file(const std::string& file) {
  const std::string text = read_file(file);
  std::error_code ignored;
  const bool has_name = fs::is_regular_file(file, ignored);
  return parse_instance(text, file, has_name ? fs::path(file).stem().string() : std::string());
}

Instance load_standard_input() {
  const std::string file = "standard input";
  Instance instance = parse_instance(read_all(std::cin, file), file, "");
  instance.origin = "-";
  return instance;
}

std::string find_shipped(const std::string& id) {
  for (const fs::path& folder : instance_folders()) {
    const fs::path file = folder / (id + ".json");
    if (is_instance_file(file)) return file.string();
  }
  const std::vector<std::string> ids = shipped_instances();
  if (ids.empty()) throw InputError("'" + id + "'", "", "there are no shipped instances here", "name a file");
  throw InputError("'" + id + "'", "", "there is no shipped instance of this id",
                   "did you mean '" + nearest_name(id, ids) +
                       "'? 'gcsbench list instances' shows all; a file needs a '/' or ends in .json");
}

}  // namespace

Instance load_instance(const std::string& argument) {
  if (argument == "-") return load_standard_input();
  const bool is_file = argument.find('/') != std::string::npos || argument.ends_with(".json");
  return load_file(is_file ? argument : find_shipped(argument));
}

std::vector<std::string> shipped_instances() {
  std::set<std::string> ids;
  for (const fs::path& folder : instance_folders()) {
    std::error_code absent;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent)) {
      if (is_instance_file(entry.path())) ids.insert(entry.path().stem().string());
    }
  }
  return {ids.begin(), ids.end()};
}

}  // namespace gcs
