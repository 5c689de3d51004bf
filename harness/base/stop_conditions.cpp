#include "harness/base/stop_conditions.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <system_error>

namespace gcs {

namespace {

using Clock = std::chrono::steady_clock;

/// Written by the signal handler and never emptied, so that every watch sees it, later ones included.
std::array<int, 2> interrupt_pipe{-1, -1};

extern "C" void remember_interrupt(int) {
  const int saved = errno;
  const char byte = 0;
  // The pipe cannot be full: the handler runs once per signal and then resets itself.
  [[maybe_unused]] const auto written = write(interrupt_pipe[1], &byte, 1);
  errno = saved;
}

/// Milliseconds for poll: rounded up so that it does not wake too early and spin; −1 waits for ever.
int poll_timeout(std::optional<Clock::time_point> deadline) {
  if (!deadline) return -1;
  const std::chrono::duration<double, std::milli> left = *deadline - Clock::now();
  return static_cast<int>(std::clamp(std::ceil(left.count()), 0.0, 1e9));
}

/// A limit of a century is none, and would overflow the clock.
std::optional<Clock::time_point> deadline_after(std::optional<double> seconds) {
  if (!seconds || *seconds > 3e9) return std::nullopt;
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
}

}  // namespace

void catch_interrupts() {
  if (interrupt_pipe[0] >= 0) return;
  if (pipe2(interrupt_pipe.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  struct sigaction action = {};
  action.sa_handler = remember_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  pollfd readable{interrupt_pipe[0], POLLIN, 0};
  return interrupt_pipe[0] >= 0 && poll(&readable, 1, 0) == 1;
}

StopWatch::StopWatch(std::optional<double> time_limit_s) {
  if (pipe2(end_of_watch_, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  thread_ = std::thread([this, time_limit_s] { watch(time_limit_s); });
}

StopWatch::~StopWatch() {
  close(end_of_watch_[1]);
  thread_.join();
  close(end_of_watch_[0]);
}

void StopWatch::watch(std::optional<double> time_limit_s) {
  const auto deadline = deadline_after(time_limit_s);
  std::array<pollfd, 2> events{pollfd{end_of_watch_[0], POLLIN, 0}, pollfd{interrupt_pipe[0], POLLIN, 0}};
  int ready = -1;
  do {
    ready = poll(events.data(), events.size(), poll_timeout(deadline));
  } while ((ready < 0 && errno == EINTR) || (ready == 0 && (!deadline || Clock::now() < *deadline)));
  if (events[0].revents != 0) return;
  cause_ = events[1].revents != 0 ? Cause::interrupt : Cause::time_limit;
  source_.request_stop();
}

}  // namespace gcs
