#include "harness/ranks/ranks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "harness/base/environment.hpp"
#include "harness/base/errors.hpp"

namespace gcs {

namespace fs = std::filesystem;

namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

/// What Open MPI, MPICH and Slurm tell a rank of itself.
bool is_one_of_several() {
  constexpr std::array sizes{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
  for (const char* size : sizes)
    if (!variable(size).empty()) return variable(size) != "1";
  return !variable("PMIX_RANK").empty();
}

bool is_first() {
  constexpr std::array ranks{"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"};
  return std::all_of(ranks.begin(), ranks.end(),
                     [](const char* rank) { return variable(rank).empty() || variable(rank) == "0"; });
}

/// Beside the program in the build, and where it is installed. Null where it is not there.
void* load_module() {
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const fs::path& place : {folder, folder / GCSBENCH_MODULE_FOLDER})
    if (const fs::path file = place / "gcsbench_mpi.so"; fs::exists(file, unknown))
      return dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  return nullptr;
}

}  // namespace

const MessagePassing* start_ranks() {
  if (!is_one_of_several()) return nullptr;
  void* module = load_module();
  void* start = module == nullptr ? nullptr : dlsym(module, start_message_passing_name);
  const MessagePassing* passing = start == nullptr ? nullptr : reinterpret_cast<StartMessagePassing>(start)();
  if (passing == nullptr)
    throw UserError(is_first() ? "started as several ranks, and this build has no MPI: build it where Open "
                                 "MPI is found, with GCSBENCH_WITH_MPI=ON, or start one process"
                               : "");
  return passing;
}

std::string build_of_program() {
  const Environment environment = capture_environment(1);
  return fmt::format("version {}, commit {}, {}, {}", program_version(), environment.commit,
                     environment.compiler, environment.flags);
}

}  // namespace gcs
