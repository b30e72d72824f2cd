#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <functional>
#include <map>
#include <memory>

#include "core/base/positions.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "core/session/edit/video_state.hpp"
#include "core/video/video_frame.hpp"

namespace abrazo::widgets {
class VideoPanel;
}

namespace abrazo::app {

class MainWindow;
class OpenVideo;

/// The reference videos of the window: the open ones, the shown one and its picture. A linked video shows the
/// picture at the timeline's cursor; an unlinked one is stepped separately, to find the same moment. All
/// edits go through `change`, which makes them undo steps.
class VideoDesk : public QObject {
  Q_OBJECT
 public:
  explicit VideoDesk(MainWindow& window);
  ~VideoDesk() override;

  /// Replaces the open videos without an undo step. A missing file is reported; its state is kept.
  void setVideos(const std::vector<ProjectVideo>& videos, const QStringList& files);

  /// Opens videos for the shown subject, in addition to the open ones.
  void open(const QStringList& files);
  void close();

  /// Called with a state whose synchronisation changed, and the previous one, to adjust picked joints.
  using Retime = std::function<void(VideoState&, const VideoSync& before)>;
  void setRetime(Retime retime) { m_retime = std::move(retime); }

  const VideoStates& states() const;
  /// The current video of the shown subject; null = none.
  const VideoState* current() const;
  OpenVideo* currentVideo() const;
  void show(int id);
  /// @param merges successive changes with the same number other than 0 merge into one undo step
  void change(VideoStates next, const QString& what, int merges = 0);
  /// Edits the current video.
  void changeCurrent(const std::function<void(VideoState&)>& edit, const QString& what, int merges = 0);

  bool isLinked() const { return m_linked; }
  void setLinked(bool on);
  /// Steps the video; if it is linked, moves the cursor to the time of the picture.
  void step(int pictures);
  /// Adds a sync point of the shown picture and the cursor.
  void setSyncPoint();
  void clearSync();

  /// Content of the overlay: both bodies at a time of the subject, if available.
  struct Moment {
    PairPose pose;
    std::vector<MeshEdge> edges;
  };
  std::optional<Moment> momentAt(double subject_s) const;
  /// Subject time of the picture; that of the cursor if not linked.
  double shownTime() const;
  /// The shown picture; null before the first.
  const VideoFramePtr& shownPicture() const { return m_shown; }
  widgets::VideoPanel& panel() const { return *m_panel; }
  /// The shown subject: "" = the session.
  const std::string& subject() const { return m_subject; }
  /// Time from the request of the last picture to its display [ms].
  double latency_ms() const { return m_latency_ms; }

 signals:
  /// The current video changed, or its file was read.
  void currentChanged();
  void pictureShown();

 private:
  void onVideos();
  void follow();
  void request(int index);
  void onNews();
  void onPicture();
  void onSubject();
  void onSessionStarted();
  void onState();
  void showFacts();
  void showSync();
  void showOverlay();
  QString notice() const;
  void connectPanel();

  MainWindow& m_window;
  widgets::VideoPanel* m_panel;
  std::map<int, std::unique_ptr<OpenVideo>> m_open;  ///< by the id of its state
  std::string m_subject;
  int m_current = 0;
  int m_nextId = 1;
  bool m_linked = true;
  bool m_hadSession = false;
  VideoFramePtr m_shown;
  std::shared_ptr<const VideoFacts> m_shownFacts;
  Retime m_retime;
  QElapsedTimer m_asked;
  double m_latency_ms = 0;
};

}  // namespace abrazo::app
