#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>

#include "core/base/progress.hpp"

namespace abrazo::app {

/// Something long on a thread of its own. What it returns is called on the thread this object lives in,
/// unless the job was retired or the object is gone by then. Destruction cancels and waits.
class Job : public QObject {
  Q_OBJECT
 public:
  using Finish = std::function<void()>;
  using Work = std::function<Finish(const Progress&)>;

  Job(Work work, QObject* parent = nullptr);
  ~Job() override;
  /// Asks the work to stop. It may be done before it notices: what it returns is called all the same, and
  /// says whether it ended as asked (an Error) or left a result.
  void cancel() { m_cancelled = true; }
  bool wasCancelled() const { return m_cancelled; }
  /// Where failures are reported that the work of a job did not expect, a lack of memory above all: on the
  /// thread the job lives in, in place of what it would have returned; not for a job that was cancelled.
  static void tellFailures(std::function<void(const QString&)> to);
  /// Gives up a job without waiting, and whatever it returns: it goes when its work has noticed, at the
  /// latest with `owner`.
  static void retire(std::unique_ptr<Job> job, QObject* owner);

 signals:
  void progressed(double fraction, const QString& doing);
  void finished();

 private:
  std::atomic<bool> m_cancelled = false;
  bool m_finished = false, m_retired = false;
  std::jthread m_thread;  // last: joined first
};

}  // namespace abrazo::app
