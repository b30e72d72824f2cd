#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "core/session/edit/video_state.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo::widgets {
class CameraSection;
struct PickMark;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MainWindow;
class VideoDesk;

/// The camera of the shown video: lens, picked joints, and the solved pose.
class CameraDesk : public QObject {
  Q_OBJECT
 public:
  CameraDesk(MainWindow& window, VideoDesk& videos);

  void setPicking(bool on);
  /// @param vertex  of the pair
  void setJoint(int vertex);
  /// Asks for the file.
  void askIntrinsics();
  void askCamera();
  void askWhereToSave();
  void loadIntrinsics(const QString& file);
  void loadCamera(const QString& file);
  void saveCamera(const QString& file);
  /// Picks the chosen joint in the picture and suggests the next one.
  void pick(const Pixel& pixel);
  void movePick(int index, const Pixel& pixel, int gesture);
  void removePick(int index);
  /// The solution for the shown video's points, if any.
  const std::optional<SolvedCamera>& solved() const { return m_solved; }

 private:
  void connectSection();
  void edit(const std::function<void(VideoState&)>& change, const QString& what, int merges = 0);
  CameraIntrinsics intrinsics(const VideoState& state) const;
  void solve(VideoState& state) const;
  void retime(VideoState& state, const VideoSync& before) const;
  std::vector<widgets::PickMark> marks(const VideoState& state) const;
  void update();
  void show();
  void goToPick(int index);
  int suggestedJoint() const;
  QString askFile(bool saves, const QString& title, const QString& filter);

  MainWindow& m_window;
  VideoDesk& m_videos;
  widgets::CameraSection* m_section;
  std::optional<SolvedCamera> m_solved;
  QString m_trouble;
  int m_selected = -1;
  int m_shownId = 0;
};

}  // namespace abrazo::app
