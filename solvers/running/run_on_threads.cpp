#include "solvers/running/run_on_threads.hpp"

#ifdef GCS_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#else
#include <thread>
#include <vector>
#endif

namespace gcs {

#ifdef GCS_TBB

void run_on_threads(int count, const std::function<void(int)>& function) {
  if (count <= 0) return;
  // Beyond the cores TBB has no threads, and says so on standard error when it is asked for them.
  tbb::task_arena arena(std::min(count, tbb::info::default_concurrency()));
  arena.execute([&] { tbb::parallel_for(0, count, function, tbb::simple_partitioner()); });
}

#else

void run_on_threads(int count, const std::function<void(int)>& function) {
  std::vector<std::jthread> others;
  for (int i = 1; i < count; ++i) others.emplace_back(function, i);
  if (count > 0) function(0);
}

#endif

}  // namespace gcs
