// The one file that knows the threading library. The thread sanitizer reports false races inside
// oneTBB, so its build runs the loops on std::thread.
#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/check.h"

#ifdef CANDELA_THREADS_STD
namespace candela::pool {
void SetLimit(int) {}
/// Calls `work` on `count` threads, this one included.
void Run(int count, const std::function<void()>& work) {
  std::vector<std::thread> helpers;
  for (int i = 1; i < count; ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
}
}  // namespace candela::pool
#else
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace candela::pool {
// oneTBB makes no more threads than it sees processors unless global_control says so.
std::unique_ptr<tbb::global_control> control;
/// Kept from loop to loop, since setting one up takes longer than many a loop. Without a limit it
/// has as many threads as there are processors.
std::optional<tbb::task_arena> arena{std::in_place};

void SetLimit(int count) {
  control.reset();
  arena.emplace();
  if (count > 0) {
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<size_t>(count));
    arena.emplace(count);
  }
}
void Run(int count, const std::function<void()>& work) {
  arena->execute([&] {
    tbb::task_group helpers;
    for (int i = 1; i < count; ++i) helpers.run(work);
    work();
    helpers.wait();
  });
}
}  // namespace candela::pool
#endif

namespace candela {
namespace {

int thread_limit = 0;  // 0: one per processor

}  // namespace

ThreadLimit::ThreadLimit(int count) {
  CHECK(count >= 0 && thread_limit == 0);
  thread_limit = count;
  pool::SetLimit(count);
}

ThreadLimit::~ThreadLimit() {
  thread_limit = 0;
  pool::SetLimit(0);
}

int ThreadCount() {
  if (thread_limit > 0) return thread_limit;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void ParallelFor(int64_t count, const std::function<void(int64_t)>& body) {
  ParallelForWorkers(count, [&](int64_t i, int) { body(i); });
}

void ParallelForWorkers(int64_t count, const std::function<void(int64_t, int)>& body) {
  const int workers = static_cast<int>(std::min<int64_t>(ThreadCount(), count));
  if (workers <= 0) return;
  std::atomic<int64_t> next = 0;
  std::atomic<int> next_worker = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  // Each worker takes the next index until none is left, so uneven work balances by itself.
  const auto work = [&] {
    const int worker = next_worker++;
    try {
      for (int64_t i = next++; i < count; i = next++) body(i, worker);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  if (workers == 1) {
    work();
  } else {
    pool::Run(workers, work);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace candela
