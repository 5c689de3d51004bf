#pragma once
/// The folder that keeps a run while it is measured.

#include <filesystem>
#include <optional>
#include <vector>

#include "harness/runs/run_file.hpp"

namespace gcs {

class RunFolder {
 public:
  /// Makes the folder with its parents unless it is there, and claims it while this object lives. Removes
  /// what a killed process left half written. Throws OutputError when the folder cannot be written or another
  /// process has claimed it.
  explicit RunFolder(const std::filesystem::path& folder);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// The run that is kept there, if any. Throws InputError when it cannot be read, or when it is not of
  /// `now`: another program, machine or seed, an instance with other content, or cells that `now` does not
  /// ask for.
  std::optional<RunFile> resumed(const RunFile& now, const std::vector<CellSpec>& asked) const;

  /// Keeps this record instead, all at once or not at all. Throws OutputError.
  void store(const RunFile& record) const;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace gcs
