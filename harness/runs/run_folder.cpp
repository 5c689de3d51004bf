#include "harness/runs/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/record_fields.hpp"
#include "solvers/reading/json_document.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {

namespace fs = std::filesystem;

namespace {

constexpr const char* remedy = "choose another --out, or leave --resume out to start again";

/// What must not change while a run goes on, by names for a person.
std::map<std::string, std::string> fixed_facts(const RunFile& record) {
  std::map<std::string, std::string> facts;
  visit_environment(record.environment, [&](const std::string& name, const auto& value) {
    facts[name] = fmt::format("{}", value);
  });
  facts["seed"] = std::to_string(record.seed);
  for (const InstanceSummary& instance : record.instances)
    facts[fmt::format("content of instance '{}'", instance.id)] = instance.fingerprint;
  return facts;
}

/// "commit abc (now def), seed 1 (now 2)"
std::string differences(const RunFile& there, const RunFile& here) {
  const auto now = fixed_facts(here);
  std::string text;
  for (const auto& [name, value] : fixed_facts(there)) {
    const auto found = now.find(name);
    if (found == now.end() || found->second == value) continue;
    text += fmt::format("{}{} {} (now {})", text.empty() ? "" : ", ", name, value, found->second);
  }
  return text;
}

/// Times of two builds or machines, or answers to two problems, must not meet in one run; nor may what was
/// measured be dropped.
void require_same_run(const RunFile& there, const RunFile& here, const std::vector<CellSpec>& asked,
                      const std::string& file) {
  if (const std::string text = differences(there, here); !text.empty())
    throw InputError(file, "", "this run cannot be resumed; what differs: " + text, remedy);
  for (const CellRecord& cell : there.cells)
    if (std::find(asked.begin(), asked.end(), cell.spec) == asked.end())
      throw InputError(
          file, "",
          fmt::format("this run has measured {}, {}, which is not asked for now", cell.spec.instance,
                      label_of(cell.spec)),
          "ask for the same tables, instances and strategies, or for more; or " + std::string(remedy));
}

}  // namespace

RunFolder::RunFolder(const fs::path& folder) : file_(folder / "run.json") {
  make_folder(folder);
  const auto fail = [&](const std::string& cause) {
    throw OutputError(folder.string() + ": cannot be written: " + cause);
  };
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) fail(std::generic_category().message(errno));
  // A file system that knows no locks goes without.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(descriptor_);
    fail("another process measures into this folder");
  }
  remove_leftovers(folder);
}

RunFolder::~RunFolder() { close(descriptor_); }

std::optional<RunFile> RunFolder::resumed(const RunFile& now, const std::vector<CellSpec>& asked) const {
  if (!fs::exists(file_)) return std::nullopt;
  const std::string file = file_.string();
  RunFile earlier = parse_run_file(read_file(file, remedy), file);
  require_same_run(earlier, now, asked, file);
  return earlier;
}

void RunFolder::store(const RunFile& record) const { AtomicFile(file_).commit(to_json_text(record)); }

}  // namespace gcs
