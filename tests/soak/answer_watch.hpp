#pragma once

#include <pthread.h>

#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "tests/soak/wait_account.hpp"

namespace abrazo::soak {

/// Who draws in this process.
struct Driver {
  std::vector<std::string> libraries;  ///< beginnings of their file names
  std::string threads;                 ///< beginning of the names of the threads that draw
};

/// Mesa's, as it draws on the processor: one library in Debian 12, another from version 24 on.
Driver software_driver();

/// Sees when the thread that made it, the only one in a program, stops answering, and prints where it is
/// then. What it waited for a processor on a busy machine is told apart from what it did itself
/// (WaitAccount).
class AnswerWatch {
 public:
  using Gap = WaitAccount::Gap;

  /// @param limit_s  a gap between two beats that is longer, without the wait for a processor, is reported
  explicit AnswerWatch(double limit_s, Driver driver = software_driver());
  ~AnswerWatch();
  AnswerWatch(const AnswerWatch&) = delete;
  AnswerWatch& operator=(const AnswerWatch&) = delete;

  /// From the watched thread, often.
  Gap beat();
  /// The next gap begins now.
  void forget() { beat(); }

 private:
  void watch(const std::stop_token& stop);
  void look();
  bool is_in_driver() const;
  std::map<pid_t, double> renderers_s() const;

  Driver driver_;
  pthread_t watched_;
  std::mutex mutex_;
  WaitAccount account_;        // of the mutex
  bool is_looked_at_ = false;  // of the mutex: since the beat
  std::jthread watching_;      // last: joined first
};

}  // namespace abrazo::soak
