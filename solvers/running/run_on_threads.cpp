#include "solvers/running/run_on_threads.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <atomic>
#include <utility>

#ifdef GCS_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#else
#include <thread>
#include <vector>
#endif

namespace gcs {
namespace {

/// Frees at its end what FLINT keeps in reserve for the thread, which would be lost with the thread.
struct ThreadReserves {
  ThreadReserves() = default;
  ~ThreadReserves() { flint_cleanup(); }
  ThreadReserves(const ThreadReserves&) = delete;
  ThreadReserves& operator=(const ThreadReserves&) = delete;
};

auto leaving_nothing(const std::function<void(int)>& function) {
  return [&function](int i) {
    const ThreadReserves reserves;
    function(i);
  };
}

}  // namespace

#ifdef GCS_TBB

void run_on_threads(int count, const std::function<void(int)>& function) {
  if (count <= 0) return;
  // Beyond the cores TBB has no threads, and says so on standard error when it is asked for them.
  tbb::task_arena arena(std::min(count, tbb::info::default_concurrency()));
  arena.execute([&] { tbb::parallel_for(0, count, leaving_nothing(function), tbb::simple_partitioner()); });
}

struct Background::Threads {
  // The caller has a core of its own, and no place in the arena.
  explicit Threads(int most)
      : arena(std::clamp(most, 1, std::max(tbb::info::default_concurrency() - 1, 1)), 0) {}

  void run(int, std::function<void()> function) { arena.enqueue(group.defer(std::move(function))); }
  void wait() {
    arena.execute([this] { group.wait(); });
  }

  tbb::task_arena arena;
  tbb::task_group group;
};

#else

void run_on_threads(int count, const std::function<void(int)>& function) {
  const auto call = leaving_nothing(function);
  std::vector<std::jthread> others;
  for (int i = 1; i < count; ++i) others.emplace_back(call, i);
  if (count > 0) call(0);
}

struct Background::Threads {
  explicit Threads(int most) : all(static_cast<std::size_t>(most)) {}

  void run(int which, std::function<void()> function) {
    all[static_cast<std::size_t>(which)] = std::jthread(std::move(function));
  }
  void wait() {
    for (std::jthread& thread : all)
      if (thread.joinable()) thread.join();
  }

  std::vector<std::jthread> all;
};

#endif

Background::Background(int most) : threads_(std::make_unique<Threads>(most)) {}

Background::~Background() { wait(); }

void Background::run(int which, std::function<void()> function) {
  has_run_ = true;
  threads_->run(which, std::move(function));
}

void Background::wait() {
  if (std::exchange(has_run_, false)) threads_->wait();
}

void share_on_threads(std::size_t items, int threads, const std::function<void(std::size_t)>& function) {
  const auto count = static_cast<int>(std::min(static_cast<std::size_t>(threads), items));
  if (count <= 1) {
    for (std::size_t i = 0; i < items; ++i) function(i);
    return;
  }
  std::atomic<std::size_t> next = 0;
  run_on_threads(count, [&](int) {
    for (std::size_t i = next++; i < items; i = next++) function(i);
  });
}

}  // namespace gcs
