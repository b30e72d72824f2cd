#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace abrazo {

/// Lets one thread sleep until a time or a notification, whichever comes first. A notification while it is
/// awake is not lost: the next wait returns immediately.
class WakeUp {
 public:
  void notify() {
    {
      const std::scoped_lock lock(mutex_);
      called_ = true;
    }
    condition_.notify_one();
  }

  /// @return whether it was notified, false after a timeout
  bool wait_until(std::chrono::steady_clock::time_point until) {
    std::unique_lock lock(mutex_);
    const bool called = condition_.wait_until(lock, until, [this] { return called_; });
    called_ = false;
    return called;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool called_ = false;
};

}  // namespace abrazo
