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

/// The reference videos of the window: which are open, the one that is shown, and what picture of it. While
/// it is linked its picture is that of the timeline's cursor; else it is stepped by itself, to find where
/// both show the same moment. Everything a person decides comes by `change`, which makes it a step of undo.
class VideoDesk : public QObject {
  Q_OBJECT
 public:
  explicit VideoDesk(MainWindow& window);
  ~VideoDesk() override;

  /// In place of what is open, without a step of undo. A missing file is reported; what was decided
  /// about it is kept.
  void setVideos(const std::vector<ProjectVideo>& videos, const QStringList& files);

  /// For the shown subject, beside those that are open.
  void open(const QStringList& files);
  void close();

  /// Called with a state whose synchronisation changed, and what it was: picked joints were elsewhere then.
  using Retime = std::function<void(VideoState&, const VideoSync& before)>;
  void setRetime(Retime retime) { m_retime = std::move(retime); }

  const VideoStates& states() const;
  /// Of the shown subject; null when there is none.
  const VideoState* current() const;
  OpenVideo* currentVideo() const;
  void show(int id);
  /// @param merges  changes with the same number, other than 0, one after the other are one step of undo
  void change(VideoStates next, const QString& what, int merges = 0);
  /// Of the current video.
  void changeCurrent(const std::function<void(VideoState&)>& edit, const QString& what, int merges = 0);

  bool isLinked() const { return m_linked; }
  void setLinked(bool on);
  /// Linked, the cursor goes to the time of the picture; else only the video.
  void step(int pictures);
  /// The shown picture and the cursor are the same moment.
  void setSyncPoint();
  void clearSync();

  /// What is drawn over the picture: both bodies at a time of the subject; nothing where there is none.
  struct Moment {
    PairPose pose;
    std::vector<MeshEdge> edges;
  };
  std::optional<Moment> momentAt(double subject_s) const;
  /// The time of the subject that the picture shows; the cursor's while it is not linked.
  double shownTime() const;
  /// What is shown; null before the first picture.
  const VideoFramePtr& shownPicture() const { return m_shown; }
  widgets::VideoPanel& panel() const { return *m_panel; }
  /// Of the shown subject: "" for the session.
  const std::string& subject() const { return m_subject; }
  /// From where picture was asked for to where it is on the widget, the last one [ms].
  double latency_ms() const { return m_latency_ms; }

 signals:
  /// Another video or none, or its file was read.
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
