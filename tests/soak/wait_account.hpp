#pragma once

#include <sys/types.h>

#include <map>

namespace abrazo::soak {

/// Seconds for which a thread has ever run, and been ready to run without a processor. The kernel counts a
/// wait when it is over.
struct Processor {
  double ran_s = 0, starved_s = 0;
};

/// What was seen of a watched thread at one time.
struct Sight {
  double now_s = 0;
  Processor watched;
  bool is_in_driver = false;            ///< waits in a function of the graphics driver, or works there
  std::map<pid_t, double> renderers_s;  ///< of each thread of the driver: how long ever without a processor
};

/// Splits the time between two beats of a thread: what it had no processor for is told apart from what it did
/// itself. Sleep is its own, unless it waits for the graphics driver while a thread of the driver has no
/// processor; a wait for anything else is not excused, whoever starves meanwhile.
class WaitAccount {
 public:
  struct Gap {
    double whole_s = 0;    ///< since the beat before
    double starved_s = 0;  ///< of it, without a processor, its own or that of the driver it waited for
    double own_s() const { return whole_s - starved_s; }
  };

  /// Between two beats. The sleep since the last sight or beat is of the driver if this one is.
  void look(const Sight& sight);
  /// The next gap begins. The sleep since the last sight goes with that sight.
  Gap beat(const Sight& sight);

 private:
  double asleep_s(const Sight& now) const;

  Sight beat_, last_;
  std::map<pid_t, double> renderers_before_s_;  ///< at the first sight after the beat
  bool is_seen_ = false;                        ///< since the beat
  double in_driver_s_ = 0;                      ///< asleep there, since the beat
};

}  // namespace abrazo::soak
