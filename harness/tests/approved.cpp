#include "harness/tests/approved.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace gcs {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

void check_approved(const std::string& name, const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::path(GCSBENCH_SOURCE_DIR) / "harness/tests/approved" / name;
  if (std::getenv("GCSBENCH_APPROVE") != nullptr) {
    std::ofstream(file, std::ios::binary) << text;
    return;
  }
  INFO(name << " differs from what was approved; if the change is meant, run scripts/approve");
  CHECK(content_of(file) == text);
}

}  // namespace gcs
