#include "app/cli/interruption.hpp"

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace abrazo::app {

namespace {

// Read by worker threads too.
std::atomic<bool> was_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");

void note_signal(int /*signal*/) {
  was_interrupted = true;
}

}  // namespace

void note_interruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction previous {};
    // What the parent has us ignore (nohup, a shell's background job) stays ignored.
    if (::sigaction(signal, nullptr, &previous) != 0 || previous.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    ::sigaction(signal, &action, nullptr);
  }
}

bool interrupted() {
  return was_interrupted;
}

}  // namespace abrazo::app
