#include "app/cli/interruption.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace abrazo::app {

namespace {

// Read by worker threads too.
std::atomic<bool> was_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");

std::atomic<unsigned> patience_s = 0;

/// Whatever the program waits for, it does not wait for ever.
void end_anyway(int /*signal*/) {
  std::signal(SIGTERM, SIG_DFL);
  std::raise(SIGTERM);
}

void note_signal(int /*signal*/) {
  was_interrupted = true;
  ::alarm(patience_s);
}

std::atomic<int> noted_itself = 0;
// Remembered, because the signal that tells of the parent's death (PR_SET_PDEATHSIG) bears its number and
// arrives when getppid() already names another process.
std::atomic<pid_t> parent = 0;

void note_signal_of_child(int signal, siginfo_t* info, void* /*context*/) {
  note_signal(signal);
  const bool is_passed_on = info->si_code == SI_USER && info->si_pid == parent;
  if (!is_passed_on && noted_itself.fetch_add(1) > 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

void handle(const struct sigaction& action, unsigned patience = interruption_patience_s) {
  patience_s = patience;
  std::signal(SIGALRM, end_anyway);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction previous {};
    // What the parent has us ignore (nohup, a shell's background job) stays ignored.
    if (::sigaction(signal, nullptr, &previous) != 0 || previous.sa_handler == SIG_IGN) continue;
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace

void note_interruptions(unsigned patience) {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  handle(action, patience);
}

void leave_second_signal_to_child() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;
  handle(action);
}

void note_interruptions_of_child() {
  parent = ::getppid();
  struct sigaction action {};
  action.sa_sigaction = note_signal_of_child;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  handle(action);
}

bool interrupted() {
  return was_interrupted;
}

}  // namespace abrazo::app
