#pragma once

#include <QObject>
#include <memory>

#include "app/workbench/library/retarget_dialog.hpp"
#include "app/workbench/library/take_source.hpp"

namespace abrazo::app {

class Job;
class MainWindow;
class RetargetPreviewDesk;

/// Retargets recorded takes from the window: offers those of the open library and of manifests, previews them
/// while the dialog is visible, computes and writes on a worker, and reports the end.
class RetargetDesk : public QObject {
  Q_OBJECT
 public:
  explicit RetargetDesk(MainWindow& window);
  ~RetargetDesk() override;

  /// Shows the dialog with the takes of the open library; the one selected in the library panel is chosen.
  void open();
  RetargetDialog& dialog() { return *m_dialog; }
  RetargetPreviewDesk& preview() { return *m_preview; }
  bool isBusy() const { return m_job != nullptr; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void offerManifest(const QString& file);
  void start();
  TakeSource source() const;
  void showPreview();
  void run(std::function<std::function<void()>(const Progress&)> work, const QString& doing);
  void tell(const std::vector<RetargetedTake>& done, const std::vector<std::string>& warnings);
  void fail(const Error& error);

  MainWindow& m_window;
  RetargetDialog* m_dialog;
  RetargetPreviewDesk* m_preview;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
