#include "app/workbench/takes/take_desk.hpp"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/document/session_places.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/session/edit/take_name.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/takes/countdown.hpp"
#include "widgets/takes/take_panel.hpp"
#include "widgets/takes/take_rows.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using Phase = TakeSequence::Phase;

constexpr int update_interval_ms = 100;

std::vector<widgets::TimelineTake> on_timeline(const SessionTakes& takes) {
  std::vector<widgets::TimelineTake> shown;
  for (const RecordedTake& take : takes.list().all())
    shown.push_back({take.id, take.from_s, take.to_s, take.name, take.id == takes.running()});
  return shown;
}

}  // namespace

TakeDesk::TakeDesk(MainWindow& window, widgets::TakePanel& panel)
    : QObject(&window),
      m_window(window),
      m_panel(panel),
      m_countdown(new widgets::Countdown(&window.scene())) {
  window.colour(m_countdown);
  connect(&window.document(), &Document::ending, this, &TakeDesk::onSessionEnding);
  connect(&window.document(), &Document::began, this, [this] {
    ++m_session;
    update();
  });
  connect(&window.document(), &Document::opened, this, &TakeDesk::takeFile);
  m_timer.setInterval(update_interval_ms);
  connect(&m_timer, &QTimer::timeout, this, &TakeDesk::update);
  m_timer.start();
  showTakes();
}

TakeDesk::~TakeDesk() = default;

double TakeDesk::now() const {
  return m_window.session() ? m_window.session()->engine().clock().now_s() : 0;
}

RecordingFacts TakeDesk::facts() const {
  RecordingFacts facts = m_window.session()->facts();
  facts.has_times_of_file = true;
  if (const auto receiver = m_window.session()->engine().receiver()) facts.input = receiver->uri().text;
  return facts;
}

// ---- takes ----

void TakeDesk::toggle() {
  if (!m_window.session()) return m_window.messages().showInformation("Nothing is open yet");
  if (m_sequence.phase == Phase::Idle && !hasPerformer())
    return m_window.messages().showInformation(
        "A take is recorded of a live performer: connect a stream (Ctrl+K), or Live > Play the clip as live. "
        "File > Export writes what the clip's partner does");
  if (m_sequence.phase == Phase::Idle)
    return begin(freshName(m_panel.typedName().toStdString()), m_panel.countdown());
  if (m_sequence.stop()) return endTake();
  update();
  emit cameToNothing();
}

/// A clip is solved at other times than it is shown, and after a stream nobody moves.
bool TakeDesk::hasPerformer() const {
  const Material& material = m_window.session()->material();
  return !material.is_clip() &&
         (material.use != InputUse::Stream || m_window.session()->engine().receiver() != nullptr);
}

void TakeDesk::endWithStream() {
  if (m_sequence.phase == Phase::Idle || !m_window.session() || !m_window.session()->engine().receiver())
    return;
  const QString name = QString::fromStdString(m_sequence.name);
  const bool has_begun = isRecording();
  toggle();
  if (!has_begun)
    m_window.messages().showInformation("The countdown of " + name +
                                        " was cancelled, because its stream was disconnected");
  else if (!takes().empty() && takes().all().back().name == name.toStdString())
    m_window.messages().showInformation(name + " ended, because its stream was disconnected");
}

void TakeDesk::again() {
  if (!m_window.session() || takes().empty() || !hasPerformer()) return;
  if (m_sequence.stop()) endTake();
  begin(again_name(takes().names()), 0);
}

std::string TakeDesk::freshName(const std::string& typed) const {
  return next_take_name(typed, takes().names());
}

void TakeDesk::begin(const std::string& name, double countdown_s) {
  const bool now_already = m_sequence.start(name, countdown_s, now());
  now_already ? beginTake() : update();
}

void TakeDesk::beginTake() {
  if (!record()) {
    m_sequence.stop();
    update();
    return emit cameToNothing();
  }
  m_window.session()->engine().recorder()->begin_take(m_sequence.name);
  const FrameSnapshotPtr latest = m_window.session()->engine().latest().newest();
  const auto receiver = m_window.session()->engine().receiver();
  m_takes.begin(m_sequence.name, latest ? latest->time_s : now(),
                receiver ? receiver->performers() : std::vector{m_window.session()->material().input.name});
  update();
  showTakes();
  emit begun();
}

void TakeDesk::endTake(bool stopsRecorder) {
  if (const auto recorder = m_window.session()->engine().recorder()) recorder->end_take();
  follow();
  if (stopsRecorder && (!recordsStreams() || !m_hasStream)) stopRecorder();
  const RecordedTake take = m_takes.end();
  if (take.frames == 0)
    m_window.messages().showInformation(QString::fromStdString(take.name) +
                                        " has no frames, because nothing came in; it was not kept");
  update();
  showTakes();
  take.frames == 0 ? emit cameToNothing() : emit taken(take.id);
}

void TakeDesk::follow() {
  const auto recorder = m_window.session() ? m_window.session()->engine().recorder() : nullptr;
  if (recorder) m_takes.follow(recorder->state().take_span);
}

bool TakeDesk::refusesChange() {
  if (!isReadOnly()) return false;
  m_window.messages().showError(
      QString("%1 is open in another window (%2) and read-only here; save it under another name first")
          .arg(QFileInfo(m_file).fileName(), m_hold.holder()));
  return true;
}

void TakeDesk::rename(std::int64_t id, const std::string& name) {
  if (refusesChange()) return;
  m_takes.rename(id, name);
  writeEdits();
  showTakes();
}

void TakeDesk::remove(std::int64_t id) {
  if (refusesChange()) return;
  m_takes.remove(id);
  showTakes();
}

void TakeDesk::restore(const RecordedTake& take) {
  m_takes.restore(take);
  showTakes();
}

void TakeDesk::goTo(std::int64_t id) {
  const RecordedTake* take = takes().find(id);
  if (!take) return;
  // Its times are the session's.
  if (!m_window.document().subject().empty()) m_window.requestSubject("");
  if (take->to_s > take->from_s) m_window.ticker().setRange(take->from_s, take->to_s);
  m_window.ticker().seek(take->from_s);
}

// ---- the file ----

bool TakeDesk::record() {
  SessionEngine& engine = m_window.session()->engine();
  if (engine.recorder()) return true;
  if (refusesChange()) return false;
  if (m_file.isEmpty()) {
    const QString folder = sessions_folder();
    QDir().mkpath(folder);
    m_file = new_session_file(folder, QDateTime::currentDateTime());
  }
  awaitFile();
  const Status started = engine.record(m_file.toStdString(), facts());
  m_markersInFile.reset();
  if (started) {
    m_hold.take(m_file);
    writeMarkers();
    emit fileChanged();
    return true;
  }
  m_window.messages().showError(words(started.error()));
  if (!QFileInfo::exists(m_file)) m_file.clear();
  return false;
}

/// The file is finished by a worker, as in finishFile().
void TakeDesk::stopRecorder(Afterwards afterwards) {
  if (!m_window.session()->engine().recorder()) return;
  writeMarkers();
  writeEdits();
  const auto recorder = m_window.session()->engine().release_recorder();
  m_finishing = recorder;
  m_lastState.file_bytes = recorder->state().file_bytes;
  m_lastState.behind_s = 0;
  const QString file = std::exchange(m_file, afterwards == Afterwards::Delete ? QString() : m_file);
  if (m_file.isEmpty()) m_lastState = {}, m_hold.release();
  auto* job = new Job(
      [this, recorder, file, afterwards](const Progress&) -> Job::Finish {
        const Status written = recorder->finish();
        if (afterwards == Afterwards::Delete) delete_session(file);
        return [this, recorder, file, written] {
          if (m_finishing == recorder) m_finishing.reset();
          emit fileFinished();
          if (!written) m_window.messages().showError(words(written.error()));
          if (m_file != file || m_finishing || !m_window.session()) return;
          m_lastState.file_bytes = static_cast<std::uint64_t>(QFileInfo(file).size());
          update();
        };
      },
      this);
  connect(job, &Job::finished, job, &QObject::deleteLater);
}

bool TakeDesk::isFinishingFile() const {
  return m_finishing && m_finishing->state().path == m_file.toStdString();
}

/// For the rare case that the file is needed again in the moments of its being finished.
void TakeDesk::awaitFile() {
  if (isFinishingFile()) (void)m_finishing->finish();  // its job tells the result
}

/// Names in the file follow those in the list, through the recorder while it runs.
void TakeDesk::writeEdits() {
  const TakeEdits names = m_takes.renames();
  if (names.empty() || m_file.isEmpty() || !m_window.session()) return;
  const auto recorder = m_window.session()->engine().recorder();
  if (recorder) recorder->edit_takes(names);
  if (!recorder) awaitFile();
  const Status written = recorder ? Status(Done{}) : edit_session_takes(m_file.toStdString(), names);
  if (!written) return m_window.messages().showError(words(written.error()));
  m_takes.written(names);
}

/// Those of the session, when they are not the ones in the file.
void TakeDesk::writeMarkers() {
  const auto recorder = m_window.session() ? m_window.session()->engine().recorder() : nullptr;
  if (!recorder) return;
  const Markers& markers = m_window.document().project().markers;
  if (m_markersInFile == markers) return;
  m_markersInFile = markers;
  recorder->set_markers(*m_markersInFile);
}

void TakeDesk::keepEverything(bool on) {
  m_window.remembered().setKeepsEverything(on);
  if (m_window.session() && m_hasStream) {
    if (recordsStreams()) record();
    if (!on && !isRecording()) stopRecorder();
  }
  update();
}

/// A saved file changes when it is saved again, or when a take is recorded into it.
bool TakeDesk::recordsStreams() const {
  return m_window.remembered().keepsEverything() && !m_isSaved;
}

void TakeDesk::prepareStream() {
  if (!m_window.session()) return;
  if (m_isSaved && m_window.remembered().keepsEverything())
    m_window.messages().showInformation("The stream is kept in the history; saving adds it to " +
                                        QFileInfo(m_file).fileName());
  if (!recordsStreams()) return;
  m_isForStream = m_file.isEmpty();
  m_hasStream = record();
}

bool TakeDesk::isReadyForStream() const {
  return !recordsStreams() || !isFinishingFile();
}

/// Of a stream that could not be opened nothing is left.
void TakeDesk::discardIfUnused() {
  const bool is_unused = std::exchange(m_isForStream, false) && takes().empty();
  stopRecorder(is_unused ? Afterwards::Delete : Afterwards::Keep);
}

/// The file of the session that was opened, with its takes.
void TakeDesk::takeFile() {
  const Material& material = m_window.session()->material();
  if (material.recorded) {
    m_takes = SessionTakes(material.recorded->contents);
    m_lastState = {};
    setFile(QString::fromStdString(material.recorded->file));
    showTakes();
  } else if (material.project && material.project->reading.is_saved && m_file.isEmpty() &&
             !material.project->file.empty()) {
    setFile(QString::fromStdString(material.project->file));
  }
}

void TakeDesk::setFile(const QString& file) {
  m_file = file;
  m_isSaved = true;
  m_isForStream = false;
  m_lastState.file_bytes = static_cast<std::uint64_t>(QFileInfo(file).size());
  update();
  if (!m_hold.take(file))
    m_window.messages().showWarnings(
        {QString(
             "%1 is open in another window (%2). It is read-only here: what you change can be saved under "
             "another name")
             .arg(QFileInfo(file).fileName(), m_hold.holder())});
  emit fileChanged();
}

bool TakeDesk::isReadOnly() {
  return m_hold.isOfAnother() && !m_hold.take(m_file);
}

void TakeDesk::onSessionEnding() {
  if (m_window.session()) {
    if (m_sequence.stop()) endTake(false);
    writeMarkers();
    finishFile();
  }
  m_sequence = {};
  m_takes = {};
  m_file.clear();
  m_hold.release();
  m_lastState = {};
  m_toldFailure.clear();
  m_hasStream = false;
  m_isSaved = false;
  showTakes();
}

/// On another thread: the disk may take its time, and the window does not wait for it.
void TakeDesk::finishFile() {
  if (m_file.isEmpty() || m_hold.isOfAnother()) return;
  const auto finish = [recorder = m_window.session()->engine().recorder(), earlier = m_finishing,
                       file = m_file.toStdString(), edits = m_takes.edits()] {
    if (earlier) (void)earlier->finish();  // its own job tells the result
    Status written = recorder ? recorder->finish() : Status(Done{});
    const Status edited = edit_session_takes(file, edits);
    return written ? edited : written;
  };
  auto* job = new Job(
      [this, finish](const Progress&) -> Job::Finish {
        return [this, written = finish()] {
          if (!written) m_window.messages().showError(words(written.error()));
        };
      },
      this);
  connect(job, &Job::finished, job, &QObject::deleteLater);
}

// ---- what is shown ----

void TakeDesk::update() {
  if (!m_window.session()) return m_panel.showStatus({});
  const bool has_stream = m_window.session()->engine().receiver() != nullptr;
  if (has_stream && !m_hasStream && recordsStreams()) record();
  if (!has_stream && m_hasStream && !isRecording()) discardIfUnused();
  if (has_stream) m_isForStream = false;
  m_hasStream = has_stream;
  if (m_sequence.advance(now())) beginTake();
  writeMarkers();
  if (m_takes.running() >= 0) {
    follow();
    showTakes();
  }
  const widgets::RecordingStatus shown = status();
  m_panel.showStatus(shown);
  m_countdown->showCount(shown.count, QString::fromStdString(shown.take));
  m_window.transport().showRecording(
      isRecording() ? QString::fromStdString(shown.take + " · " + widgets::duration_text(shown.elapsed_s))
                    : QString());
  const QString failure = QString::fromStdString(shown.failure);
  if (!failure.isEmpty() && failure != m_toldFailure) m_window.messages().showError(failure);
  m_toldFailure = failure;
}

widgets::RecordingStatus TakeDesk::status() const {
  widgets::RecordingStatus status;
  const auto recorder = m_window.session()->engine().recorder();
  const Recorder::State disk = recorder ? recorder->state() : m_lastState;
  status.phase = m_sequence.phase;
  status.take = m_sequence.name;
  status.count = m_sequence.count(now());
  status.elapsed_s = m_sequence.elapsed_s(now());
  status.file = m_file.toStdString();
  status.folder = sessions_folder().toStdString();
  status.bytes = disk.file_bytes;
  status.frames = disk.frames;
  status.behind_s = disk.behind_s;
  status.failure = disk.failure;
  status.lost = disk.lost;
  status.is_everything_kept = m_window.remembered().keepsEverything();
  status.can_record = m_sequence.phase != Phase::Idle || hasPerformer();
  return status;
}

void TakeDesk::showTakes() {
  m_panel.rows().setRunning(m_takes.running());
  m_panel.setTakes(takes());
  m_window.timeline().showTakes(on_timeline(m_takes));
}

}  // namespace abrazo::app
