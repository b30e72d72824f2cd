#include "app/workbench/video/camera_desk.hpp"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/document/open_video.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/video/video_desk.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/video/camera_file.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/selection.hpp"
#include "widgets/video/camera_section.hpp"
#include "widgets/video/video_panel.hpp"
#include "widgets/video/video_view.hpp"

namespace abrazo::app {
namespace {

constexpr int least_picks = 6, least_picks_for_focal = 8;
constexpr double same_picture_share = 0.25;  // of the time between two pictures
// Ends of limbs, and joints that are seen in a picture of clothed people.
constexpr std::array suggested = {joints::Head,     joints::LeftFoot,  joints::RightHand, joints::RightFoot,
                                  joints::LeftHand, joints::LeftTibia, joints::RightTibia};

int needed(const VideoState& state) {
  return state.free_focal_length ? least_picks_for_focal : least_picks;
}

std::string lens_words(const CameraIntrinsics& lens) {
  const bool straight = lens.distortion == std::array<double, 8>{};
  return QString("Lens of %1 × %2, f %3 px%4")
      .arg(lens.width)
      .arg(lens.height)
      .arg(lens.fx, 0, 'f', 1)
      .arg(straight ? "" : ", with distortion")
      .toStdString();
}

std::string place_words(const CameraModel& camera, const std::optional<Vec3>& middle) {
  const Vec3 at = camera.pose.position();
  QString words = QString("%1 m above the floor").arg(at.y(), 0, 'f', 2);
  if (middle) words = QString("Camera %1 m away, ").arg((at - *middle).norm(), 0, 'f', 2) + words;
  return words.toStdString();
}

}  // namespace

CameraDesk::CameraDesk(MainWindow& window, VideoDesk& videos)
    : QObject(&window), m_window(window), m_videos(videos), m_section(&videos.panel().camera()) {
  m_section->setColours(window.colours());
  videos.setRetime([this](VideoState& state, const VideoSync& before) { retime(state, before); });
  connect(&videos, &VideoDesk::currentChanged, this, &CameraDesk::update);
  connect(&videos, &VideoDesk::pictureShown, this, &CameraDesk::show);
  connectSection();
  update();
}

void CameraDesk::askIntrinsics() {
  const QString file = askFile(false, "Intrinsics of the camera", "Calibrations (*.yml *.yaml *.xml *.json)");
  if (!file.isEmpty()) loadIntrinsics(file);
}

void CameraDesk::askCamera() {
  const QString file = askFile(false, "Load camera", "Cameras (*.json)");
  if (!file.isEmpty()) loadCamera(file);
}

void CameraDesk::askWhereToSave() {
  const QString file = askFile(true, "Save camera", "Cameras (*.json)");
  if (!file.isEmpty()) saveCamera(file);
}

void CameraDesk::connectSection() {
  using namespace widgets;
  connect(m_section, &CameraSection::pickingRequested, this, &CameraDesk::setPicking);
  connect(m_section, &CameraSection::jointChosen, this, &CameraDesk::setJoint);
  connect(m_section, &CameraSection::pickSelected, this, &CameraDesk::goToPick);
  connect(m_section, &CameraSection::pickRemoveRequested, this, &CameraDesk::removePick);
  connect(m_section, &CameraSection::intrinsicsRequested, this, &CameraDesk::askIntrinsics);
  connect(m_section, &CameraSection::loadRequested, this, &CameraDesk::askCamera);
  connect(m_section, &CameraSection::saveRequested, this, &CameraDesk::askWhereToSave);
  connect(m_section, &CameraSection::guessRequested, this, [this](double degrees) {
    edit(
        [degrees](VideoState& state) {
          state.intrinsics.reset();
          state.guessed_fov_deg = degrees;
        },
        "guess the field of view");
  });
  connect(m_section, &CameraSection::freeFocalRequested, this, [this](bool on) {
    edit([on](VideoState& state) { state.free_focal_length = on; },
         on ? "find the focal length" : "keep the focal length");
  });
  connect(m_section, &CameraSection::clearRequested, this, [this] {
    edit(
        [](VideoState& state) {
          state.picked.clear();
          state.camera.reset();
        },
        "forget the camera");
  });
  VideoView& view = m_videos.panel().view();
  connect(&view, &VideoView::picked, this, &CameraDesk::pick);
  connect(&view, &VideoView::pickMoved, this, &CameraDesk::movePick);
  connect(&view, &VideoView::pickSelected, this, [this](int index) {
    m_selected = index;
    show();
  });
  connect(&view, &VideoView::pickRemoveRequested, this, &CameraDesk::removePick);
  connect(&view, &VideoView::pickingEndRequested, this, [this] { setPicking(false); });
}

// ---- edits

/// The solution always follows from the decisions.
void CameraDesk::edit(const std::function<void(VideoState&)>& change, const QString& what, int merges) {
  m_videos.changeCurrent(
      [&](VideoState& state) {
        const bool was_solved = static_cast<int>(state.picked.size()) >= needed(state);
        change(state);
        if (static_cast<int>(state.picked.size()) >= needed(state))
          solve(state);
        else if (was_solved)
          state.camera.reset();
      },
      what, merges);
}

CameraIntrinsics CameraDesk::intrinsics(const VideoState& state) const {
  if (state.intrinsics) return *state.intrinsics;
  const auto facts = m_videos.currentVideo() ? m_videos.currentVideo()->facts() : nullptr;
  return facts ? guessed_intrinsics(facts->width, facts->height, state.guessed_fov_deg) : CameraIntrinsics{};
}

void CameraDesk::solve(VideoState& state) const {
  const auto solved = solve_camera(intrinsics(state), state.picked, state.free_focal_length);
  state.camera = solved ? std::optional(solved->camera) : std::nullopt;
}

void CameraDesk::retime(VideoState& state, const VideoSync& before) const {
  for (PickedPoint& point : state.picked) {
    const double subject_s = state.sync.subject_time(before.video_time(point.subject_s));
    const auto moment = m_videos.momentAt(subject_s);
    point.subject_s = subject_s;
    if (moment && point.vertex >= 0) point.world = moment->pose.row(point.vertex).transpose();
  }
  if (static_cast<int>(state.picked.size()) >= needed(state)) solve(state);
}

void CameraDesk::setPicking(bool on) {
  if (on && !m_videos.isLinked()) m_videos.setLinked(true);
  m_section->setPicking(on);
  if (on) {
    m_section->setJoint(suggestedJoint());
    m_videos.panel().view().setFocus();
  }
  show();
}

void CameraDesk::setJoint(int vertex) {
  m_section->setJoint(vertex);
  if (!m_section->isPicking()) setPicking(true);
  show();
}

void CameraDesk::pick(const Pixel& pixel) {
  if (!m_videos.isLinked())
    return m_window.messages().showInformation(
        "Link the video to the timeline first: joints are picked at its time");
  const double subject_s = m_videos.shownTime();
  const auto moment = m_videos.momentAt(subject_s);
  if (!moment || !m_videos.shownPicture())
    return m_window.messages().showInformation("There are no bodies at this time; go to a recorded time");
  const int vertex = m_section->joint();
  const PickedPoint point{moment->pose.row(vertex).transpose(), pixel, vertex, subject_s};
  edit(
      [&](VideoState& state) {
        std::erase_if(state.picked, [&](const PickedPoint& other) {  // once for each joint and picture
          return other.vertex == vertex && std::abs(other.subject_s - subject_s) < 1e-6;
        });
        state.picked.push_back(point);
        m_selected = static_cast<int>(state.picked.size()) - 1;
      },
      "pick " + QString::fromStdString(widgets::vertex_name(vertex)));
  m_section->setJoint(suggestedJoint());
  show();
}

void CameraDesk::movePick(int index, const Pixel& pixel, int gesture) {
  edit(
      [&](VideoState& state) {
        if (index < static_cast<int>(state.picked.size()))
          state.picked[static_cast<std::size_t>(index)].pixel = pixel;
      },
      "move picked joint", 1 + gesture * 64 + index % 64);
}

void CameraDesk::removePick(int index) {
  edit(
      [&](VideoState& state) {
        if (index < static_cast<int>(state.picked.size())) state.picked.erase(state.picked.begin() + index);
      },
      "remove picked joint");
}

// ---- files

QString CameraDesk::askFile(bool saves, const QString& title, const QString& filter) {
  if (!saves) return ask_file(&m_window, m_window.remembered(), title, filter);
  return ask_new_file(&m_window, m_window.remembered(), title, "camera.json", ".json", filter);
}

void CameraDesk::loadIntrinsics(const QString& file) {
  const auto facts = m_videos.currentVideo() ? m_videos.currentVideo()->facts() : nullptr;
  if (!facts) return m_window.messages().showInformation("Open the video first that the camera took");
  const auto read = read_intrinsics(file.toStdString());
  const auto fitting = read ? scaled(*read, facts->width, facts->height) : read;
  if (!fitting) return m_window.messages().showError(words(fitting.error()));
  edit(
      [&](VideoState& state) {
        state.intrinsics = *fitting;
        state.free_focal_length = false;
      },
      "intrinsics " + QFileInfo(file).fileName());
}

void CameraDesk::loadCamera(const QString& file) {
  const auto facts = m_videos.currentVideo() ? m_videos.currentVideo()->facts() : nullptr;
  if (!facts) return m_window.messages().showInformation("Open the video first that the camera took");
  auto read = read_camera(file.toStdString());
  if (!read) return m_window.messages().showError(words(read.error()));
  const auto fitting = scaled(read->intrinsics, facts->width, facts->height);
  if (!fitting) return m_window.messages().showError(words(fitting.error()));
  m_videos.changeCurrent(
      [&](VideoState& state) {
        state.intrinsics = *fitting;
        state.free_focal_length = false;
        state.picked.clear();
        state.camera = CameraModel{*fitting, read->pose};
      },
      "load camera " + QFileInfo(file).fileName());
}

void CameraDesk::saveCamera(const QString& file) {
  const VideoState* state = m_videos.current();
  if (!state || !state->camera)
    return m_window.messages().showInformation("There is no camera yet: pick joints, or load one");
  const Status written = write_camera(*state->camera, file.toStdString());
  written ? m_window.messages().showInformation("Camera written to " + file)
          : m_window.messages().showError(words(written.error()));
}

// ---- what is shown

/// Another video, or something was decided about it.
void CameraDesk::update() {
  const VideoState* state = m_videos.current();
  m_solved.reset();
  m_trouble.clear();
  if (state && static_cast<int>(state->picked.size()) >= needed(*state)) {
    auto solved = solve_camera(intrinsics(*state), state->picked, state->free_focal_length);
    if (solved)
      m_solved = std::move(solved).value();
    else
      m_trouble = words(solved.error());
  }
  const int id = state ? state->id : 0;
  if (std::exchange(m_shownId, id) != id) {
    m_selected = -1;
    m_section->setPicking(false);
  }
  show();
}

std::vector<widgets::PickMark> CameraDesk::marks(const VideoState& state) const {
  const auto facts = m_videos.currentVideo() ? m_videos.currentVideo()->facts() : nullptr;
  const double rate = facts && facts->rate_hz > 0 ? facts->rate_hz : 25;
  const double now_s = m_videos.shownTime();
  std::vector<widgets::PickMark> marks;
  for (std::size_t i = 0; i < state.picked.size(); ++i) {
    const PickedPoint& point = state.picked[i];
    widgets::PickMark mark;
    mark.pixel = point.pixel;
    mark.name = point.vertex >= 0 ? widgets::vertex_name(point.vertex) : "point " + std::to_string(i + 1);
    mark.subject_s = point.subject_s;
    mark.is_here = std::abs(point.subject_s - now_s) < same_picture_share / rate;
    if (state.camera) mark.projected = state.camera->project(point.world);
    if (mark.projected) mark.error_px = (*mark.projected - point.pixel).norm();
    mark.is_outlier = m_solved && i < m_solved->used.size() && !m_solved->used[i];
    marks.push_back(std::move(mark));
  }
  return marks;
}

void CameraDesk::show() {
  const VideoState* state = m_videos.current();
  widgets::CameraStatus status;
  status.usable = m_videos.currentVideo() && m_videos.currentVideo()->facts();
  if (state) {
    if (state->intrinsics) status.intrinsics = lens_words(*state->intrinsics);
    if (!state->intrinsics && state->camera)
      status.intrinsics = lens_words(state->camera->intrinsics) + " (found)";
    status.guessed_fov_deg = state->guessed_fov_deg;
    status.free_focal_length = state->free_focal_length;
    status.has_camera = state->camera.has_value();
    status.picks = marks(*state);
    status.picks_needed = needed(*state);
    status.trouble = m_trouble.toStdString();
    if (m_solved) {
      status.rms_px = m_solved->rms_px;
      status.used = static_cast<int>(std::ranges::count(m_solved->used, true));
      status.warnings = m_solved->warnings;
    }
    const auto moment = m_videos.momentAt(m_videos.shownTime());
    if (state->camera)
      status.place =
          place_words(*state->camera,
                      moment ? std::optional<Vec3>(moment->pose.colwise().mean().transpose()) : std::nullopt);
  }
  m_selected = std::min(m_selected, static_cast<int>(status.picks.size()) - 1);
  m_section->show(status);
  m_section->selectPick(m_selected);
  auto& view = m_videos.panel().view();
  view.setPicks(status.picks);
  view.selectPick(m_selected);
  view.setPicking(m_section->isPicking() && status.usable
                      ? QString::fromStdString(widgets::vertex_name(m_section->joint()))
                      : QString());
}

void CameraDesk::goToPick(int index) {
  const VideoState* state = m_videos.current();
  if (!state || index < 0 || index >= static_cast<int>(state->picked.size())) return;
  m_selected = index;
  m_videos.setLinked(true);
  m_window.ticker().seek(state->picked[static_cast<std::size_t>(index)].subject_s);
  show();
}

/// The one farthest from all that were picked: points that lie apart tell the camera's place best.
int CameraDesk::suggestedJoint() const {
  const VideoState* state = m_videos.current();
  const auto moment = m_videos.momentAt(m_videos.shownTime());
  if (!state || !moment) return joints::Head;
  std::set<int> done;
  for (const PickedPoint& point : state->picked) done.insert(point.vertex);
  int best = joints::Head;
  double farthest = -1;
  for (const int body : {0, joint_count})
    for (const int joint : suggested) {
      const int vertex = body + joint;
      const Vec3 at = moment->pose.row(vertex).transpose();
      double nearest = done.contains(vertex) ? 0 : std::numeric_limits<double>::max();
      for (const PickedPoint& point : state->picked)
        nearest = std::min(nearest, (point.world - at).norm() * (done.contains(vertex) ? 0.5 : 1));
      if (nearest <= farthest) continue;
      farthest = nearest;
      best = vertex;
    }
  return best;
}

}  // namespace abrazo::app
