#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "core/base/progress.hpp"
#include "core/base/thread_urgency.hpp"

namespace abrazo {

/// A value that takes long to compute, computed once on first request and shared. Thread-safe: one thread can
/// prepare it so that another need not wait.
template <typename T>
class MadeOnce {
 public:
  /// @param make may throw; the next call then tries again. If `progress` cancels, its value is dropped.
  explicit MadeOnce(std::function<T(const Progress&)> make) : make_(std::move(make)) {}

  /// Cancels prepare(); waits for steps that cannot be interrupted.
  ~MadeOnce() {
    stop_ = true;
    if (worker_.joinable()) worker_.join();
  }
  MadeOnce(const MadeOnce&) = delete;
  MadeOnce& operator=(const MadeOnce&) = delete;

  /// Computes the value if needed; waits while another thread computes it. Rethrows exceptions of `make`.
  const T& get() const {
    if (ready_) return value_;
    // Not std::call_once: on systems whose pthread_once does not support exceptions, a throw would block it
    // for ever.
    const std::scoped_lock lock(making_);
    if (!ready_) {
      value_ = make_([&](double, std::string_view) { return !stop_; });
      if (stop_) throw std::runtime_error("it was stopped");
      ready_ = true;
    }
    return value_;
  }
  /// Whether `get` would return immediately.
  bool is_ready() const { return ready_; }

  /// Computes it on a separate thread, unless that was done. @see trouble
  void prepare() const {
    const std::scoped_lock lock(preparing_);
    if (ready_ || is_preparing_ || stop_) return;
    worker_ = std::jthread([this] {
      let_others_go_first();
      std::optional<std::string> trouble;
      try {
        get();
      } catch (const std::bad_alloc&) {
        trouble = "there is not enough memory for it";
      } catch (const std::exception& failure) {
        trouble = failure.what();
      }
      const std::scoped_lock done(preparing_);
      trouble_ = std::move(trouble);
      is_preparing_ = false;
    });
    is_preparing_ = true;  // stays false if no thread could be started
  }
  /// Why prepare() failed; returned once, after which prepare() may be called again.
  std::optional<std::string> trouble() const {
    const std::scoped_lock lock(preparing_);
    return std::exchange(trouble_, std::nullopt);
  }

 private:
  std::function<T(const Progress&)> make_;
  mutable T value_{};  ///< written under `making_`, before `ready_`
  mutable std::mutex making_;
  mutable std::atomic<bool> ready_ = false;
  std::atomic<bool> stop_ = false;
  mutable std::mutex preparing_;
  mutable std::optional<std::string> trouble_;  ///< guarded by `preparing_`
  mutable bool is_preparing_ = false;           ///< guarded by `preparing_`
  mutable std::jthread worker_;                 ///< guarded by `preparing_`
};

}  // namespace abrazo
