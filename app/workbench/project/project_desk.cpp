#include "app/workbench/project/project_desk.hpp"

#include <QApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job_progress.hpp"
#include "app/workbench/project/project_state.hpp"
#include "app/workbench/project/relocate_dialog.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/session/frames/time_place.hpp"
#include "core/session/run/save_session.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {
namespace {

constexpr int settle_ms = 500;  // with the writing, changes are on disk well within 2 s

/// Takes that were captured here and are in no file.
bool has_lost_takes(const MainWindow& window) {
  const LiveSession* session = window.session();
  return session && session->material().has_unsaved_library() && !session->material().manifest;
}

/// What was made by hand and would be lost, and what is safe.
QString ending_words(const MainWindow& window, bool has_recordings, double history_s) {
  QString words = "Labels, markers, settings and decisions since the last save are lost otherwise";
  if (has_lost_takes(window)) words += ", and so are the takes of the library that were captured here";
  words += has_recordings ? ". Recorded takes are on disk." : ".";
  if (history_s > 0)
    words += QString(" Discard deletes %1 of live history, too: it was not recorded.")
                 .arg(QString::fromStdString(clock_text(history_s)));
  return words;
}

ProjectDesk::Answer ask_person(MainWindow& window, const QString& name, const QString& words) {
  QMessageBox box(QMessageBox::NoIcon, "Abrazo", "Save the changes to " + name + "?",
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window);
  box.setInformativeText(words);
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return ProjectDesk::Answer::Save;
    case QMessageBox::Discard:
      return ProjectDesk::Answer::Discard;
    default:
      return ProjectDesk::Answer::Cancel;
  }
}

ProjectDesk::LibraryAnswer ask_about_library(MainWindow& window) {
  using Answer = ProjectDesk::LibraryAnswer;
  const Material& material = window.session()->material();
  QMessageBox box(QMessageBox::NoIcon, "Abrazo",
                  QString("The library “%1” is not in a file yet. Write it beside the session?")
                      .arg(QString::fromStdString(material.library->name())),
                  QMessageBox::Cancel, &window);
  box.setInformativeText(
      material.manifest ? "Otherwise the session notes its motion files, and builds the library from them "
                          "whenever it is opened."
                        : "Otherwise it is lost when the window closes: it has takes that were captured "
                          "here.");
  QAbstractButton* write = box.addButton("Write it", QMessageBox::AcceptRole);
  QAbstractButton* without = box.addButton("Save without it", QMessageBox::DestructiveRole);
  box.exec();
  return box.clickedButton() == write     ? Answer::Write
         : box.clickedButton() == without ? Answer::SaveWithout
                                          : Answer::Cancel;
}

}  // namespace

ProjectDesk::ProjectDesk(MainWindow& window, TakeDesk& takes)
    : QObject(&window), m_window(window), m_takes(takes), m_autosave(window.remembered().autosaveFolder()) {
  setObjectName("project desk");
  ask = [this] {
    const QString name = QFileInfo(file()).fileName();
    return ask_person(m_window, name.isEmpty() ? "this session" : name,
                      ending_words(m_window, hasTakes(), unsavedHistory()));
  };
  askLibrary = [this] { return ask_about_library(m_window); };
  connect(&window, &MainWindow::leaving, this, &ProjectDesk::onLeaving);
  connect(&window.document(), &Document::opened, this, &ProjectDesk::onOpened);
  connect(&window.document(), &Document::ending, this, [this] { m_hasSession = false; });
  connect(&m_takes, &TakeDesk::fileChanged, this, &ProjectDesk::showTitle);
  connect(&m_autosave, &Autosave::failed, &window.messages(), &widgets::MessageBar::showError);
  connect(&m_autosave, &Autosave::kept, this, [this] {
    if (!m_leftover.isEmpty()) Autosave::remove(m_leftover);  // the same is now in this program's own
    m_leftover.clear();
  });
  connect(&window.document(), &Document::changed, this, &ProjectDesk::refresh);
  connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
    if (state == Qt::ApplicationActive) lookAtFile();
  });
  connect(&m_soon, &QTimer::timeout, this, &ProjectDesk::keep);
  m_soon.setSingleShot(true);
  m_soon.setInterval(settle_ms);
}

ProjectDesk::~ProjectDesk() = default;

void ProjectDesk::setAsks(bool on) {
  m_asks = on;
  m_window.setLocateMissing(on ? asking_for_places(m_window) : LocateMissing());
  refresh();
}

void ProjectDesk::leaveChanges() {
  refresh();
  if (m_asks && m_isModified) {
    m_autosave.leave(current(), file());
    emit leftForNextStart();
  }
  m_asks = false;
}

QString ProjectDesk::file() const {
  return m_takes.file();
}

/// With the references to files that the session was opened without, unless others took their place.
Project ProjectDesk::current() const {
  Project now = project_of(m_window);
  for (const DataReference& carried : m_carried)
    if (std::ranges::find(now.data, carried.use, &DataReference::use) == now.data.end())
      now.data.push_back(carried);
  return now;
}

void ProjectDesk::refresh() {
  if (!m_hasSession) return;
  const bool modified = m_isAhead || !is_same_work(m_window.document().project(), m_saved);
  if (modified != m_isModified) {
    m_isModified = modified;
    showTitle();
    lookAtFile();
  }
  if (!m_asks) return;
  if (modified && !m_soon.isActive()) m_soon.start();
  if (!modified) m_soon.stop(), m_autosave.drop();
}

/// What another window saved meanwhile is told before a person saves over it.
void ProjectDesk::lookAtFile() {
  if (!m_hasSession || file().isEmpty() || m_job || !m_savedAt || !m_window.session() ||
      m_window.session()->engine().recorder())
    return;
  const QDateTime changed = QFileInfo(file()).lastModified();
  if (changed == std::exchange(m_fileSeen, changed)) return;
  if (const std::string last = saved_at(file().toStdString()); !last.empty() && last != *m_savedAt)
    m_window.messages().showWarnings(
        {QString("%1 was saved by another window at %2. Open it again to see that, or save this one under "
                 "another name")
             .arg(QFileInfo(file()).fileName(), QString::fromStdString(last))});
}

void ProjectDesk::keep() {
  if (m_hasSession && m_asks && m_isModified) m_autosave.keep(current(), file());
}

void ProjectDesk::showTitle() {
  if (!m_window.session()) return;
  const Material& material = m_window.session()->material();
  const QString name = QFileInfo(file()).completeBaseName();
  const QString input =
      material.use == InputUse::Stream ? "live" : QString::fromStdString(material.input.name);
  const QString library = QString::fromStdString(material.library->name());
  const QString what = name == input ? "with " + library : "— " + input + " with " + library;
  const QString state = m_takes.isReadOnly() ? " (read-only)" : "";
  m_window.setWindowTitle((name.isEmpty() ? "Untitled" : name) + "[*]" + state + " " + what + " — Abrazo");
  m_window.setWindowModified(m_isModified);
  emit changed();
}

// ---- saving ----

bool ProjectDesk::hasTakes() const {
  return !m_takes.takes().empty();
}

void ProjectDesk::save() {
  if (!m_hasSession) return m_window.messages().showInformation("Nothing is open yet");
  file().isEmpty() || m_takes.isReadOnly() ? askSaveAs() : write(file());
}

QString ProjectDesk::askFile() {
  const QString folder =
      file().isEmpty() ? m_window.remembered().lastFolder() : QFileInfo(file()).absolutePath();
  const QString own = QFileInfo(file()).completeBaseName();
  const QString name = file().isEmpty()       ? "session.abrazo"
                       : m_takes.isReadOnly() ? own + " copy.abrazo"
                                              : QFileInfo(file()).fileName();
  const QString chosen = widgets::choose_new_file(&m_window, "Save session as", QDir(folder).filePath(name),
                                                  ".abrazo", "Sessions (*.abrazo)");
  if (!chosen.isEmpty()) m_window.remembered().setLastFolder(QFileInfo(chosen).absolutePath());
  return chosen;
}

void ProjectDesk::askSaveAs() {
  if (!m_hasSession) return m_window.messages().showInformation("Nothing is open yet");
  if (const QString chosen = askFile(); !chosen.isEmpty()) saveAs(chosen);
}

void ProjectDesk::saveAs(const QString& chosen) {
  const bool is_same = !file().isEmpty() && QFileInfo(chosen) == QFileInfo(file());
  write(is_same ? file() : chosen);
}

/// Without a user to ask, the manifest is kept.
std::optional<std::string> ProjectDesk::libraryFileFor(const QString& target) {
  const Material& material = m_window.session()->material();
  const bool was_asked = m_withoutLibrary && *m_withoutLibrary == material.manifest;
  if (!m_asks || !material.has_unsaved_library() || was_asked) return "";
  switch (askLibrary()) {
    case LibraryAnswer::Write:
      return library_file_beside(target.toStdString(), material.library->name());
    case LibraryAnswer::SaveWithout:
      m_withoutLibrary = material.manifest;
      return "";
    case LibraryAnswer::Cancel:
      break;
  }
  return std::nullopt;
}

/// Written by a worker; while the file is recorded by the recorder's thread, which holds it.
void ProjectDesk::write(const QString& target) {
  if (m_job) return m_window.messages().showInformation("The session is already being saved");
  if (SessionHold hold; target == file() ? m_takes.isReadOnly() : !hold.take(target)) {
    const QString why = QFileInfo(target).fileName() + " is open in another window; choose another name";
    m_window.messages().showErrorOf("save", why);
    return emit notSaved(why);
  }
  const auto library_file = libraryFileFor(target);
  if (!library_file) return;
  SessionToSave what;
  what.project = library_file->empty() ? current() : with_library_file(current(), *library_file);
  what.saved = m_saved;
  what.file = file().toStdString();
  what.to = target.toStdString();
  what.saved_at = m_savedAt;
  what.takes = m_takes.edits();
  what.recorder = m_window.session()->engine().recorder();
  const FrameHistory& history = m_window.session()->engine().history();
  const double until_s = history.span().last_s;
  RecordingFacts facts = m_takes.facts();
  facts.input = "clip:" + m_window.session()->material().input.name;  // frames of a stream name it
  // A clip is solved again when it is opened.
  if (!m_window.session()->material().is_clip())
    what.history = HistoryToSave{history.stretch(m_framesSavedTo_s, until_s), std::move(facts)};
  what.library = m_window.session()->material().library;
  what.library_file = *library_file;
  const auto finish = [this, what, target, until_s, session = m_takes.session(), from = file(),
                       takes = m_takes.takes()](const Result<SavedSession>& done) {
    if (!done) {
      const QString why = words(done.error());
      m_window.messages().showErrorOf("save", why);
      return emit notSaved(why);
    }
    if (m_takes.session() != session) {  // another one has begun meanwhile
      m_window.noteOpened({target});
      return emit saved(target);
    }
    if (done->has_history) emit historySaved(until_s);
    if (done->frames_left_out > 0)
      m_window.messages().showWarnings(
          {QString("%1 frames of the history could not be read, so they are not in %2")
               .arg(done->frames_left_out)
               .arg(target)});
    if (!what.library_file.empty()) {
      m_window.session()->setLibraryFile(what.library, what.library_file);
      m_window.messages().showInformation("The library was written to " +
                                          QString::fromStdString(what.library_file));
    }
    const bool has_gone_on = what.recorder || m_window.session()->engine().recorder() ||
                             m_takes.file() != from || m_takes.takes() != takes;
    if (target != from && has_gone_on) {
      m_window.messages().showInformation("Copied to " + target + "; the session continues in " + file());
      return emit saved(target);
    }
    if (m_takes.file() != target) m_takes.setFile(target);
    if (done->has_history) m_framesSavedTo_s = until_s;
    m_saved = what.project;
    m_saved.data = done->project.data;
    m_savedAt = done->saved_at;
    m_window.document().noteSaved(m_saved.annotations);
    m_isAhead = false;
    m_window.undoStack().setClean();
    refresh();
    showTitle();
    m_window.messages().succeed("save", "Saved as " + target, true);  // the title shows it
    m_window.noteOpened({target});                                    // among the recent ones
    emit saved(target);
  };
  m_job = std::make_unique<Job>(
      [what, finish, earlier = m_takes.finishing()](const Progress& progress) -> Job::Finish {
        if (earlier) (void)earlier->finish();  // its own job tells the result
        return [finish, done = save_session(what, progress)] { finish(done); };
      });
  show_progress(*m_job, m_window.messages());
  connect(&m_window.messages(), &widgets::MessageBar::cancelRequested, m_job.get(), &Job::cancel);
  connect(m_job.get(), &Job::finished, this, [this] { Job::retire(std::move(m_job), this); });
}

// ---- leaving ----

void ProjectDesk::onLeaving(bool& allowed) {
  if (!m_asks || !m_hasSession || !allowed) return;
  if (m_job) waitForSave();  // it reads the history, which ends with the session
  refresh();
  if (!m_isModified) return emit losingHistory(allowed);
  switch (ask()) {
    case Answer::Save:
      allowed = saveAndWait();
      if (allowed) emit losingHistory(allowed);
      return;
    case Answer::Discard:  // the history as well: the question said so
      return;
    case Answer::Cancel:
      allowed = false;
  }
}

bool ProjectDesk::waitForSave() {
  QEventLoop loop;
  bool done = false;
  connect(this, &ProjectDesk::saved, &loop, [&] { done = true, loop.quit(); });
  connect(this, &ProjectDesk::notSaved, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  return done;
}

bool ProjectDesk::saveAndWait() {
  if (m_job) waitForSave();  // later changes are not in it
  refresh();
  if (!m_isModified) return true;
  save();
  return m_job && waitForSave();  // no job: no name was given
}

// ---- opening ----

/// The session as it was opened is the saved state.
void ProjectDesk::onOpened() {
  m_hasSession = true;
  m_saved = {};
  m_carried.clear();
  m_withoutLibrary.reset();
  m_autosave.drop();
  const auto project = m_window.session()->material().project;
  const auto recorded = m_window.session()->material().recorded;
  m_framesSavedTo_s = recorded ? recorded->last_s() : 0;
  m_isAhead = project && project->is_relocated;
  if (project && project->reading.is_saved) takeSaved(*project);
  if (!m_isAhead) m_saved = project_of(m_window);
  if (project) m_saved.data = project->project().data;
  m_savedAt.reset();
  if (project && project->autosave.empty()) m_savedAt = project->reading.saved_at;
  m_window.undoStack().setClean();
  m_isModified = m_isAhead;
  showTitle();
  refresh();
}

void ProjectDesk::takeSaved(const OpenedProject& opened) {
  for (const std::size_t index : opened.missing()) {
    const DataReference& data = opened.project().data[index];
    if (data.use != DataReference::Use::Video && !is_of_library(data.use)) m_carried.push_back(data);
  }
  show_view(m_window, opened.project().view);
  m_isAhead = m_isAhead || !opened.autosave.empty();
  m_leftover = QString::fromStdString(opened.autosave);
}

}  // namespace abrazo::app
