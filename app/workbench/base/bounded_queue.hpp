#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>

namespace abrazo::app {

/// A bounded queue between two threads.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t most) : m_most(most) {}

  /// @return false if full or closed; the item is then not added
  bool push(T item) {
    {
      const std::lock_guard lock(m_mutex);
      if (m_closed || m_items.size() >= m_most) return false;
      m_items.push_back(std::move(item));
    }
    m_filled.notify_one();
    return true;
  }
  /// Waits for the next item; none once closed and empty.
  std::optional<T> pop() {
    std::unique_lock lock(m_mutex);
    m_filled.wait(lock, [this] { return m_closed || !m_items.empty(); });
    if (m_items.empty()) return std::nullopt;
    T item = std::move(m_items.front());
    m_items.pop_front();
    return item;
  }
  bool is_full() const {
    const std::lock_guard lock(m_mutex);
    return m_items.size() >= m_most;
  }
  /// Closes; remaining items can still be popped.
  void close() { shut(false); }
  /// Closes and drops the remaining items.
  void abandon() { shut(true); }

 private:
  void shut(bool empties) {
    {
      const std::lock_guard lock(m_mutex);
      m_closed = true;
      if (empties) m_items.clear();
    }
    m_filled.notify_all();
  }

  mutable std::mutex m_mutex;
  std::condition_variable m_filled;
  std::deque<T> m_items;
  std::size_t m_most;
  bool m_closed = false;
};

}  // namespace abrazo::app
