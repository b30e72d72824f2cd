#pragma once

#include <QDateTime>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/workbench/project/autosave.hpp"
#include "core/opening/opened_session.hpp"

namespace abrazo::app {

class Job;
class MainWindow;
class TakeDesk;

/// Saves and opens the project of the window with its session file, and protects it against a crash.
/// Recording and project share one file, that of the TakeDesk.
class ProjectDesk : public QObject {
  Q_OBJECT
 public:
  ProjectDesk(MainWindow& window, TakeDesk& takes);
  ~ProjectDesk() override;

  /// Sets interactive mode: asks before changes are lost and about missing files, and autosaves. Otherwise
  /// does none of these.
  void setAsks(bool on);
  /// Call before an end without dialogs: unsaved work is offered at the next start.
  void leaveChanges();

  /// Empty if the session has no file.
  QString file() const;
  bool hasTakes() const;
  bool isModified() const { return m_isModified; }
  /// Compares the present with the saved state; called on every change of the document.
  void refresh();

  /// Saves to the session's file, or asks for one.
  void save();
  void askSaveAs();
  /// Includes everything recorded. During a take it writes a copy, and the session keeps its file.
  void saveAs(const QString& file);
  bool isSaving() const { return m_job != nullptr; }

  /// Answers to "save changes?"; asked by a dialog unless a test overrides it.
  enum class Answer { Save, Discard, Cancel };
  std::function<Answer()> ask;
  /// Seconds of the history of a changed session that are in no file, if they are worth a question, else 0:
  /// one question asks about both.
  std::function<double()> unsavedHistory = [] { return 0.0; };
  /// Answers to "write the library beside it?", if the library is not a file yet.
  enum class LibraryAnswer { Write, SaveWithout, Cancel };
  std::function<LibraryAnswer()> askLibrary;

 signals:
  void saved(const QString& file);
  void notSaved(const QString& why);
  /// The frames of the session up to this time are in its file.
  void historySaved(double until_s);
  /// Unsaved work stays for the next start.
  void leftForNextStart();
  /// The session is about to end without a change that was not saved: its history is deleted. @param allowed
  /// set to false if the user cancels
  void losingHistory(bool& allowed);
  /// Name or modified state changed.
  void changed();

 private:
  void write(const QString& target);
  void onLeaving(bool& allowed);
  /// @return none: do not save; else the file for the library, empty = not written
  std::optional<std::string> libraryFileFor(const QString& target);
  void onOpened();
  void lookAtFile();
  /// @return whether it was written
  bool waitForSave();
  bool saveAndWait();
  void takeSaved(const OpenedProject& project);
  void showTitle();
  void keep();
  Project current() const;
  QString askFile();

  MainWindow& m_window;
  TakeDesk& m_takes;
  Autosave m_autosave;
  Project m_saved;
  std::optional<std::string> m_savedAt;  ///< by this window, or before it opened the file; none: unknown
  QDateTime m_fileSeen;                  ///< of which change of the file `m_savedAt` is known
  std::vector<DataReference> m_carried;  ///< references to missing files, kept until they exist again
  bool m_asks = false, m_isModified = false, m_hasSession = false;
  bool m_isAhead = false;  ///< of its file from the start: restored, or opened with files at other places
  /// The manifest for which the user chose to save without the library; asked once.
  std::optional<std::shared_ptr<const Manifest>> m_withoutLibrary;
  QString m_leftover;            ///< autosaved file from which the session was restored
  double m_framesSavedTo_s = 0;  ///< in the file are all frames up to here
  QTimer m_soon;                 ///< merges successive changes
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
