#include "harness/drawings/pdf_figure.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "harness/base/atomic_file.hpp"

namespace gcs {
namespace {

constexpr const char* program = "rsvg-convert";

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, FileCloser>;

/// A nameless file that is gone at the end.
TemporaryFile temporary_file(const std::filesystem::path& target) {
  TemporaryFile file(std::tmpfile());
  if (!file)
    throw OutputError(target.string() + ": cannot be written: no temporary file: " + std::strerror(errno));
  return file;
}

class SpawnActions {
 public:
  SpawnActions() { posix_spawn_file_actions_init(&actions_); }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  void redirect(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  void silence(int descriptor) {
    posix_spawn_file_actions_addopen(&actions_, descriptor, "/dev/null", O_RDWR, 0);
  }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// The exit code of the program; -1 where it cannot be run.
int run(const std::vector<const char*>& arguments, const SpawnActions& actions) {
  std::vector<char*> words;
  for (const char* argument : arguments) words.push_back(const_cast<char*>(argument));
  words.push_back(nullptr);
  // A fixed date: the same drawing is the same file.
  std::vector<std::string> variables{"SOURCE_DATE_EPOCH=0"};
  for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, program, actions.get(), nullptr, words.data(), environment.data()) != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string content(std::FILE* file) {
  std::string text;
  std::array<char, 65536> block{};
  std::rewind(file);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file))
    text.append(block.data(), count);
  return text;
}

}  // namespace

bool pdf_converter_is_there() {
  SpawnActions actions;
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) actions.silence(descriptor);
  return run({program, "--version"}, actions) == 0;
}

void write_pdf(const std::string& svg, const std::filesystem::path& file) {
  AtomicFile target(file);
  const TemporaryFile input = temporary_file(file), output = temporary_file(file);
  std::fwrite(svg.data(), 1, svg.size(), input.get());
  std::rewind(input.get());
  SpawnActions actions;
  actions.redirect(fileno(input.get()), STDIN_FILENO);
  actions.redirect(fileno(output.get()), STDOUT_FILENO);
  if (run({program, "--format=pdf"}, actions) != 0)
    throw OutputError(file.string() + ": cannot be written: " + program + " failed on the figure");
  target.commit(content(output.get()));
}

}  // namespace gcs
