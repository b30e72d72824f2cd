#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "app/workbench/base/running_work.hpp"
#include "core/base/progress.hpp"

namespace abrazo::app {

/// A long job on a separate thread. The function it returns is called on the thread of this object, unless
/// the job was retired or destroyed, or the window closes. Destruction cancels and waits.
class Job : public QObject {
  Q_OBJECT
 public:
  using Finish = std::function<void()>;
  using Work = std::function<Finish(const Progress&)>;

  /// Threads that the work starts have its priority as well: those that go on afterwards and that others wait
  /// for must not be started by a job in the background.
  enum class Pace { Background, Prompt };

  explicit Job(Work work, QObject* parent = nullptr, Pace pace = Pace::Background);
  ~Job() override;
  /// Requests cancellation. The work may finish before it notices: its returned function is called in either
  /// case, with an Error if cancelled or the result.
  void cancel() { m_cancelled = true; }
  bool wasCancelled() const { return m_cancelled; }
  /// Sets the handler of unexpected failures of jobs, such as lack of memory: called on the thread of the job
  /// instead of its result; not for cancelled jobs.
  static void tellFailures(std::function<void(const QString&)> to);
  /// Frees a finished job, also from a handler of its signals. Abandons a running one without waiting and
  /// drops its result: it is destroyed when its work ends, at the latest with `owner`.
  static void retire(std::unique_ptr<Job> job, QObject* owner);

 signals:
  void progressed(double fraction, const QString& doing);
  void finished();

 private:
  std::atomic<bool> m_cancelled = false;
  bool m_finished = false, m_retired = false;
  std::optional<RunningWork> m_running;  ///< empty once it is finished
  std::jthread m_thread;                 // last: joined first
};

}  // namespace abrazo::app
