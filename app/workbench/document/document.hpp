#pragma once

#include <QObject>
#include <QStringList>
#include <QUndoStack>
#include <memory>
#include <string>
#include <utility>

#include "app/workbench/document/live_session.hpp"
#include "core/session/edit/live_project.hpp"

namespace abrazo::app {

/// What is worked on in the window, and the session that it runs on: the one place of settings, decisions,
/// role control and markers. Whoever shows a part listens to `changed`, whoever wants another asks here; the
/// solver is told. How each part changes is said by LiveProject.
class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr) : QObject(parent) {}

  /// Without what is known only when it is saved: references to its library and input, and where panels
  /// stand.
  const Project& project() const { return m_live.project(); }
  const LiveProject& live() const { return m_live; }
  const Settings& settings() const { return project().settings; }
  const Decisions& decisions() const { return project().decisions; }
  /// Of the shown subject.
  const Markers& markers() const { return m_live.markers(m_subject); }
  QUndoStack& undoStack() { return m_undo; }

  /// As a step of undo; nothing happens where it is so already.
  /// @param key, gesture  changes of one key with the same number other than 0 are one step
  void change(const ProjectValue& next, const QString& what, const QString& key = {}, int gesture = 0);
  /// As typed into a setting's field. What cannot be used is refused.
  void changeSetting(const QString& key, const QString& text, int gesture = 0);
  void choosePreset(const QString& name, bool own = false);
  void adopt(const Settings& settings, const QString& what);
  /// Markers of the shown subject.
  void changeMarkers(const Markers& next, const QString& what);

  /// Without a step of undo, see LiveProject::put.
  template <typename... Value>
  void put(Value&&... value) {
    announce(m_live.put(std::forward<Value>(value)...));
  }
  void replaceVideos(VideoStates videos) { announce(m_live.replace_videos(std::move(videos))); }
  void putSettings(const Settings& settings) { put(m_live.with_settings(settings)); }
  /// Refused where the library does not say who leads. @return whether it was done
  bool controlRole(RoleControl by);
  /// A saved project, in the session that has begun.
  void open(const Project& saved, const QStringList& videos);
  void openAnnotations(const AnnotationBook& book) { emit annotationsOpened(book); }

  /// Null while nothing is open.
  LiveSession* session() const { return m_session.get(); }
  /// In place of the session there was; views have let go of it.
  void beginSession(PreparedSolver prepared);
  void endSession() { m_session.reset(); }
  /// The session goes on with another library: a take was added, or something said of one.
  void replaceSolver(PreparedSolver prepared);

  /// Whose frames are shown: the session's (""), or those of a take of its library.
  const std::string& subject() const { return m_subject; }
  void setSubject(const std::string& subject);

 signals:
  void changed(abrazo::ProjectPart part);
  void subjectChanged();
  void refused(const QString& why);
  void libraryReplaced(const std::shared_ptr<const abrazo::MotionLibrary>& before,
                       const std::shared_ptr<const abrazo::MotionLibrary>& after);
  /// They come with a project; who keeps them puts them.
  void annotationsOpened(const abrazo::AnnotationBook& book);
  void videosOpened(const std::vector<abrazo::ProjectVideo>& videos, const QStringList& files);

 private:
  friend class DocumentStep;
  void announce(const LiveProject::Parts& parts);
  void tellSolver(ProjectPart part);
  void take(const Result<ChosenSettings>& next, const QString& what, const QString& key, int gesture);

  LiveProject m_live;
  QUndoStack m_undo;
  std::string m_subject;
  std::unique_ptr<LiveSession> m_session;
};

}  // namespace abrazo::app
