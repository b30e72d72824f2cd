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

/// Keeps unsaved work in a file in ABRAZO_HOME/autosave, which is removed at a normal end. A lock beside it
/// identifies the owner process: a second window ignores it, and a crash releases it.
class Autosave : public QObject {
  Q_OBJECT
 public:
  explicit Autosave(const QString& folder, QObject* parent = nullptr);
  ~Autosave() override;

  /// Writes on a worker unless nothing changed; during a write the newest project waits.
  /// @param session_file file of the project; empty = never saved
  void keep(const Project& project, const QString& session_file);
  /// Removes the file: the work is saved or discarded.
  void drop();
  /// As keep(), but immediately; the file stays for the next start.
  void leave(const Project& project, const QString& session_file);
  bool isBusy() const { return m_job != nullptr; }
  const QString& file() const { return m_file; }

  /// Autosaved files of ended programs.
  static QStringList leftBehind(const QString& folder);
  /// Removes a file and its lock.
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

/// The session file of an autosaved file; empty = never saved.
QString session_of_autosave(const QString& file);

}  // namespace abrazo::app
