#include "harness/base/shipped_data.hpp"

#include <dlfcn.h>

#include <system_error>

namespace gcs {

namespace fs = std::filesystem;

namespace {

/// The file that this code was loaded from: the program, or a module that has taken it in. Empty where the system
/// does not say.
fs::path loaded_from() {
  std::error_code unknown;
  Dl_info code{};
  if (dladdr(reinterpret_cast<const void*>(&loaded_from), &code) != 0 && code.dli_fname != nullptr)
    if (const fs::path module(code.dli_fname); module.extension() == ".so")
      return fs::canonical(module, unknown);
  return fs::read_symlink("/proc/self/exe", unknown);
}

/// Where PREFIX/bin/gcsbench, or a module at any depth in PREFIX/lib, has its data, wherever PREFIX was moved to; empty
/// where there is none.
fs::path installed_data() {
  std::error_code ignored;
  fs::path folder = loaded_from().parent_path();
  while (folder.has_relative_path()) {
    folder = folder.parent_path();
    if (fs::path data = folder / "share" / "gcsbench"; fs::is_directory(data, ignored)) return data;
  }
  return {};
}

}  // namespace

std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders{fs::path()};
  if (const fs::path installed = installed_data(); !installed.empty()) folders.push_back(installed);
  folders.emplace_back(GCSBENCH_SOURCE_DIR);
  return folders;
}

std::optional<fs::path> shipped_file(const fs::path& below) {
  for (const fs::path& folder : data_folders()) {
    const fs::path file = folder / below;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) return file;
  }
  return std::nullopt;
}

}  // namespace gcs
