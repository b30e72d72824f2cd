#pragma once

#include <QObject>
#include <functional>

namespace abrazo::app {

/// Work in the background that has to end before the window can go: exists as long as it runs. The window
/// closes once there is none, and draws and answers until then. Only on the GUI thread.
class RunningWork {
 public:
  /// @param stop asks the work to end soon; called at most once per stopAll()
  explicit RunningWork(std::function<void()> stop);
  ~RunningWork();
  RunningWork(const RunningWork&) = delete;
  RunningWork& operator=(const RunningWork&) = delete;

  static bool any();
  /// Asks everything that runs to stop. `then` is called from the event loop, unless `context` is gone, once
  /// nothing runs any more; it replaces the one of an earlier call.
  static void stopAll(QObject* context, std::function<void()> then);

 private:
  std::function<void()> m_stop;
};

}  // namespace abrazo::app
