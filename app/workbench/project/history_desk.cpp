#include "app/workbench/project/history_desk.hpp"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QUuid>
#include <algorithm>
#include <utility>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/document/session_places.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/text.hpp"
#include "core/session/frames/time_place.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/takes/recording_status.hpp"
#include "widgets/timeline/quick_entry.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

constexpr int look_ms = 1000;
constexpr double gigabyte = 1024.0 * 1024 * 1024;
constexpr double least_lost_s = 0.5;  // what came before the first frame is not lost
constexpr double least_bound = 0.1, most_bound = 10000;
const QPoint above_the_transport(150, 0);

QString lock_beside(const QString& folder) {
  return folder + ".lock";
}

QString clock_words(double time_s) {
  return QString::fromStdString(clock_text(time_s));
}

/// Oldest first.
QFileInfoList parts_in(const QString& folder) {
  return QDir(folder).entryInfoList({"*.abrazo"}, QDir::Files, QDir::Time | QDir::Reversed);
}

HistoryDesk::Answer ask_about_history(MainWindow& window, double seconds, std::uint64_t bytes) {
  QMessageBox box(QMessageBox::NoIcon, "Abrazo",
                  QString("Keep %1 of live history (%2)?")
                      .arg(clock_words(seconds))
                      .arg(QString::fromStdString(widgets::disk_size_text(bytes))),
                  QMessageBox::Cancel, &window);
  box.setInformativeText(
      "It was not recorded. Kept, it is offered as a session at the next start; labels and settings are "
      "saved.");
  QAbstractButton* keep = box.addButton("Keep", QMessageBox::AcceptRole);
  QAbstractButton* discard = box.addButton("Delete", QMessageBox::DestructiveRole);
  box.exec();
  return box.clickedButton() == keep      ? HistoryDesk::Answer::Keep
         : box.clickedButton() == discard ? HistoryDesk::Answer::Discard
                                          : HistoryDesk::Answer::Cancel;
}

}  // namespace

/// What a worker made for a session. Of a session that ended meanwhile it goes.
struct HistoryDesk::Files {
  QString folder;
  std::unique_ptr<QLockFile> lock;
  std::shared_ptr<HistoryKeeper> keeper;

  ~Files() {
    if (keeper) keeper->remove();
  }

  /// @return why there are none; then nothing is left
  Status open(const QString& parent, const RecordingFacts& facts, const HistoryBound& limit) {
    QDir().mkpath(parent);
    folder = parent + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces);
    lock = std::make_unique<QLockFile>(lock_beside(folder));
    lock->setStaleLockTime(0);
    if (!lock->tryLock(0)) return Error{"nothing can be written", parent.toStdString()};
    auto opened = HistoryKeeper::open(folder.toStdString(), facts, limit);
    if (!opened) return opened.error();
    keeper = std::move(*opened);
    return Done{};
  }
};

HistoryDesk::HistoryDesk(MainWindow& window, std::function<bool()> has_takes)
    : QObject(&window), m_window(window), m_hasTakes(std::move(has_takes)) {
  setObjectName("history desk");
  connect(&window.document(), &Document::began, this, &HistoryDesk::begin);
  connect(&window.document(), &Document::ending, this, &HistoryDesk::end);
  connect(&m_timer, &QTimer::timeout, this, &HistoryDesk::look);
  ask = [this](double seconds) {
    std::uint64_t bytes = 0;
    for (const QFileInfo& part : parts_in(m_folder)) bytes += static_cast<std::uint64_t>(part.size());
    return ask_about_history(m_window, seconds, bytes);
  };
  m_timer.start(look_ms);
}

HistoryDesk::~HistoryDesk() = default;

double HistoryDesk::bound() const {
  return m_window.remembered().historyBound();
}

void HistoryDesk::begin() {
  m_toldMarkers.clear();
  m_toldFailure.clear();
  m_isToldBound = false;
  m_hadStream = false;
  const auto recorded = m_window.session()->material().recorded;
  m_savedTo_s = recorded ? recorded->last_s() : 0;
  m_window.timeline().showLost({});
  if (bound() <= 0 || m_window.session()->material().is_clip()) return;  // of a clip nothing comes to be
  const HistoryBound limit{.bytes = static_cast<std::uint64_t>(bound() * gigabyte)};
  // On another thread: the first page of a file is on the disk before it counts as made. Until then frames
  // are in memory, and the files get them all.
  // Not in the background: the threads that write go on.
  m_opening = std::make_unique<Job>(
      [this, parent = m_window.remembered().historyFolder(), facts = m_window.session()->facts(),
       limit](const Progress&) -> Job::Finish {
        auto files = std::make_shared<Files>();
        const Status opened = files->open(parent, facts, limit);
        return [this, files, opened] {
          opened
              ? take(*files)
              : m_window.messages().showError("The history is kept in memory only: " + words(opened.error()));
        };
      },
      nullptr, Job::Pace::Prompt);
  connect(m_opening.get(), &Job::finished, this, [this] { Job::retire(std::move(m_opening), this); });
}

void HistoryDesk::take(Files& files) {
  m_folder = files.folder;
  m_lock = std::move(files.lock);
  m_keeper = std::move(files.keeper);
  m_window.session()->engine().keep_history(m_keeper);
}

bool HistoryDesk::isDemo() const {
  const Material& material = m_window.session()->material();
  return material.is_generated && !material.project && !material.recorded && material.reading.file.empty() &&
         !m_hadStream && !m_window.session()->engine().receiver();
}

double HistoryDesk::unsaved(bool has_changes) const {
  if (!m_window.session() || !m_keeper) return 0;
  const auto span = m_window.session()->engine().history().span();
  const FrameSnapshotPtr newest = m_window.session()->latest().newest();
  const double rate_hz = newest ? newest->input_rate_hz : 0;
  const auto frames = static_cast<double>(span.frames + span.stored);
  const Playback& playback = m_window.ticker().playback();
  EndingHistory history;
  // The time while an input was held has no frames.
  history.unsaved_s =
      std::min(m_keeper->kept_after_s(m_savedTo_s), rate_hz > 0 ? frames / rate_hz : span.last_s);
  history.performed_s = m_keeper->performed_after_s(m_savedTo_s);
  history.is_demo = isDemo();
  history.is_touched = has_changes || m_hasTakes() || playback.in_set || playback.out_set;
  return asks_before_deleting(history, settles_s) ? history.unsaved_s : 0;
}

void HistoryDesk::leaveSession(bool& allowed) {
  const double seconds = unsaved(false);
  if (seconds <= 0) return;
  const Answer answer = ask(seconds);
  m_isLeft = answer == Answer::Keep;
  allowed = answer != Answer::Cancel;
}

void HistoryDesk::end() {
  Job::retire(std::move(m_opening), this);
  if (m_keeper && !std::exchange(m_isLeft, false)) {
    // On another thread: gigabytes are not gone in a moment. The lock stays as long as there are files.
    Job::retire(std::make_unique<Job>([keeper = m_keeper, lock = std::shared_ptr<QLockFile>(std::move(
                                                              m_lock))](const Progress&) -> Job::Finish {
                  keeper->remove();
                  lock->unlock();
                  return {};
                }),
                this);
  }
  m_keeper.reset();
  m_lock.reset();
  m_folder.clear();
}

void HistoryDesk::look() {
  if (!m_window.session()) return;
  m_hadStream = m_hadStream || m_window.session()->engine().receiver();
  const auto span = m_window.session()->engine().history().span();
  const HistoryKeeper::State state = m_keeper ? m_keeper->state() : HistoryKeeper::State();
  const QString failure = QString::fromStdString(state.failure);
  if (!failure.isEmpty() && failure != m_toldFailure)
    m_window.messages().showError("The history is not on disk any more: " + failure);
  m_toldFailure = failure;
  // Frames that are still in memory are not lost, even if the bound removed them on disk.
  const bool is_cut = span.first_s > least_lost_s && (m_keeper ? state.removed_files > 0 : span.evicted > 0);
  if (!is_cut) return;
  const QString bound =
      m_keeper ? QString("%1 GB on disk").arg(static_cast<double>(state.bound) / gigabyte, 0, 'g', 3)
               : QString("%1 MB in memory").arg(static_cast<double>(span.bytes) / (1 << 20), 0, 'f', 0);
  m_window.timeline().showLost("limit reached: " + bound);
  const QString markers = lostMarkers(span.first_s);
  const QString told =
      std::exchange(m_isToldBound, true)
          ? QString()
          : QString(
                "The history has reached its limit of %1: what came before %2 is no longer kept. "
                "Timeline > History on disk… changes the limit; a recording keeps everything. ")
                .arg(bound, clock_words(span.first_s));
  if (!markers.isEmpty()) return m_window.messages().showError(told + markers);
  if (!told.isEmpty()) m_window.messages().showInformation(told.trimmed());
}

/// Those that were not reported before.
QString HistoryDesk::lostMarkers(double first_s) {
  QStringList lost;
  for (const Marker& marker : m_window.document().project().markers.all()) {
    if (marker.time_s >= first_s || !m_toldMarkers.insert(marker.id).second) continue;
    lost << QString("%1 at %2").arg(QString::fromStdString(marker_title(marker)), clock_words(marker.time_s));
  }
  if (lost.isEmpty()) return {};
  return QString("%1 in the part of the history that is no longer kept: %2")
      .arg(lost.size() == 1 ? "One marker is" : "Markers are", lost.join(", "));
}

void HistoryDesk::askBound() {
  widgets::QuickEntry::open(
      m_window.transport(), above_the_transport,
      "History on disk, GB; the oldest is removed above it. 0: in memory only (512 MB)",
      QString::number(bound()), [this](const QString& text) -> QString {
        const auto wanted = parse_number(text.trimmed().toStdString());
        if (!wanted || (*wanted != 0 && (*wanted < least_bound || *wanted > most_bound)))
          return "'" + text + "' is not a valid limit; enter gigabytes from 0.1 to 10000, or 0";
        setBound(*wanted);
        return {};
      });
}

void HistoryDesk::setBound(double gigabytes) {
  m_window.remembered().setHistoryBound(gigabytes);
  if (m_keeper && gigabytes > 0) return m_keeper->set_bound(static_cast<std::uint64_t>(gigabytes * gigabyte));
  if (m_keeper || gigabytes > 0)
    m_window.messages().showInformation("The new limit applies from the next session on");
}

QStringList HistoryDesk::leftBehind(const QString& folder) {
  QStringList files;
  for (const QFileInfo& each : QDir(folder).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    QLockFile lock(lock_beside(each.absoluteFilePath()));
    lock.setStaleLockTime(0);
    const QFileInfoList parts = parts_in(each.absoluteFilePath());
    if (!parts.isEmpty() && lock.tryLock(0)) files << parts.back().absoluteFilePath();
  }
  return files;
}

QString HistoryDesk::adopt(const QString& file) {
  const QString folder = QFileInfo(file).absolutePath();
  QDir().mkpath(sessions_folder());
  QString newest;
  for (const QFileInfo& part : parts_in(folder)) {
    const QString to = new_session_file(sessions_folder(), part.lastModified());
    if (!rename_session(part.absoluteFilePath(), to)) return {};
    newest = to;
  }
  QDir().rmdir(folder);
  QFile::remove(lock_beside(folder));
  return newest;
}

void HistoryDesk::discard(const QString& file) {
  const QString folder = QFileInfo(file).absolutePath();
  QDir(folder).removeRecursively();
  QFile::remove(lock_beside(folder));
}

}  // namespace abrazo::app
