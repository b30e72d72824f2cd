#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/workbench/project/autosave.hpp"
#include "core/opening/file_kinds.hpp"
#include "core/opening/opened_session.hpp"

namespace abrazo::app {

class Job;
class MainWindow;
class TakeDesk;

/// The project of the window and its session file: saved, opened, kept against a crash. There is one file for
/// what is recorded and for what is worked on, that of the TakeDesk.
class ProjectDesk : public QObject {
  Q_OBJECT
 public:
  ProjectDesk(MainWindow& window, TakeDesk& takes);
  ~ProjectDesk() override;

  /// A person is there: is asked before changes are lost and where missing files are, and what was not saved
  /// is kept against a crash. Otherwise nothing of it happens.
  void setAsks(bool on);
  /// Before an end without a dialog: what was not saved is offered at the next start.
  void leaveChanges();

  /// Empty while the session has none.
  QString file() const;
  bool isModified() const { return m_isModified; }
  /// As it is now against as it was saved; with every change of the document.
  void refresh();

  /// Into the session's file, or one that is asked for.
  void save();
  void askSaveAs();
  /// It includes everything that was recorded. While a take is recorded it is a copy, and the session stays
  /// where it is.
  void saveAs(const QString& file);
  bool isSaving() const { return m_job != nullptr; }

  /// What a person answers to "save changes?"; a dialog unless a test says otherwise.
  enum class Answer { Save, Discard, Cancel };
  std::function<Answer()> ask;
  /// And to "write the library beside it?", where the library is not a file yet.
  enum class LibraryAnswer { Write, SaveWithout, Cancel };
  std::function<LibraryAnswer()> askLibrary;

 signals:
  void saved(const QString& file);
  void notSaved(const QString& why);
  /// Name or modified mark.
  void changed();

 private:
  void write(const QString& target);
  void onLeaving(bool& allowed);
  /// @return whether it is to be saved; then the file the library is written to, empty: it is not
  std::optional<std::string> libraryFileFor(const QString& target);
  void onOffered(const std::vector<FileToOpen>& files, bool& taken);
  void open(const OpenedSession& session, const QString& file, const Places& places);
  void onSessionStarted();
  /// @return whether it was written
  bool waitForSave();
  bool saveAndWait();
  void restored(const OpenedProject& project);
  void showTitle();
  void keep();
  Project current() const;
  QString askFile();

  MainWindow& m_window;
  TakeDesk& m_takes;
  Autosave m_autosave;
  Project m_saved;
  std::vector<DataReference> m_carried;  ///< opened without them; kept for when they are there again
  bool m_asks = false, m_isModified = false, m_isRestored = false, m_hasSession = false;
  /// With which manifest a person saved without writing the library; it is asked once.
  std::optional<std::shared_ptr<const Manifest>> m_withoutLibrary;
  QString m_leftover;  ///< the autosaved file that the session was restored from
  QTimer m_soon;       ///< of several changes in a row the last is kept
  std::unique_ptr<Job> m_job, m_reading;
};

}  // namespace abrazo::app
