#include "harness/base/atomic_file.hpp"

#include <catch2/catch.hpp>

#include "harness/tests/test_folder.hpp"

using namespace gcs;
namespace fs = std::filesystem;

TEST_CASE("what a killed process left is removed, and nothing else") {
  const TestFolder folder;
  write_file(folder / "run.json.aB3dE9.unfinished", "left");
  write_file(folder / "notes.unfinished", "somebody's");
  write_file(folder / "a.b-3dE9.unfinished", "somebody's");
  write_file(folder / "run.json.aB3dE9", "somebody's");
  AtomicFile file(folder / "result.json");
  remove_leftovers(folder / "");
  CHECK_FALSE(fs::exists(folder / "run.json.aB3dE9.unfinished"));
  CHECK(fs::exists(folder / "notes.unfinished"));
  CHECK(fs::exists(folder / "a.b-3dE9.unfinished"));
  CHECK(fs::exists(folder / "run.json.aB3dE9"));
  file.commit("whole");
  CHECK(content_of(folder / "result.json") == "whole");
}
