#include "app/workbench/video/video_desk.hpp"

#include <QFileInfo>
#include <QSet>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/document/open_video.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/video/overlay_section.hpp"
#include "widgets/video/step_bar.hpp"
#include "widgets/video/sync_section.hpp"
#include "widgets/video/video_panel.hpp"
#include "widgets/video/video_view.hpp"
#include "widgets/video/video_words.hpp"

namespace abrazo::app {
namespace {

constexpr double longest_gap_s = 0.5;  // between two frames that poses are interpolated in
constexpr double edge_s = 0.02;        // tolerance before and after the recorded range [s]

using widgets::text;

}  // namespace

VideoDesk::VideoDesk(MainWindow& window)
    : QObject(&window), m_window(window), m_panel(new widgets::VideoPanel) {
  window.colour(m_panel);
  connect(&window.document(), &Document::began, this, &VideoDesk::onSessionStarted);
  connect(&window, &MainWindow::filesOpened, this, [this](const QStringList& files) {
    QStringList videos;
    for (const QString& file : files)
      if (is_video_file(file)) videos << file;
    if (!videos.isEmpty()) open(videos);
  });
  connect(&window.ticker(), &FrameTicker::playbackChanged, this, &VideoDesk::follow);
  connect(&window.document(), &Document::subjectChanged, this, &VideoDesk::onSubject);
  connect(&window.document(), &Document::changed, this, [this](ProjectPart part) {
    if (part == ProjectPart::Videos) onVideos();
  });
  connect(&window.document(), &Document::videosOpened, this, &VideoDesk::setVideos);
  connectPanel();
}

VideoDesk::~VideoDesk() = default;

void VideoDesk::connectPanel() {
  using namespace widgets;
  connect(m_panel, &VideoPanel::chosen, this, [this](int index) {
    for (const VideoState& state : states())
      if (state.subject == m_subject && index-- == 0) return show(state.id);
  });
  connect(m_panel, &VideoPanel::closeRequested, this, &VideoDesk::close);
  connect(&m_panel->steps(), &StepBar::stepRequested, this, &VideoDesk::step);
  connect(&m_panel->view(), &VideoView::stepRequested, this, &VideoDesk::step);
  connect(&m_panel->steps(), &StepBar::linkRequested, this, &VideoDesk::setLinked);
  connect(&m_panel->overlay(), &OverlaySection::partsChanged, this, &VideoDesk::showOverlay);
  connect(&m_panel->overlay(), &OverlaySection::opacityChanged, &m_panel->view(), &VideoView::setOpacity);
  connect(&m_panel->view(), &VideoView::painted, this, [this] {
    if (!m_asked.isValid() || !m_shown || !currentVideo() || m_shown->index != currentVideo()->requested())
      return;
    m_latency_ms = static_cast<double>(m_asked.nsecsElapsed()) * 1e-6;
    m_asked.invalidate();
  });
  SyncSection& sync = m_panel->sync();
  connect(&sync, &SyncSection::pointRequested, this, &VideoDesk::setSyncPoint);
  connect(&sync, &SyncSection::goToRequested, &m_window.ticker(), &FrameTicker::seek);
  const auto edit = [this](auto make, const QString& what) {
    return [this, make, what](auto... value) {
      changeCurrent([&](VideoState& state) { state.sync = make(state.sync, value...); }, what);
    };
  };
  connect(&sync, &SyncSection::pointRemoveRequested, this,
          edit([](const VideoSync& now,
                  int index) { return without_sync_point(now, static_cast<std::size_t>(index)); },
               "remove sync point"));
  connect(&sync, &SyncSection::offsetEntered, this, edit(with_offset, "offset of the video"));
  connect(&sync, &SyncSection::rateEntered, this, edit(with_rate, "rate of the video"));
  connect(&sync, &SyncSection::clearRequested, this, &VideoDesk::clearSync);
}

// ---- what is open

void VideoDesk::setVideos(const std::vector<ProjectVideo>& videos, const QStringList& files) {
  VideoStates next;
  for (std::size_t i = 0; i < videos.size() && static_cast<int>(i) < files.size(); ++i) {
    next.push_back(video_state(videos[i], files[static_cast<int>(i)].toStdString()));
    next.back().id = m_nextId++;
  }
  m_window.document().replaceVideos(std::move(next));
  if (current()) m_window.panels().want("video", true);
}

void VideoDesk::open(const QStringList& files) {
  VideoStates next = states();
  for (const QString& file : files) {
    VideoState state;
    state.id = m_nextId++;
    state.file = file.toStdString();
    state.subject = m_subject;
    next.push_back(state);
  }
  if (next.size() == states().size()) return;
  m_current = next.back().id;
  m_linked = true;
  change(next, files.size() == 1 ? "open video " + QFileInfo(files.front()).fileName()
                                 : QString("open %1 videos").arg(files.size()));
  m_window.panels().want("video", true);
}

void VideoDesk::close() {
  VideoStates next = states();
  std::erase_if(next, [this](const VideoState& state) { return state.id == m_current; });
  if (next.size() != states().size()) change(next, "close video");
}

const VideoStates& VideoDesk::states() const {
  return m_window.document().live().videos();
}

const VideoState* VideoDesk::current() const {
  for (const VideoState& state : states())
    if (state.id == m_current) return &state;
  return nullptr;
}

OpenVideo* VideoDesk::currentVideo() const {
  const auto found = m_open.find(m_current);
  return found == m_open.end() ? nullptr : found->second.get();
}

void VideoDesk::show(int id) {
  m_current = id;
  m_shown = nullptr;
  onState();
}

void VideoDesk::change(VideoStates next, const QString& what, int merges) {
  m_window.document().change(next, what, "video", merges);
}

void VideoDesk::changeCurrent(const std::function<void(VideoState&)>& edit, const QString& what, int merges) {
  VideoStates next = states();
  for (VideoState& state : next) {
    if (state.id != m_current) continue;
    const VideoSync before = state.sync;
    edit(state);
    const Status possible = check_sync(state.sync);
    if (!possible) {
      showSync();  // what was entered is taken back
      return m_window.messages().showError(words(possible.error()));
    }
    if (m_retime && state.sync != before) m_retime(state, before);
  }
  change(std::move(next), what, merges);
}

/// Opens and closes decoders to match the states.
void VideoDesk::onVideos() {
  std::erase_if(m_open, [this](const auto& open) {
    return std::ranges::none_of(states(), [&](const VideoState& state) {
      return state.id == open.first && QString::fromStdString(state.file) == open.second->file();
    });
  });
  for (const VideoState& state : states()) {
    m_nextId = std::max(m_nextId, state.id + 1);
    auto& open = m_open[state.id];
    if (open) continue;
    open = std::make_unique<OpenVideo>(QString::fromStdString(state.file));
    connect(open.get(), &OpenVideo::news, this, [this, id = state.id] {
      if (id == m_current) onNews();
    });
  }
  onSubject();
}

/// A video of the session before has nothing to do with this one; those of takes stay.
void VideoDesk::onSessionStarted() {
  VideoStates rest = states();
  if (!std::exchange(m_hadSession, true)) return onSubject();
  std::erase_if(rest, [](const VideoState& state) { return state.subject.empty(); });
  const bool closed = rest.size() != states().size();
  m_window.document().replaceVideos(std::move(rest));
  if (closed)
    m_window.messages().showInformation("The video belonged to the previous session and was closed");
}

void VideoDesk::onSubject() {
  m_subject = m_window.document().subject();
  const VideoState* shown = current();
  if (!shown || shown->subject != m_subject) {
    m_current = 0;
    m_shown = nullptr;
    for (const VideoState& state : states())
      if (state.subject == m_subject) m_current = state.id;
  }
  onState();
}

// ---- what is shown

void VideoDesk::setLinked(bool on) {
  m_linked = on;
  follow();
  showSync();
  showOverlay();
}

void VideoDesk::step(int pictures) {
  const OpenVideo* video = currentVideo();
  const auto facts = video ? video->facts() : nullptr;
  if (!facts) return;
  const int asked = video->requested() < 0 ? 0 : video->requested();
  const int index = std::clamp(asked + pictures, 0, facts->frames() - 1);
  if (!m_linked) return request(index);
  const double to_s = current()->sync.subject_time(facts->times_s[static_cast<std::size_t>(index)]);
  m_window.ticker().seek(to_s);
}

void VideoDesk::setSyncPoint() {
  if (!current() || !m_shown || !m_window.ticker().history())
    return m_window.messages().showInformation("Open a video first, and show the moment in it");
  const SyncPoint point{m_window.ticker().playback().cursor_s, m_shown->time_s};
  changeCurrent([&](VideoState& state) { state.sync = widgets::with_sync_point(state.sync, point); },
                "same moment in video and timeline");
}

void VideoDesk::clearSync() {
  changeCurrent([](VideoState& state) { state.sync = {}; }, "clear synchronisation");
}

/// Each tick of the display: the newest time counts.
void VideoDesk::follow() {
  const OpenVideo* video = currentVideo();
  const auto facts = video ? video->facts() : nullptr;
  if (!facts || facts->frames() == 0) return;
  if (m_linked)
    request(facts->index_at(current()->sync.video_time(m_window.ticker().playback().cursor_s)));
  else if (video->requested() < 0)
    request(0);
  m_panel->view().setNotice(notice());
  if (!m_linked) showOverlay();
}

void VideoDesk::request(int index) {
  if (currentVideo()->request(index)) m_asked.start();
}

/// What the file is may be news together with its first picture.
void VideoDesk::onNews() {
  const bool is_read = currentVideo()->newest() && currentVideo()->facts() == m_shownFacts;
  is_read ? onPicture() : onState();
}

void VideoDesk::onPicture() {
  const OpenVideo* video = currentVideo();
  const VideoFramePtr newest = video ? video->newest() : nullptr;
  if (!newest || newest == m_shown) return;
  m_shown = newest;
  m_panel->view().showPicture(newest);
  m_panel->steps().showPicture(newest->index, video->facts()->frames(), newest->time_s);
  m_panel->view().setNotice(notice());
  showOverlay();
  emit pictureShown();
}

/// Another video, or another state of its file.
void VideoDesk::onState() {
  QStringList names;
  int place = -1;
  for (const VideoState& state : states()) {
    if (state.subject != m_subject) continue;
    if (state.id == m_current) place = static_cast<int>(names.size());
    names << QFileInfo(QString::fromStdString(state.file)).fileName();
  }
  m_panel->showFiles(names, place);
  showFacts();
  if (!currentVideo() || currentVideo()->state() != VideoDecoder::State::Open) m_shown = nullptr;
  if (!m_shown) {
    m_panel->view().showPicture(nullptr);
    m_panel->view().showOverlay({});
    m_panel->steps().showPicture(-1, 0, 0);
  }
  follow();
  m_panel->view().setNotice(notice());
  showSync();
  emit currentChanged();
  onPicture();
  if (m_shown) showOverlay();  // of another camera
}

void VideoDesk::showFacts() {
  const OpenVideo* video = currentVideo();
  const auto facts = m_shownFacts = video ? video->facts() : nullptr;
  if (!facts) return m_panel->showFacts({}, video ? video->trouble() : QString());
  QStringList warnings;
  for (const std::string& warning : facts->warnings) warnings << text(warning);
  m_panel->showFacts(text(widgets::facts_text(*facts)), warnings.join("\n"));
}

void VideoDesk::showSync() {
  const bool usable = currentVideo() && currentVideo()->facts();
  m_panel->sync().show(current() ? current()->sync : VideoSync{}, usable);
  m_panel->steps().setUsable(usable);
  m_panel->steps().setLinked(m_linked);
}

/// The reason why there is no picture at this time.
QString VideoDesk::notice() const {
  const OpenVideo* video = currentVideo();
  if (!video)
    return states().empty() ? "No video. File > Open video…, or drop one here"
                            : "No video of the subject on the timeline";
  if (video->state() == VideoDecoder::State::Failed) return video->trouble();
  const auto facts = video->facts();
  if (!facts) return QString("Reading the video, %1 %").arg(static_cast<int>(100 * video->opened()));
  if (!video->trouble().isEmpty()) return video->trouble();
  if (!m_linked || !m_window.ticker().history()) return {};
  const double video_s = current()->sync.video_time(m_window.ticker().playback().cursor_s);
  if (video_s < -edge_s) return QString("The video begins %1 s later").arg(-video_s, 0, 'f', 2);
  if (video_s > facts->duration_s() + edge_s)
    return QString("The video ended %1 s before").arg(video_s - facts->duration_s(), 0, 'f', 2);
  return {};
}

// ---- overlay

double VideoDesk::shownTime() const {
  const double cursor_s = m_window.ticker().playback().cursor_s;
  return m_linked && m_shown && current() ? current()->sync.subject_time(m_shown->time_s) : cursor_s;
}

std::optional<VideoDesk::Moment> VideoDesk::momentAt(double subject_s) const {
  const FrameHistory* history = m_window.ticker().history();
  const FrameSnapshotPtr frame = history ? history->at(subject_s) : nullptr;
  if (!frame || frame->time_s > subject_s + edge_s) return std::nullopt;
  const FrameSnapshotPtr next = history->stepped(frame->time_s, 1);
  const double gap_s = next ? next->time_s - frame->time_s : 0;
  if (gap_s <= 0 && subject_s > frame->time_s + longest_gap_s) return std::nullopt;
  const bool interpolates = gap_s > 0 && gap_s < longest_gap_s;
  return Moment{interpolates ? widgets::between(frame->result.result, next->result.result,
                                                (subject_s - frame->time_s) / gap_s)
                             : frame->result.result,
                frame->result.edges};
}

void VideoDesk::showOverlay() {
  const VideoState* state = current();
  const bool fits = state && state->camera && m_shown && m_panel->view().notice().isEmpty();
  const auto moment = fits ? momentAt(shownTime()) : std::nullopt;
  m_panel->view().showOverlay(moment ? widgets::project_overlay(*state->camera, moment->pose, moment->edges,
                                                                m_panel->overlay().parts())
                                     : widgets::VideoOverlay{});
}

}  // namespace abrazo::app
