#include "harness/solving/file_journal.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/base/atomic_file.hpp"
#include "harness/tests/test_folder.hpp"
#include "solvers/reading/json_build.hpp"

using namespace gcs;
namespace fs = std::filesystem;

namespace {

JsonValue identity(int seed) {
  return json_object({{"strategy", json_text("toy")}, {"seed", json_number(seed)}});
}

constexpr int steps = 6;

/// Of different lengths, one of them empty.
Journal::Block step_result(int step) {
  return Journal::Block(static_cast<std::size_t>(7 * step % 11), 1.0 / (step + 3));
}

/// A run of `steps` steps. Returns how many were computed; all results are checked.
int run(const fs::path& file, int seed = 1) {
  FileJournal journal(file, identity(seed));
  int computed = 0;
  for (int step = 0; step < steps; ++step) {
    const auto block = journal.result(static_cast<std::uint64_t>(100 + step), [&] {
      ++computed;
      return std::optional(step_result(step));
    });
    CHECK(block == step_result(step));
  }
  CHECK(journal.recalled() == steps - computed);
  return computed;
}

/// The message with which the file is refused, after checking that it is left as it was.
template <class Error>
std::string refusal(const fs::path& file, int seed = 1) {
  const std::string before = content_of(file);
  std::string message;
  try {
    run(file, seed);
  } catch (const Error& error) {
    message = error.what();
  }
  CHECK(content_of(file) == before);
  CHECK(message.starts_with(file.string()));
  return message;
}

}  // namespace

TEST_CASE("what a journal holds is not computed again") {
  const TestFolder folder;
  const fs::path file = folder / "run.journal";
  CHECK(run(file) == steps);
  const std::string whole = content_of(file);
  CHECK(run(file) == 0);
  CHECK(content_of(file) == whole);
}

TEST_CASE("a journal may be cut at any byte") {
  const TestFolder folder;
  const fs::path file = folder / "run.journal";
  run(file);
  const std::string whole = content_of(file);
  int last = steps;
  for (std::size_t bytes = 0; bytes <= whole.size(); ++bytes) {
    write_file(file, whole.substr(0, bytes));
    const int computed = run(file);
    CHECK(computed <= last);
    last = computed;
    REQUIRE(content_of(file) == whole);
  }
  CHECK(last == 0);
}

TEST_CASE("the last record of a journal may hold anything") {
  const TestFolder folder;
  const fs::path file = folder / "run.journal";
  run(file);
  const std::string whole = content_of(file);
  std::string torn = whole;
  std::fill(torn.end() - 16, torn.end(), '\0');
  write_file(file, torn);
  CHECK(run(file) == 1);
  CHECK(content_of(file) == whole);
}

TEST_CASE("a step that was stopped leaves no record") {
  const TestFolder folder;
  const fs::path file = folder / "run.journal";
  {
    FileJournal journal(file, identity(1));
    journal.result(100, [] { return std::optional(step_result(0)); });
    CHECK_FALSE(journal.result(101, [] { return std::optional<Journal::Block>(); }));
  }
  CHECK(run(file) == steps - 1);
}

TEST_CASE("a file that is no journal of this run is refused and left as it was") {
  const TestFolder folder;
  const fs::path file = folder / "run.journal";
  run(file);
  const std::string whole = content_of(file);
  SECTION("of another run, and the message says in what it differs") {
    const std::string message = refusal<InputError>(file, 2);
    CHECK(message.find("another run") != std::string::npos);
    CHECK(message.find("seed") != std::string::npos);
    CHECK(message.find("strategy") == std::string::npos);
  }
  SECTION("of other steps") {
    const fs::path other = folder / "other.journal";
    FileJournal(other, identity(1)).result(999, [] { return std::optional(step_result(0)); });
    CHECK(refusal<InputError>(other).find("step 1") != std::string::npos);
  }
  SECTION("damaged before its end") {
    std::string damaged = whole;
    damaged[damaged.find('\n') + 1 + 24 + 20] ^= 1;
    write_file(file, damaged);
    CHECK(refusal<InputError>(file).find("damaged") != std::string::npos);
  }
  SECTION("of another format") {
    write_file(file, "{\"format\":\"gcsbench-instance/1\"}\n");
    CHECK(refusal<InputError>(file).find("no journal") != std::string::npos);
  }
  SECTION("of no format") {
    write_file(file, std::string(5000, 'x'));
    CHECK(refusal<InputError>(file).find("no journal") != std::string::npos);
  }
}

TEST_CASE("a place that cannot be written is refused") {
  const TestFolder folder;
  CHECK_THROWS_AS(run(folder / "missing" / "run.journal"), OutputError);
  fs::create_directory(folder / "folder");
  CHECK_THROWS_AS(run(folder / "folder"), OutputError);
  CHECK_THROWS_AS(run("/dev/null"), OutputError);
}

TEST_CASE("two runs do not share a journal") {
  const TestFolder folder;
  const FileJournal first(folder / "run.journal", identity(1));
  CHECK_THROWS_AS(FileJournal(folder / "run.journal", identity(1)), OutputError);
}
