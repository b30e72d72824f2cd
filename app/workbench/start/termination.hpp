#pragma once

#include <QObject>

class QSocketNotifier;

namespace abrazo::app {

class MainWindow;
class ProjectDesk;

/// The wish of the system that the program ends (SIGTERM, SIGINT, SIGHUP), as a signal of the window's
/// thread: a recording is closed and the layout kept, as by the close button. A second wish ends the program
/// at once. One at a time.
class Termination : public QObject {
  Q_OBJECT
 public:
  explicit Termination(QObject* parent = nullptr);
  ~Termination() override;

 signals:
  void requested();

 private:
  QSocketNotifier* m_notifier = nullptr;
};

/// Ends the program as the close button does, without a dialog: changes that were not saved are
/// kept for the next start to offer.
void close_when_told(MainWindow& window, ProjectDesk& project, const Termination& termination);

}  // namespace abrazo::app
