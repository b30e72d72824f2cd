#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/workbench/takes/session_hold.hpp"
#include "core/session/edit/session_takes.hpp"
#include "core/session/edit/take_sequence.hpp"
#include "core/session/run/recorder.hpp"
#include "widgets/takes/recording_status.hpp"

namespace abrazo::widgets {
class Countdown;
class TakePanel;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MainWindow;

/// Recording of the running session: file, takes, and their display in panel, timeline and scene.
class TakeDesk : public QObject {
  Q_OBJECT
 public:
  TakeDesk(MainWindow& window, widgets::TakePanel& panel);
  ~TakeDesk() override;

  widgets::TakePanel& panel() const { return m_panel; }

  /// Starts a take, cancels its countdown, or ends it.
  void toggle();
  /// Ends the take, or cancels its countdown, before the stream of its performer ends: what plays the user
  /// afterwards is not of it.
  void endWithStream();
  /// Starts the next take of the same name.
  void again();
  bool isRecording() const { return m_sequence.phase == TakeSequence::Phase::Recording; }

  /// Records everything from now on, or only takes. A stream is not recorded into a file that a person saved:
  /// its frames are in the history until the next save.
  void keepEverything(bool on);
  /// Call before a stream is opened, so that its first frame is recorded too.
  void prepareStream();
  /// Whether prepareStream() need not wait for a worker to finish the file; if it has to, fileFinished()
  /// comes.
  bool isReadyForStream() const;

  const RecordedTakes& takes() const { return m_takes.list(); }
  void rename(std::int64_t id, const std::string& name);
  void remove(std::int64_t id);
  void restore(const RecordedTake& take);
  /// Sets in and out to the take, and the cursor to its beginning.
  void goTo(std::int64_t id);

  /// File of the session; empty = none.
  const QString& file() const { return m_file; }
  /// Continues the session in this file, which a person saved or opened. Not during recording. If another
  /// window has it open, it is read-only here, and a message says so.
  void setFile(const QString& file);
  /// Whether another window has the file open, and this one must not change it. Asks again.
  bool isReadOnly();
  /// Whether it is read-only; then it says so.
  bool refusesChange();
  /// The recorder of the file that a worker is finishing; null = none. The file can be written by others once
  /// finish() of it has returned.
  std::shared_ptr<Recorder> finishing() const { return m_finishing; }
  /// Edits of takes that are not yet in the file.
  const TakeEdits& edits() const { return m_takes.edits(); }
  int session() const { return m_session; }  ///< number of the session

  /// Where the frames of the session come from, for its file.
  RecordingFacts facts() const;

 signals:
  void fileChanged();
  /// A worker has finished the file of a recording that ended.
  void fileFinished();
  /// A take began, after its countdown.
  void begun();
  /// No take was made: cancelled in the countdown, a write error, or no input.
  void cameToNothing();
  /// A take ended and is in the list.
  void taken(qint64 id);

 private:
  void begin(const std::string& name, double countdown_s);
  void beginTake();
  void endTake(bool stopsRecorder = true);
  bool record();
  bool recordsStreams() const;
  bool hasPerformer() const;
  enum class Afterwards { Keep, Delete };
  void stopRecorder(Afterwards afterwards = Afterwards::Keep);
  bool isFinishingFile() const;
  void awaitFile();
  void discardIfUnused();
  void follow();
  void update();
  void showTakes();
  void takeFile();
  void onSessionEnding();
  void finishFile();
  void writeEdits();
  void writeMarkers();
  widgets::RecordingStatus status() const;
  double now() const;
  std::string freshName(const std::string& typed) const;

  MainWindow& m_window;
  widgets::TakePanel& m_panel;
  widgets::Countdown* m_countdown;
  QTimer m_timer;
  TakeSequence m_sequence;
  SessionTakes m_takes;
  QString m_file;
  SessionHold m_hold;  ///< of `m_file`
  std::shared_ptr<Recorder> m_finishing;
  std::optional<Markers> m_markersInFile;  ///< last passed to the recorder; none = not yet
  Recorder::State m_lastState;
  QString m_toldFailure;
  bool m_hasStream = false;
  bool m_isSaved = false;      ///< the file was saved or opened by a person
  bool m_isForStream = false;  ///< the file was created for a stream that is not connected yet
  int m_session = 0;
};

}  // namespace abrazo::app
