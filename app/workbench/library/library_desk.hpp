#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/library/recorded_ghost.hpp"

namespace abrazo::app {

class Job;
class LibraryBuild;
class MainWindow;

/// Connects the library browser, and the building of libraries from motion files.
class LibraryDesk : public QObject {
  Q_OBJECT
 public:
  explicit LibraryDesk(MainWindow& window);
  ~LibraryDesk() override;

  /// Shows the build dialog with these files added. Videos among them are opened with the result.
  void offer(const QStringList& files);
  /// Null if no library is being built.
  LibraryBuild* building() const { return m_build; }
  void danceWith(int take);
  void toggleVeto(int take);
  /// A session begins, or continues with another library.
  void onSession();

 private:
  void connectBrowser();
  void onPanels();
  void showRecorded(int pair, bool in_motion);
  void measure(const std::shared_ptr<const MotionLibrary>& library);

  MainWindow& m_window;
  LibraryBuild* m_build = nullptr;
  QStringList m_videos;  ///< to open with the result
  RecordedGhost m_ghost;
  std::weak_ptr<const MotionLibrary> m_measured;
  std::unique_ptr<Job> m_measuring;
};

}  // namespace abrazo::app
