#include "harness/base/shipped_data.hpp"

#include <system_error>

namespace gcs {

namespace fs = std::filesystem;

namespace {

/// PREFIX/bin/gcsbench has its data in PREFIX/share/gcsbench, wherever PREFIX was moved to. Empty where the
/// system does not say which program runs.
fs::path installed_data() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  return unknown ? fs::path() : program.parent_path().parent_path() / "share" / "gcsbench";
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
