#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/wake_up.hpp"
#include "core/session/frames/command.hpp"

namespace abrazo {

/// Commands on their way to the solver thread, in order.
class CommandQueue {
 public:
  void push(Command command) {
    {
      const std::scoped_lock lock(mutex_);
      waiting_.push_back(std::move(command));
    }
    wake_up_->notify();
  }

  /// Takes all waiting commands.
  std::vector<Command> drain() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(waiting_, {});
  }

  /// Notified of every command. Other producers for the solver thread notify it too.
  const std::shared_ptr<WakeUp>& wake_up() const { return wake_up_; }

 private:
  std::shared_ptr<WakeUp> wake_up_ = std::make_shared<WakeUp>();
  std::mutex mutex_;
  std::vector<Command> waiting_;
};

}  // namespace abrazo
