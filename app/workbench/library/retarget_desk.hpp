#pragma once

#include <QObject>
#include <memory>

#include "app/workbench/library/retarget_dialog.hpp"

namespace abrazo::app {

class Job;
class MainWindow;

/// Retargets recorded takes from the window: offers those of the open library and of manifests, computes and
/// writes on a worker, and reports the end.
class RetargetDesk : public QObject {
  Q_OBJECT
 public:
  explicit RetargetDesk(MainWindow& window);
  ~RetargetDesk() override;

  /// Shows the dialog with the takes of the open library; the one selected in the library panel is chosen.
  void open();
  RetargetDialog& dialog() { return *m_dialog; }
  bool isBusy() const { return m_job != nullptr; }

 private:
  void offerManifest(const QString& file);
  void start();
  void run(std::function<std::function<void()>(const Progress&)> work, const QString& doing);
  void tell(const std::vector<RetargetedTake>& done, const std::vector<std::string>& warnings);
  void fail(const Error& error);

  MainWindow& m_window;
  RetargetDialog* m_dialog;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
