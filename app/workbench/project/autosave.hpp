#pragma once

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <utility>

#include "core/session/file/project.hpp"

namespace abrazo::app {

class Job;

/// Keeps what was not saved yet in a file of its own in ABRAZO_HOME/autosave, which is gone after a clean
/// end. A lock beside it says which process it belongs to: a second window leaves it alone, and after a crash
/// it is free.
class Autosave : public QObject {
  Q_OBJECT
 public:
  explicit Autosave(const QString& folder, QObject* parent = nullptr);
  ~Autosave() override;

  /// Writes it on a worker unless it is there already; while one is being written the newest waits.
  /// @param session_file  that the project belongs to; empty when it was never saved
  void keep(const Project& project, const QString& session_file);
  /// What was kept is saved, or not wanted any more.
  void drop();
  /// As keep(), at once; the file stays behind for the next start to offer.
  void leave(const Project& project, const QString& session_file);
  bool isBusy() const { return m_job != nullptr; }
  const QString& file() const { return m_file; }

  /// What programs that are gone left there.
  static QStringList leftBehind(const QString& folder);
  /// With its lock.
  static void remove(const QString& file);

 signals:
  void failed(const QString& why);
  void kept();

 private:
  void finish();
  void keepNext();
  bool prepare();

  QString m_folder, m_file;
  std::unique_ptr<QLockFile> m_lock;
  std::optional<Project> m_kept;
  std::optional<std::pair<Project, QString>> m_next;
  QString m_keptFor, m_told;
  std::unique_ptr<Job> m_job;
  bool m_dropWhenDone = false;
};

/// "Changes to waltz.abrazo of 21 Nov 14:03 were not saved: 12 annotations, 3 markers"
QString words_of_autosave(const QString& file);

/// The session file that it belongs to; empty when it was never saved.
QString session_of_autosave(const QString& file);

}  // namespace abrazo::app
