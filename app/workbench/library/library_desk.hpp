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

/// What the library browser shows and asks for, and the building of libraries from motion files.
class LibraryDesk : public QObject {
  Q_OBJECT
 public:
  explicit LibraryDesk(MainWindow& window);
  ~LibraryDesk() override;

  /// The dialog, with these files added to what it has. Videos among them are opened with what comes of it.
  void offer(const QStringList& files);
  /// Null while no library is being built.
  LibraryBuild* building() const { return m_build; }
  void danceWith(int take);
  void toggleVeto(int take);
  /// A session begins, or goes on with another library.
  void onSession();

 private:
  void connectBrowser();
  void onPanels();
  void showRecorded(int pair, bool in_motion);
  void measure(const std::shared_ptr<const MotionLibrary>& library);

  MainWindow& m_window;
  LibraryBuild* m_build = nullptr;
  QStringList m_videos;  ///< offered beside what is built
  RecordedGhost m_ghost;
  std::weak_ptr<const MotionLibrary> m_measured;
  std::unique_ptr<Job> m_measuring;
};

}  // namespace abrazo::app
