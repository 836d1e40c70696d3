#pragma once

#include <cstdint>
#include <functional>

namespace candela {

/// The number of threads that parallel loops use while this object lives. Results never depend on
/// it. At most one object at a time.
class ThreadLimit {
 public:
  /// `count` threads, also more than the machine has processors; 0 for one per processor.
  explicit ThreadLimit(int count);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
};

/// Threads that a parallel loop would use now.
int ThreadCount();

/// Calls `body(i)` for each i in [0, count), on several threads and in any order; returns when all
/// are done. The number of concurrent calls is at most `ThreadCount()`. An exception of the body is
/// passed on.
void ParallelFor(int64_t count, const std::function<void(int64_t)>& body);

/// The same for bodies that need something of their own per thread: calls `body(i, worker)` where
/// two calls that run at the same time have different `worker` numbers below `ThreadCount()`.
void ParallelForWorkers(int64_t count, const std::function<void(int64_t, int)>& body);

}  // namespace candela
