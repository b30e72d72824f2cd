#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace abrazo {

/// Passes the newest value from one thread to another. Publishing never waits for the reader; older values
/// are dropped.
template <typename T>
class LatestSlot {
 public:
  void publish(std::shared_ptr<const T> value) {
    {
      const std::scoped_lock lock(mutex_);
      value_.swap(value);
      ++version_;
    }  // the replaced value is destroyed here, outside the lock
  }

  /// The newest value if it is newer than `seen_version`, which is then updated; otherwise null.
  std::shared_ptr<const T> take_if_newer(std::uint64_t& seen_version) const {
    const std::scoped_lock lock(mutex_);
    if (version_ == seen_version) return nullptr;
    seen_version = version_;
    return value_;
  }

  std::shared_ptr<const T> newest() const {
    const std::scoped_lock lock(mutex_);
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> value_;
  std::uint64_t version_ = 0;
};

}  // namespace abrazo
