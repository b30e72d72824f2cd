#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "core/session/command.hpp"

namespace abrazo {

/// Commands on their way to the solver thread, in order.
class CommandQueue {
 public:
  void push(Command command) {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(command));
  }

  /// All that wait, leaving none.
  std::vector<Command> drain() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(waiting_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<Command> waiting_;
};

}  // namespace abrazo
