#include "harness/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "harness/base/atomic_file.hpp"

namespace gcs {
namespace {

using Clock = std::chrono::steady_clock;

/// Tens of thousands of solutions have a megabyte; endless output must end.
constexpr std::size_t most_output = std::size_t{64} << 20;
constexpr std::size_t kept_errors = 4096;

/// What a command gets to clean up after itself.
constexpr auto grace = std::chrono::seconds(1);

/// Between two looks at whether a command that has closed its output has ended: it takes microseconds.
constexpr int exit_poll_ms = 1;

[[noreturn]] void fail(const char* what, int error = errno) {
  throw std::system_error(error, std::generic_category(), what);
}

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() {
    if (is_open()) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

struct Pipe {
  Descriptor reading, writing;

  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
    reading = Descriptor(ends[0]);
    writing = Descriptor(ends[1]);
  }
};

/// A file in memory: unlike a pipe it needs nobody to write while the command reads, or does not.
Descriptor file_of(std::string_view text) {
  Descriptor file(memfd_create("input", MFD_CLOEXEC));
  if (!file.is_open()) fail("memfd_create");
  if (const int error = write_all(file.number(), text)) fail("write", error);
  lseek(file.number(), 0, SEEK_SET);
  return file;
}

/// Arguments of posix_spawn that must be given back.
class SpawnSettings {
 public:
  SpawnSettings(int input, int output, int errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setflags(&attributes_,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

bool have_one_name(std::string_view variable, std::string_view other) {
  return variable.substr(0, variable.find('=')) == other.substr(0, other.find('='));
}

/// The environment of this process with `variables` in the place of its own of these names.
std::vector<char*> environment_with(std::vector<std::string>& variables) {
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  for (char** inherited = environ; *inherited != nullptr; ++inherited)
    if (std::ranges::none_of(variables, [&](const auto& one) { return have_one_name(one, *inherited); }))
      environment.push_back(*inherited);
  environment.push_back(nullptr);
  return environment;
}

class RunningCommand {
 public:
  RunningCommand(std::string command, std::string_view input, std::vector<std::string> variables) {
    const Descriptor file = file_of(input);
    const SpawnSettings settings(file.number(), output_.writing.number(), errors_.writing.number());
    std::string shell = "sh", option = "-c";
    std::array<char*, 4> arguments{shell.data(), option.data(), command.data(), nullptr};
    const int error = posix_spawn(&process_, "/bin/sh", settings.actions(), settings.attributes(),
                                  arguments.data(), environment_with(variables).data());
    if (error != 0) fail("posix_spawn", error);
    output_.writing.close();
    errors_.writing.close();
  }

  ~RunningCommand() {
    kill(-process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  CommandOutcome run(const std::stop_token& stop) {
    const std::stop_callback waker(stop, [this] { wake_.writing.close(); });
    while (is_open() && outcome_.end == CommandOutcome::End::exited) {
      if (is_woken(-1)) outcome_.end = CommandOutcome::End::stopped;
      if (outcome_.output.size() > most_output) outcome_.end = CommandOutcome::End::too_much_output;
    }
    while (outcome_.end == CommandOutcome::End::exited && !has_ended())
      if (is_woken(exit_poll_ms)) outcome_.end = CommandOutcome::End::stopped;
    if (outcome_.end == CommandOutcome::End::stopped || outcome_.end == CommandOutcome::End::too_much_output)
      terminate();
    return std::move(outcome_);
  }

 private:
  bool is_open() const { return output_.reading.is_open() || errors_.reading.is_open(); }

  /// Waits until there is something to read, and reads it. True when stop was asked for.
  bool is_woken(int timeout_ms) {
    std::array<pollfd, 3> events{pollfd{output_.reading.number(), POLLIN, 0},
                                 pollfd{errors_.reading.number(), POLLIN, 0},
                                 pollfd{wake_.reading.number(), POLLIN, 0}};
    if (poll(events.data(), events.size(), timeout_ms) <= 0) return false;
    if (events[0].revents != 0) take(output_.reading, outcome_.output);
    if (events[1].revents != 0) take(errors_.reading, outcome_.errors);
    if (outcome_.errors.size() > kept_errors) outcome_.errors.erase(0, outcome_.errors.size() - kept_errors);
    return events[2].revents != 0;
  }

  static void take(Descriptor& descriptor, std::string& text) {
    std::array<char, 65536> block{};
    const ssize_t count = read(descriptor.number(), block.data(), block.size());
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) descriptor.close();
  }

  /// Leaves the process to be waited for, so that its number stays its own.
  bool has_ended() {
    siginfo_t info{};
    const int result = waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT);
    if (result != 0 || info.si_pid == 0) return false;
    if (info.si_code != CLD_EXITED) outcome_.end = CommandOutcome::End::killed;
    outcome_.code = info.si_status;
    return true;
  }

  /// The group is gone when nobody holds the pipes any more.
  void terminate() {
    kill(-process_, SIGTERM);
    const auto deadline = Clock::now() + grace;
    while (is_open()) {
      const double left_ms = std::chrono::duration<double, std::milli>(deadline - Clock::now()).count();
      if (left_ms <= 0) return;
      std::array<pollfd, 2> events{pollfd{output_.reading.number(), POLLIN, 0},
                                   pollfd{errors_.reading.number(), POLLIN, 0}};
      if (poll(events.data(), events.size(), static_cast<int>(std::ceil(left_ms))) <= 0) continue;
      std::string ignored;
      if (events[0].revents != 0) take(output_.reading, ignored);
      if (events[1].revents != 0) take(errors_.reading, ignored);
    }
  }

  Pipe output_, errors_;
  Pipe wake_;  ///< closing its writing end wakes the reader
  pid_t process_ = -1;
  CommandOutcome outcome_;
};

}  // namespace

CommandOutcome run_command(const std::string& command, std::string_view input,
                           const std::vector<std::string>& variables, const std::stop_token& stop) {
  return RunningCommand(command, input, variables).run(stop);
}

}  // namespace gcs
