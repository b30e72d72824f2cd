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

namespace abrazo::app {

class Job;

/// One sweep after another over the takes of a library, on a thread of its own that leaves the processor to
/// whatever else wants it. Points are handed over as they are done.
class SweepRun : public QObject {
  Q_OBJECT
 public:
  explicit SweepRun(QObject* parent);
  ~SweepRun() override;

  /// Ends what runs: its takes are others'.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  /// The sweep that is asked for; an Error says what of it cannot be.
  Result<Sweep> sweepOf(const widgets::SweepRequest& request, const Settings& settings) const;
  /// Solved frames that it takes.
  double stepsOf(const Sweep& sweep, const std::vector<std::string>& takes) const;

  void start(const Sweep& sweep, const std::vector<std::string>& takes);
  void cancel();
  bool running() const { return m_job != nullptr; }
  /// Draws another figure of the same points.
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
  std::shared_ptr<const EvaluationData> m_data;  ///< of the library, once a sweep needed it
  Sweep m_sweep;
  widgets::SweepGrid m_grid;
  std::vector<Figures> m_figures;
  QElapsedTimer m_clock;
  int m_run = 0;  ///< tells points of this run from late ones of the last
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
