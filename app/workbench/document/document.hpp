#pragma once

#include <QObject>
#include <QStringList>
#include <QUndoStack>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/workbench/document/live_session.hpp"
#include "core/annotation/label_selection.hpp"
#include "core/session/edit/live_project.hpp"

namespace abrazo::app {

class Job;

/// The live project of the window, and the session that it runs on: the one owner of settings, decisions,
/// role control, markers and annotations. Views listen to `changed` and request changes here; changes are
/// passed to the solver. LiveProject has the rules of each part.
class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  /// The project without parts that are set only on saving: references to library and input, and the layout
  /// of panels.
  const Project& project() const { return m_live.project(); }
  const LiveProject& live() const { return m_live; }
  const Settings& settings() const { return project().settings; }
  const Decisions& decisions() const { return project().decisions; }
  /// Of the shown subject.
  const Markers& markers() const { return m_live.markers(m_subject); }
  /// Of the shown subject, with what is active and selected in them.
  const Annotations& annotations() const { return m_live.annotations().of(m_subject); }
  const LabelSelection& labels() const { return m_labels; }
  QUndoStack& undoStack() { return m_undo; }

  /// Changes a part as an undo step; no effect if nothing changes.
  /// @param key, gesture changes of one key with the same number other than 0 merge into one step
  void change(const ProjectValue& next, const QString& what, const QString& key = {}, int gesture = 0);
  /// Sets a setting from typed text. Invalid text is refused. A body that is a file is measured on another
  /// thread, and set when that is done unless the setting is changed again before.
  void changeSetting(const QString& key, const QString& text, int gesture = 0);
  void choosePreset(const QString& name, bool own = false);
  /// For the live solver as well, while others are tried.
  void adopt(const Settings& settings, const QString& what);
  /// Markers of the shown subject.
  void changeMarkers(const Markers& next, const QString& what);
  /// Annotations of the shown subject. @param what "draw turn": for menu and message
  void changeAnnotations(const Annotations& next, const QString& what);
  /// The same, with what the edit selects. An Error is passed on by `labelRefused`. @return whether it was
  /// done
  bool edit(const Result<LabelEdit>& edit);
  void chooseTier(int tier);
  /// @param annotation  0 = none
  void selectLabel(int annotation);
  void setConflict(Conflict conflict);

  /// Changes without an undo step, see LiveProject::put.
  template <typename... Value>
  void put(Value&&... value) {
    announce(m_live.put(std::forward<Value>(value)...));
  }
  void replaceVideos(VideoStates videos) { announce(m_live.replace_videos(std::move(videos))); }
  void putSettings(const Settings& settings) { put(m_live.with_settings(settings)); }
  /// These annotations are in a session file now; the next session drops all others.
  void noteSaved(const AnnotationBook& book) { m_live.note_saved(book); }
  /// Refused if the library lacks the annotations for it. @return whether it was done
  bool controlRole(RoleControl by);
  // What a person changes while a frame of a live session's past is shown is tried there: that frame is
  // solved again, and the live solver keeps what it has until the change is used for it.

  /// From now on settings are tried. @param on  false: those that were not used are taken back as an undo
  /// step
  void setTries(bool on);
  /// None ends it.
  void tryPin(std::optional<int> pair);
  const std::optional<int>& triedPin() const { return m_triedPin; }
  bool triesOther() const;
  /// Those of the live solver, unless `setAside`.
  const Settings& liveSettings() const { return m_kept ? *m_kept : settings(); }
  void useTriedSettings();
  void useTriedPin();
  /// The live solver keeps its settings, whatever is changed.
  void setAside(bool on);
  /// The decisions for the parked frame: those in force, with the tried pin.
  Decisions shownDecisions() const;
  /// Takes new decisions that a view requests. While parked, another pin is tried on the parked frame only.
  void decide(const Decisions& next, const QString& what, bool is_parked);
  /// Null if nothing is open.
  LiveSession* session() const { return m_session.get(); }
  /// Replaces the session; views must have released the previous one. In this order: `began`, the contents of
  /// the session's file part by part, `opened`.
  void openSession(PreparedSolver prepared);
  /// Call before openSession and endSession, while the session is whole.
  void finishSession() { emit ending(); }
  /// Returns at once; the session ends on another thread, which waits for its step and its files.
  void endSession();
  /// Continues the session with another library: a take was added or annotated.
  void replaceSolver(PreparedSolver prepared);

  /// The shown subject: the session (""), or a take of its library.
  const std::string& subject() const { return m_subject; }
  void setSubject(const std::string& subject);

 signals:
  /// The session is about to end: rooms end their work with it and release its objects.
  void ending();
  /// A session runs; views and rooms begin anew. The contents of its file follow.
  void began();
  /// All of the session's file is in the document.
  void opened();
  void changed(abrazo::ProjectPart part);
  void subjectChanged();
  void triedChanged();
  /// Settings that were only tried are those of the live solver again.
  void triedTakenBack();
  void refused(const QString& why);
  void labelRefused(const QString& why);
  /// The active tier, the selected label or the conflict rule is another one.
  void labelChosen();
  /// Annotations of one subject changed, perhaps of one that is not shown. @param what the edit, done or
  /// undone
  void annotated(const std::string& subject, const QString& what);
  /// Other annotations are shown: those of another subject, session or project.
  void annotationsReplaced();
  void libraryReplaced(const std::shared_ptr<const abrazo::MotionLibrary>& before,
                       const std::shared_ptr<const abrazo::MotionLibrary>& after);
  void videosOpened(const std::vector<abrazo::ProjectVideo>& videos, const QStringList& files);

 private:
  friend class DocumentStep;
  /// Does or undoes an edit. @return false, without a change, if it no longer applies
  bool apply(const ProjectEdit& edit, const ProjectValue& value);
  void announce(const LiveProject::Parts& parts);
  void holdSettings();
  void tellSolver(ProjectPart part);
  void beginSession(PreparedSolver prepared);
  void openRecording(const RecordedSession& recorded);
  void openProject(const OpenedProject& opened);
  void openAnnotations(const OpenedProject& opened);
  void take(const Result<ChosenSettings>& next, const QString& what, const QString& key, int gesture);
  void takeSetting(Result<ChosenSettings> next, const QString& key, int gesture);
  void measure(const BodyChoice& body, const QString& key, const QString& text, int gesture);

  LiveProject m_live;
  QUndoStack m_undo;
  std::string m_subject;
  LabelSelection m_labels;
  std::optional<int> m_triedPin;
  std::optional<Settings> m_kept;  ///< by the live solver while others are tried
  bool m_isAside = false;
  std::unique_ptr<LiveSession> m_session;
  std::map<QString, std::unique_ptr<Job>> m_measuring;  ///< of bodies that settings are to have, by key
};

}  // namespace abrazo::app
