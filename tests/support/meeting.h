#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <set>
#include <thread>

namespace candela::testing_support {

/// Lets callers through once `expected` different threads have come; until then the early ones wait
/// inside, so that they are there at the same time. False after a minute.
class Meeting {
 public:
  explicit Meeting(size_t expected) : expected_(expected) {}

  bool Join() {
    std::unique_lock lock(mutex_);
    threads_.insert(std::this_thread::get_id());
    changed_.notify_all();
    return changed_.wait_for(lock, std::chrono::minutes(1),
                             [&] { return threads_.size() >= expected_; });
  }

  /// Only when nobody may come any more.
  size_t ThreadsSeen() const { return threads_.size(); }

 private:
  const size_t expected_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::set<std::thread::id> threads_;
};

}  // namespace candela::testing_support
