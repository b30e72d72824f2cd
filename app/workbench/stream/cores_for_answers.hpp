#pragma once

#include <sched.h>

namespace abrazo::app {

/// While packets are answered, Mesa's software rendering threads and the window's thread leave a quarter of
/// the processor cores alone, at least one: otherwise an answer waits for milliseconds behind a thread that
/// draws. All other threads use every core. No effect with a graphics card or on a single core.
class CoresForAnswers {
 public:
  /// Made by the window's thread. The cores that it may use by then are all there are.
  CoresForAnswers();
  ~CoresForAnswers() { keep(false); }
  CoresForAnswers(const CoresForAnswers&) = delete;
  CoresForAnswers& operator=(const CoresForAnswers&) = delete;

  /// Call it from time to time: a thread that was started meanwhile has the cores of the one that started it.
  void keep(bool wanted);
  bool are_kept() const { return are_kept_; }

 private:
  cpu_set_t all_{}, drawing_{};
  bool are_kept_ = false;
};

}  // namespace abrazo::app
