#pragma once

#include <pthread.h>

#include <map>
#include <thread>

namespace abrazo::soak {

/// Sees when the thread that made it, the only one in a program, stops answering, and prints where it is
/// then. What it waited for a processor on a busy machine is told apart from what it did itself; so is what
/// it waited for another thread of the program, such as one that renders, while that had none.
class AnswerWatch {
 public:
  /// @param limit_s  a gap between two beats that is longer, without the wait for a processor, is reported
  explicit AnswerWatch(double limit_s);
  ~AnswerWatch();
  AnswerWatch(const AnswerWatch&) = delete;
  AnswerWatch& operator=(const AnswerWatch&) = delete;

  struct Gap {
    double whole_s = 0;  ///< since the beat before
    double starved_s =
        0;  ///< of it, ready to run but without a processor, or asleep while another thread was
    double own_s() const { return whole_s - starved_s; }
  };
  /// From the watched thread, often.
  Gap beat();
  /// The next gap begins now.
  void forget() { beat(); }

 private:
  void watch(const std::stop_token& stop) const;

  /// The longest that another thread was ready to run without a processor since it was asked before.
  double others_starved_s();

  pthread_t watched_;
  std::map<pid_t, double> others_;  ///< of each other thread, how long ever
  std::jthread watching_;           // last: joined first
};

}  // namespace abrazo::soak
