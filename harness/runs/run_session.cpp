#include "harness/runs/run_session.hpp"

#include <fmt/chrono.h>
#include <stdlib.h>

#include <ctime>
#include <filesystem>
#include <system_error>

namespace gcs {

RunSession start_session(const std::vector<std::string>& arguments) {
  RunSession session;
  session.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  session.arguments = arguments;
  std::error_code unknown;
  session.folder = std::filesystem::current_path(unknown).string();
  std::array<double, 3> load{};
  if (getloadavg(load.data(), static_cast<int>(load.size())) == static_cast<int>(load.size()))
    session.load_average = load;
  return session;
}

}  // namespace gcs
