#pragma once

#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <set>

#include "core/session/edit/ending_history.hpp"
#include "core/session/run/history_keeper.hpp"

namespace abrazo::app {

class Job;
class MainWindow;

/// Keeps the frames of the running session in files of a separate folder, reports what the bound removes, and
/// deletes the folder when the session ends. A lock beside the folder identifies the owner process, so that a
/// crash leaves it for the next start.
class HistoryDesk : public QObject {
  Q_OBJECT
 public:
  enum class Answer { Keep, Discard, Cancel };
  /// Less than this, without a live performer, is deleted without a question [s].
  double settles_s = history_settles_s;

  /// @param has_takes  whether the session has takes
  HistoryDesk(MainWindow& window, std::function<bool()> has_takes);
  ~HistoryDesk() override;

  /// Folder of the session's files; empty = history is in memory only, or its files are still being made.
  const QString& folder() const { return m_folder; }
  /// The files stay for the next start.
  void leave() { m_isLeft = true; }
  /// Length of the history that is in no session file, if a person has to be asked about it, else 0 [s].
  /// @param has_changes  the project has unsaved changes
  double unsaved(bool has_changes) const;
  /// A session without unsaved changes is about to end: asks whether to keep its history, if that is not to
  /// be deleted without a question. @param allowed  set to false if the user cancels
  void leaveSession(bool& allowed);
  /// The frames up to this time are in a session file.
  void noteSaved(double until_s) { m_savedTo_s = until_s; }
  /// The question; replaced by tests. @param seconds  of the history that is in no session file
  std::function<Answer(double seconds)> ask;
  /// Asks for the bound.
  void askBound();
  /// @param gigabytes 0 = in memory only, from the next session on
  void setBound(double gigabytes);
  /// Checks whether the bound removed frames or the disk refuses data; called once a second.
  void look();

  /// The newest session file of each history that a crash left behind.
  static QStringList leftBehind(const QString& folder);
  /// Moves the files of such a history to the sessions. @return the newest; empty if it cannot be moved
  static QString adopt(const QString& file);
  static void discard(const QString& file);

 private:
  struct Files;
  void begin();
  void take(Files& files);
  void end();
  QString lostMarkers(double first_s);
  double bound() const;
  bool isDemo() const;

  MainWindow& m_window;
  std::function<bool()> m_hasTakes;
  QTimer m_timer;
  QString m_folder, m_toldFailure;
  std::unique_ptr<QLockFile> m_lock;
  std::shared_ptr<HistoryKeeper> m_keeper;
  std::unique_ptr<Job> m_opening;
  std::set<int> m_toldMarkers;
  double m_savedTo_s = 0;
  bool m_isToldBound = false, m_isLeft = false;
  bool m_hadStream = false;
};

}  // namespace abrazo::app
