#include "core/base/thread_urgency.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace abrazo {

namespace {

/// The kernel's struct sched_attr in its first version; the C library of Debian 12 does not know it.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime_ns =
      0;  ///< of SCHED_OTHER: how long it wants to run at a time; a short one goes first
  std::uint64_t deadline_ns = 0;
  std::uint64_t period_ns = 0;
};

constexpr double shortest_slice_s = 1e-4;  ///< that the kernel allows
constexpr int steps_forward = 10;          ///< of 20; each gives about 25 % more where cores are short
constexpr int steps_back = 5;

}  // namespace

void let_this_thread_go_first(double work_s) {
  if (sched_getscheduler(0) != SCHED_OTHER) return;
  SchedulingAttributes wanted;
  wanted.nice = getpriority(PRIO_PROCESS, 0);  // as it is
  wanted.runtime_ns = static_cast<std::uint64_t>(1e9 * std::max(work_s, shortest_slice_s));
  static_cast<void>(syscall(SYS_sched_setattr, 0, &wanted, 0));  // refused = as before
  setpriority(PRIO_PROCESS, 0, wanted.nice - steps_forward);     // refused to most users
}

void let_others_go_first() {
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + steps_back);
}

}  // namespace abrazo
