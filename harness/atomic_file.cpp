#include "harness/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

namespace gcs {

namespace fs = std::filesystem;

namespace {

/// Where a link leads: replacing the link itself would leave its target as it was.
fs::path through_links(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  return error ? path : real;
}

/// The name of a new file ends in six characters that mkstemps makes up, and this.
constexpr std::string_view unfinished = ".unfinished";

int create_beside(const fs::path& target, fs::path& created) {
  std::string name = target.string() + ".XXXXXX" + std::string(unfinished);
  const int descriptor = mkstemps(name.data(), static_cast<int>(unfinished.size()));
  created = name;
  if (descriptor < 0) return descriptor;
  // mkstemp makes the file private; a result has the permissions of any new file.
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, 0666 & ~mask);
  return descriptor;
}

}  // namespace

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

AtomicFile::AtomicFile(const fs::path& target) : named_(target), target_(through_links(target)) {
  std::error_code ignored;
  if (fs::is_directory(target_, ignored)) fail(EISDIR);
  const bool is_special = fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored);
  if (is_special) {
    written_ = target_;
    descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    if (fs::exists(target_, ignored) && access(target_.c_str(), W_OK) != 0) fail(errno);
    descriptor_ = create_beside(target_, written_);
  }
  if (descriptor_ < 0) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  if (written_ != target_) unlink(written_.c_str());
}

void AtomicFile::commit(std::string_view text) {
  if (const int error = write_all(descriptor_, text)) fail(error);
  // Some file systems report a full disk only now.
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);
  if (written_ != target_ && rename(written_.c_str(), target_.c_str()) != 0) fail(errno);
  close(descriptor_);
  descriptor_ = -1;
}

void remove_leftovers(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> leftovers;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().ends_with(unfinished)) leftovers.push_back(entry.path());
  for (const fs::path& leftover : leftovers) fs::remove(leftover, ignored);
}

void AtomicFile::fail(int error) const {
  throw OutputError(named_.string() + ": cannot be written: " + std::generic_category().message(error));
}

}  // namespace gcs
