#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include <string>
#include <vector>

#include "core/evaluation/run/evaluate.hpp"
#include "core/evaluation/sweep/sweep.hpp"
#include "widgets/sweep/sweep_grid.hpp"
#include "widgets/sweep/sweep_request.hpp"

namespace abrazo::widgets {
class MessageBar;
}

namespace abrazo::app {

class Job;

/// Runs sweeps over the takes of a library on a separate low-priority thread. Points are passed on as they
/// are done.
class SweepRun : public QObject {
  Q_OBJECT
 public:
  explicit SweepRun(QObject* parent);
  ~SweepRun() override;

  /// Ends a running sweep, because its takes belong to another library.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  /// The requested sweep; the Error names an invalid part.
  Result<Sweep> sweepOf(const widgets::SweepRequest& request, const Settings& settings) const;
  /// Number of frames to solve.
  double stepsOf(const Sweep& sweep, const std::vector<std::string>& takes) const;

  void start(const Sweep& sweep, const std::vector<std::string>& takes);
  void cancel();
  bool running() const { return m_job != nullptr; }
  /// Shows another figure of the same points.
  void setMetric(const std::string& metric);

  const Sweep& sweep() const { return m_sweep; }
  const widgets::SweepGrid& grid() const { return m_grid; }
  SweepOutcome outcome() const { return sweep_outcome(m_sweep, m_figures); }

 signals:
  void gridChanged();
  void progressed(double fraction, const QString& words);
  void ended(const QString& words);

 private:
  void take(int run, int point, const Result<Figures>& figures);
  void end(const QString& words);
  void fill(int point);
  QString timeLeft(double fraction) const;

  std::shared_ptr<const MotionLibrary> m_library;
  std::shared_ptr<const EvaluationData> m_data;  ///< of the library, loaded by the first sweep
  Sweep m_sweep;
  widgets::SweepGrid m_grid;
  std::vector<Figures> m_figures;
  QElapsedTimer m_clock;
  int m_run = 0;  ///< distinguishes points of this run from late ones of the previous
  std::unique_ptr<Job> m_job;
};

/// Of a sweep whose window may be behind or closed meanwhile: its progress, and what it came to.
void tell_progress(SweepRun& run, widgets::MessageBar& messages);

}  // namespace abrazo::app
