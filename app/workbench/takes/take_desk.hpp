#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

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

/// Recording of the running session: its file, its takes, and what the panel, the timeline and the scene show
/// of them.
class TakeDesk : public QObject {
  Q_OBJECT
 public:
  TakeDesk(MainWindow& window, widgets::TakePanel& panel);
  ~TakeDesk() override;

  widgets::TakePanel& panel() const { return m_panel; }

  /// Starts a take, gives up its countdown, or ends it.
  void toggle();
  /// Starts the next take of the same name.
  void again();
  bool isRecording() const { return m_sequence.phase == TakeSequence::Phase::Recording; }

  /// Everything that comes in is written from now on, or only takes.
  void keepEverything(bool on);
  /// Before a stream is opened: its first frame is to be on disk, too.
  void prepareStream();

  const RecordedTakes& takes() const { return m_takes.list(); }
  void rename(std::int64_t id, const std::string& name);
  void remove(std::int64_t id);
  void restore(const RecordedTake& take);
  /// In and out there, and the cursor at its beginning.
  void goTo(std::int64_t id);

  /// Where the session is kept; empty while it is not.
  const QString& file() const { return m_file; }
  /// A session that was opened from a file, with its takes.
  void setOpened(const QString& file, const SessionContents& contents);
  /// The session goes on in this file. Not while it is recorded.
  void setFile(const QString& file);
  /// What is still to be changed in the file, of its takes.
  const TakeEdits& edits() const { return m_takes.edits(); }
  int session() const { return m_session; }  ///< counts them

 signals:
  void fileChanged();
  /// A take has begun, after its countdown.
  void begun();
  /// No take came of it: it was ended in its countdown, cannot be written, or nothing came in.
  void cameToNothing();
  /// A take has ended and is on the list.
  void taken(qint64 id);

 private:
  void begin(const std::string& name, double countdown_s);
  void beginTake();
  void endTake();
  bool record();
  void stopRecorder();
  void discardIfUnused();
  void follow();
  void update();
  void showTakes();
  void onSessionEnding();
  void writeEdits();
  void writeMarkers();
  RecordingFacts facts() const;
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
  std::optional<Markers> m_markersInFile;  ///< as given to the recorder; nothing = not yet
  Recorder::State m_lastState;
  QString m_toldFailure;
  bool m_hasStream = false;
  bool m_isForStream = false;  ///< the file was begun for a stream that is not there yet
  int m_session = 0;
};

}  // namespace abrazo::app
