#include "app/workbench/start/termination.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <QApplication>
#include <QSocketNotifier>
#include <QWidget>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

#include "app/workbench/project/project_desk.hpp"

namespace abrazo::app {
namespace {

/// Written by the signal handler, which may do nothing else; -1 = no reader.
std::atomic<int> write_end = -1;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait");

constexpr unsigned patience_s = 30;

/// Whatever keeps the window from hearing the request, the program does not stay for ever.
void end_anyway(int /*signal*/) {
  ::signal(SIGTERM, SIG_DFL);
  ::raise(SIGTERM);
}

void pass_on(int /*signal*/) {
  const int error = errno;
  ::alarm(patience_s);
  const char wish = 1;
  // A full pipe already contains a request.
  [[maybe_unused]] const auto written = ::write(write_end.load(), &wish, 1);
  errno = error;
}

}  // namespace

Termination::Termination(QObject* parent) : QObject(parent) {
  std::array<int, 2> pipe{};
  if (write_end.load() >= 0 || ::pipe2(pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;
  write_end = pipe[1];
  m_notifier = new QSocketNotifier(pipe[0], QSocketNotifier::Read, this);
  connect(m_notifier, &QSocketNotifier::activated, this, [this, read_end = pipe[0]] {
    char wish = 0;
    while (::read(read_end, &wish, 1) > 0) continue;
    emit requested();
  });
  ::signal(SIGALRM, end_anyway);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    struct sigaction previous {};
    // What the parent has us ignore (nohup, a shell's background job) stays ignored.
    if (::sigaction(signal, nullptr, &previous) != 0 || previous.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = pass_on;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    ::sigaction(signal, &action, nullptr);
  }
}

Termination::~Termination() {
  if (!m_notifier) return;
  ::alarm(0);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    struct sigaction ours {};
    if (::sigaction(signal, nullptr, &ours) == 0 && ours.sa_handler == pass_on) ::signal(signal, SIG_DFL);
  }
  ::close(static_cast<int>(m_notifier->socket()));
  ::close(write_end.exchange(-1));
}

void close_when_told(QWidget& window, ProjectDesk& project, const Termination& termination) {
  QObject::connect(&termination, &Termination::requested, &window, [&window, &project] {
    project.leaveChanges();
    window.close();
    // Where work is still being stopped, the window closes after it and ends the program.
    if (!window.isVisible()) QApplication::quit();
  });
}

}  // namespace abrazo::app
