#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <string>

#include "app/workbench/export/export_dialog.hpp"
#include "core/session/edit/recorded_takes.hpp"
#include "core/session/export/export_source.hpp"

namespace abrazo::widgets {
class OfferBar;
}

namespace abrazo::app {

class Job;
class MainWindow;

/// Exports from the window: lists what is available, writes on a worker with progress and cancel, and reports
/// the end.
class ExportDesk : public QObject {
  Q_OBJECT
 public:
  /// @param takes  the recorded takes of the session
  ExportDesk(MainWindow& window, std::function<RecordedTakes()> takes);
  ~ExportDesk() override;

  /// Available data of the running session and its library.
  ExportOffer offer() const;
  /// Writes to a file; errors are reported.
  void write(const ExportRequest& request, const QString& file);
  bool isBusy() const { return m_job != nullptr; }
  widgets::OfferBar& bar() const { return *m_bar; }

 signals:
  /// Emitted after success, failure or cancellation.
  void ended();

 private:
  using MakeSource = std::function<Result<std::unique_ptr<ExportSource>>(const Progress&)>;
  MakeSource source_of(const ExportRequest& request) const;
  RunningExport running(const ExportWish& wish) const;
  void run(const MakeSource& make, const ExportWish& wish);
  void tell(const ExportReport& done);
  void finish();

  MainWindow& m_window;
  std::function<RecordedTakes()> m_takes;
  widgets::OfferBar* m_bar;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
