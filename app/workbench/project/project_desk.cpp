#include "app/workbench/project/project_desk.hpp"

#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <algorithm>
#include <filesystem>

#include "app/workbench/base/job.hpp"
#include "app/workbench/document/recorded_session.hpp"
#include "app/workbench/document/session_places.hpp"
#include "app/workbench/project/project_state.hpp"
#include "app/workbench/project/relocate_dialog.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {
namespace {

constexpr int settle_ms = 500;  // with the writing, changes are on disk well within 2 s

ProjectDesk::Answer ask_person(MainWindow& window, const QString& name) {
  QMessageBox box(QMessageBox::Question, "Abrazo", "Save the changes to " + name + "?",
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window);
  box.setInformativeText(
      "Annotations, markers, settings and decisions since it was saved last are lost "
      "otherwise. What was recorded is on disk in any case.");
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

/// The whole session under another name, with the project in it; whole or not at all.
Status save_elsewhere(const std::string& from, const std::string& to, const Project& project,
                      const TakeEdits& edits) {
  namespace fs = std::filesystem;
  std::error_code trouble;
  if (fs::exists(to + "-wal", trouble))
    return Error{"another program or window is recording into this file; choose another name", to};
  const std::string partial = to + ".saving";
  fs::remove(partial, trouble);
  Status done = from.empty() || !fs::exists(from, trouble) ? Status(Done{}) : copy_session(from, partial);
  if (done) done = save_project(partial, project);
  if (done) done = edit_session_takes(partial, edits);
  if (done) {
    fs::rename(partial, to, trouble);
    if (trouble) done = Error{"cannot be written (" + trouble.message() + "); choose another folder", to};
  }
  if (!done) {
    fs::remove(partial, trouble);
    return Error{done.error().message, to};
  }
  return done;
}

}  // namespace

ProjectDesk::ProjectDesk(MainWindow& window, TakeDesk& takes)
    : QObject(&window),
      m_window(window),
      m_takes(takes),
      m_autosave(window.remembered().folder() + "/autosave") {
  setObjectName("project desk");
  ask = [this] {
    const QString name = QFileInfo(file()).fileName();
    return ask_person(m_window, name.isEmpty() ? "this session" : name);
  };
  connect(&window, &MainWindow::leaving, this, &ProjectDesk::onLeaving);
  connect(&window, &MainWindow::sessionOffered, this, &ProjectDesk::onOffered);
  connect(&window, &MainWindow::sessionStarted, this, &ProjectDesk::onSessionStarted);
  connect(&window, &MainWindow::sessionEnding, this, [this] { m_hasSession = false; });
  connect(&m_takes, &TakeDesk::fileChanged, this, &ProjectDesk::showTitle);
  connect(&m_autosave, &Autosave::failed, &window.messages(), &widgets::MessageBar::showError);
  connect(&m_autosave, &Autosave::kept, this, [this] {
    if (!m_leftover.isEmpty()) Autosave::remove(m_leftover);  // the same is now in this program's own
    m_leftover.clear();
  });
  connect(&window.document(), &Document::changed, this, &ProjectDesk::refresh);
  connect(&m_soon, &QTimer::timeout, this, &ProjectDesk::keep);
  m_soon.setSingleShot(true);
  m_soon.setInterval(settle_ms);
}

ProjectDesk::~ProjectDesk() = default;

void ProjectDesk::setAsks(bool on) {
  m_asks = on;
  refresh();
}

void ProjectDesk::leaveChanges() {
  refresh();
  if (m_asks && m_isModified) m_autosave.leave(current(), file());
  m_asks = false;
}

QString ProjectDesk::file() const {
  return m_takes.file();
}

/// With the references to files that the session was opened without, unless others took their place.
Project ProjectDesk::current() const {
  Project now = project_of(m_window);
  const auto is_library = [](const DataReference& data) {
    return data.use == DataReference::Use::Library || data.use == DataReference::Use::Manifest;
  };
  for (const DataReference& carried : m_carried) {
    const auto takes_its_place = [&](const DataReference& data) {
      return data.use == carried.use || (is_library(data) && is_library(carried));
    };
    if (std::ranges::none_of(now.data, takes_its_place)) now.data.push_back(carried);
  }
  return now;
}

void ProjectDesk::refresh() {
  if (!m_hasSession) return;
  const bool modified = m_isRestored || !is_same_work(m_window.document().project(), m_saved);
  if (modified != m_isModified) {
    m_isModified = modified;
    showTitle();
  }
  if (!m_asks) return;
  if (modified && !m_soon.isActive()) m_soon.start();
  if (!modified) m_soon.stop(), m_autosave.drop();
}

void ProjectDesk::keep() {
  if (m_hasSession && m_asks && m_isModified) m_autosave.keep(current(), file());
}

void ProjectDesk::showTitle() {
  if (!m_window.session()) return;
  const Material& material = m_window.session()->material();
  const QString name = QFileInfo(file()).completeBaseName();
  const QString input = QString::fromStdString(material.input.name);
  const QString library = QString::fromStdString(material.library->name());
  const QString what = name == input ? "with " + library : "— " + input + " with " + library;
  m_window.setWindowTitle((name.isEmpty() ? "Untitled" : name) + "[*] " + what + " — Abrazo");
  m_window.setWindowModified(m_isModified);
  emit changed();
}

// ---- saving ----

void ProjectDesk::save() {
  if (!m_hasSession) return m_window.messages().showInformation("Nothing is open yet");
  file().isEmpty() ? askSaveAs() : write(file(), false);
}

QString ProjectDesk::askFile() {
  const QString folder =
      file().isEmpty() ? m_window.remembered().lastFolder() : QFileInfo(file()).absolutePath();
  const QString name = file().isEmpty() ? "session.abrazo" : QFileInfo(file()).fileName();
  QString chosen = QFileDialog::getSaveFileName(&m_window, "Save session as", QDir(folder).filePath(name),
                                                "Sessions (*.abrazo)");
  if (!chosen.isEmpty() && QFileInfo(chosen).suffix().isEmpty()) chosen += ".abrazo";
  if (!chosen.isEmpty()) m_window.remembered().setLastFolder(QFileInfo(chosen).absolutePath());
  return chosen;
}

void ProjectDesk::askSaveAs() {
  if (!m_hasSession) return m_window.messages().showInformation("Nothing is open yet");
  if (const QString chosen = askFile(); !chosen.isEmpty()) saveAs(chosen);
}

void ProjectDesk::saveAs(const QString& chosen) {
  const bool is_same = !file().isEmpty() && QFileInfo(chosen) == QFileInfo(file());
  write(is_same ? file() : chosen, !is_same);
}

/// Written by a worker; while the file is recorded by the recorder's thread, which holds it.
void ProjectDesk::write(const QString& target, bool is_other) {
  if (m_job) return m_window.messages().showInformation("It is being saved already");
  const Project now = current();
  const std::shared_ptr<Recorder> recorder = m_window.session()->engine().recorder();
  const auto work = [now, before = m_saved, to = target.toStdString(), from = file().toStdString(), recorder,
                     edits = m_takes.edits(), is_other](const Progress&) -> Result<Project> {
    const Project complete = with_contents(now, before, to);
    Status done = Done{};
    if (is_other) {
      if (recorder) done = recorder->flush();
      if (done) done = save_elsewhere(from, to, complete, edits);
    } else if (recorder) {
      recorder->save_project(std::make_shared<const Project>(complete));
      done = recorder->flush();
    } else {
      done = save_project(to, complete);
    }
    if (!done) return done.error();
    return complete;
  };
  const auto finish = [this, now, target, is_other, recorder, session = m_takes.session(), from = file(),
                       takes = m_takes.takes()](const Result<Project>& done) {
    if (!done) {
      const QString why = QString::fromStdString(done.error().text());
      m_window.messages().showError(why);
      return emit notSaved(why);
    }
    if (m_takes.session() != session) {  // another one has begun meanwhile
      m_window.noteOpened({target});
      return emit saved(target);
    }
    const bool has_gone_on = recorder || m_window.session()->engine().recorder() || m_takes.file() != from ||
                             m_takes.takes() != takes;
    if (is_other && has_gone_on) {
      m_window.messages().showInformation("Copied to " + target + "; the session goes on in " + file());
      return emit saved(target);
    }
    if (m_takes.file() != target) m_takes.setFile(target);
    m_saved = now;
    m_saved.data = done->data;
    m_isRestored = false;
    m_window.undoStack().setClean();
    refresh();
    showTitle();
    m_window.noteOpened({target});  // among the recent ones
    emit saved(target);
  };
  m_job = std::make_unique<Job>([work, finish](const Progress& progress) -> Job::Finish {
    return [finish, done = work(progress)] { finish(done); };
  });
  connect(m_job.get(), &Job::finished, this, [this] { m_job.release()->deleteLater(); });
}

// ---- leaving ----

void ProjectDesk::onLeaving(bool& allowed) {
  if (!m_asks || !m_hasSession || !allowed) return;
  refresh();
  if (!m_isModified) return;
  const Answer answer = ask();
  if (answer == Answer::Cancel || (answer == Answer::Save && !saveAndWait())) allowed = false;
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
  if (m_job) waitForSave();  // what was changed since it began is not in it
  refresh();
  if (!m_isModified) return true;
  save();
  return m_job && waitForSave();  // no job: no name was given
}

// ---- opening ----

/// Data that is not where it was is asked for before anything is opened.
void ProjectDesk::onOffered(const QStringList& files, bool& taken) {
  if (!m_asks || files.size() != 1) return;
  taken = true;
  const std::string session = files.front().toStdString();
  const auto open = [this, files, session](const Places& places) {
    const Material now = m_window.session() ? m_window.session()->material() : Material{};
    m_window.openMaterial(
        [session, now, places](const Progress& progress) {
          return load_session(session, "", now, progress, places);
        },
        files);
  };
  Job::retire(std::move(m_reading), this);
  m_reading = std::make_unique<Job>([this, session, open](const Progress&) -> Job::Finish {
    const auto found = open_project(session, {});
    if (!found || (*found)->missing().empty()) return [open] { open({}); };  // which says what is wrong
    return [this, open, project = *found] {
      auto* dialog = new RelocateDialog(project, &m_window);
      connect(dialog, &QDialog::accepted, &m_window, [dialog, open] { open(dialog->places()); });
      dialog->open();
    };
  });
}

void ProjectDesk::onSessionStarted() {
  m_hasSession = true;
  m_isRestored = false;
  m_saved = {};
  m_carried.clear();
  m_autosave.drop();
  const auto project = m_window.session()->material().project;
  if (project) restored(*project);
  if (!m_isRestored) m_saved = project_of(m_window);
  if (project) m_saved.data = project->project().data;
  m_window.undoStack().setClean();
  m_isModified = m_isRestored;
  showTitle();
  refresh();
}

void ProjectDesk::restored(const OpenedProject& opened) {
  if (!opened.reading.is_saved) {
    if (const AnnotationBook& said = opened.project().annotations; !said.empty())
      m_window.document().openAnnotations(said);
    return;
  }
  for (const std::size_t index : opened.missing())
    if (opened.project().data[index].use != DataReference::Use::Video)
      m_carried.push_back(opened.project().data[index]);
  QStringList videos;
  for (const ProjectVideo& video : opened.project().videos) {
    const bool has_file = video.data >= 0 && static_cast<std::size_t>(video.data) < opened.found.size();
    const auto index = static_cast<std::size_t>(std::max(0, video.data));
    const std::string place = has_file ? opened.found[index].path : std::string();
    videos << QString::fromStdString(!place.empty() ? place
                                     : has_file     ? opened.project().data[index].absolute_path
                                                    : std::string());
  }
  m_window.document().open(opened.project(), videos);
  show_view(m_window, opened.project().view);
  const QString own = QString::fromStdString(opened.file);
  if (!own.isEmpty() && m_takes.file().isEmpty()) m_takes.setFile(own);
  m_isRestored = !opened.autosave.empty();
  m_leftover = QString::fromStdString(opened.autosave);
}

}  // namespace abrazo::app
