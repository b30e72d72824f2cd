#pragma once

#include <QObject>

class QSocketNotifier;
class QWidget;

namespace abrazo::app {

class ProjectDesk;

/// Termination signals of the system (SIGTERM, SIGINT, SIGHUP) as a Qt signal on the window's thread: a
/// recording is closed and the layout saved, as by the close button. A second signal ends the program at
/// once. Only one instance at a time.
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

/// Ends the program as the close button does, without a dialog: unsaved changes are offered at the next
/// start.
void close_when_told(QWidget& window, ProjectDesk& project, const Termination& termination);

}  // namespace abrazo::app
