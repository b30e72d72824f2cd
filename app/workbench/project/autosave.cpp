#include "app/workbench/project/autosave.hpp"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTimer>
#include <QUuid>
#include <optional>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/base/range_words.hpp"
#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/document/session_places.hpp"
#include "core/opening/opened_session.hpp"

namespace abrazo::app {
namespace {

constexpr int retry_ms = 500;

QString lock_of(const QString& file) {
  return file.left(file.size() - QString(".abrazo").size()) + ".lock";
}

/// What was kept there; nothing when it cannot be read.
std::optional<OpenedProject> kept_in(const QString& file) {
  auto reading = read_project(file.toStdString());
  if (!reading) return std::nullopt;
  return located(file.toStdString(), std::move(*reading), {}, UserSettings().autosaveFolder().toStdString());
}

}  // namespace

Autosave::Autosave(const QString& folder, QObject* parent) : QObject(parent), m_folder(folder) {}

Autosave::~Autosave() {
  finish();
}

/// The file gets its name and lock when there is work to keep.
bool Autosave::prepare() {
  if (m_lock) return true;
  QDir().mkpath(m_folder);
  const QString id = QUuid::createUuid().toString(QUuid::WithoutBraces);
  auto lock = std::make_unique<QLockFile>(m_folder + "/" + id + ".lock");
  lock->setStaleLockTime(0);
  if (!lock->tryLock(0)) return false;
  m_lock = std::move(lock);
  m_file = m_folder + "/" + id + ".abrazo";
  return true;
}

void Autosave::keep(const Project& project, const QString& session_file) {
  m_dropWhenDone = false;
  if (m_job) return void(m_next.emplace(project, session_file));
  if (m_kept && is_same_work(*m_kept, project) && m_keptFor == session_file) return;
  if (!prepare()) {
    if (m_told.isEmpty()) emit failed(m_told = m_folder + ": changes cannot be kept there; save often");
    return;
  }
  m_kept = project;
  m_keptFor = session_file;
  Project next = project;
  next.view[autosaved_key] = session_file.toStdString();
  m_job = std::make_unique<Job>([this, next = std::move(next), file = m_file.toStdString()](const Progress&) {
    const Status saved = save_project(file, next);
    return Job::Finish([this, why = saved ? QString() : words(saved.error())] {
      if (why.isEmpty()) return m_dropWhenDone ? void() : emit kept();
      if (!m_next) m_next.emplace(*m_kept, m_keptFor);  // the disk may have room again
      m_kept.reset();
      if (why != m_told) emit failed(m_told = why);
    });
  });
  connect(m_job.get(), &Job::finished, this, [this] {
    Job::retire(std::move(m_job), this);
    if (m_dropWhenDone) return finish();
    if (m_next) QTimer::singleShot(m_kept ? 0 : retry_ms, this, &Autosave::keepNext);
  });
}

void Autosave::keepNext() {
  if (const auto waiting = std::exchange(m_next, std::nullopt)) keep(waiting->first, waiting->second);
}

void Autosave::drop() {
  m_dropWhenDone = true;
  if (!m_job) finish();
}

void Autosave::leave(const Project& project, const QString& session_file) {
  m_next.reset();
  m_job.reset();  // waits for a write under way
  keep(project, session_file);
  m_job.reset();
  m_lock.reset();
}

void Autosave::finish() {
  m_job.reset();  // waits for a write under way
  m_next.reset();
  m_kept.reset();
  if (m_lock) delete_session(m_file);
  m_lock.reset();  // removes its own file, and complains where that is gone
}

QStringList Autosave::leftBehind(const QString& folder) {
  QStringList files;
  for (const QFileInfo& each : QDir(folder).entryInfoList({"*.abrazo"}, QDir::Files, QDir::Time)) {
    QLockFile lock(lock_of(each.absoluteFilePath()));
    lock.setStaleLockTime(0);
    if (lock.tryLock(0)) files << each.absoluteFilePath();  // its owner is gone
  }
  return files;
}

void Autosave::remove(const QString& file) {
  delete_session(file);
  QFile::remove(lock_of(file));
}

QString session_of_autosave(const QString& file) {
  const auto kept = kept_in(file);
  return kept ? QString::fromStdString(kept->file) : QString();
}

QString words_of_autosave(const QString& file) {
  const auto kept = kept_in(file);
  if (!kept) return {};
  const Project& project = kept->project();
  std::size_t annotations = 0;
  for (const auto& [subject, said] : project.annotations)
    for (const AnnotationTier& tier : said.tiers()) annotations += tier.annotations.size();
  QStringList holds{counted(annotations, "annotation"), counted(project.markers.all().size(), "marker")};
  if (!project.videos.empty()) holds << counted(project.videos.size(), "video");
  const QString of = QFileInfo(QString::fromStdString(kept->file)).fileName();
  return QString("Changes to %1 of %2 were not saved: %3")
      .arg(of.isEmpty() ? "an untitled session" : of,
           QFileInfo(file).lastModified().toString("d MMM HH:mm:ss"), holds.join(", "));
}

}  // namespace abrazo::app
