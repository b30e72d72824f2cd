#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/stream/host_lookup.hpp"
#include "core/motion/body/clip.hpp"
#include "core/session/frames/command.hpp"
#include "core/stream/protocol/stream_health.hpp"
#include "core/stream/protocol/stream_uri.hpp"
#include "core/stream/receive/calibration_steps.hpp"
#include "widgets/stream/sink_rates.hpp"

namespace abrazo {
class MotionLibrary;
class SessionEngine;
class StreamReceiver;
}  // namespace abrazo

namespace abrazo::widgets {
class ConnectionPanel;
class SceneNotice;
enum class StreamMark;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MainWindow;

/// The live stream of the window: connects, watches its health, calibrates, sends on. What is connected stays
/// so when another library is opened, and ends when another motion is to play the user.
class StreamDesk : public QObject {
  Q_OBJECT
 public:
  StreamDesk(MainWindow& window, widgets::ConnectionPanel& panel);

  /// Now, or as soon as there is a session. Errors are reported in the message bar.
  void connectTo(const QString& uri);
  void disconnectStream();
  bool isConnected() const { return !m_uri.isEmpty(); }
  const QString& uri() const { return m_uri; }
  /// Latest first.
  QStringList recent() const;

  void send(const QString& uri, Character character);
  void stopSending(const QString& uri);

  void setUser(const QString& performer);
  void setSecond(const QString& performer);
  /// Who plays the user; empty until a performer was seen.
  QString user() const;
  /// The other of a pair that is recorded; empty if none was chosen.
  const QString& second() const { return m_second; }

  /// Starts one, or ends the one that goes on.
  void calibrate();
  void forgetCalibration();
  const CalibrationSteps& calibration() const { return m_calibration; }

  /// As it was polled last; nothing when nothing is connected.
  const std::optional<StreamHealth>& health() const { return m_health; }
  void poll();

 signals:
  /// A stream is opened next: whoever keeps its first frame begins now.
  void aboutToReceive();
  /// Connected to something else, or to nothing.
  void connectionChanged();
  void polled();

 private:
  struct Sink {
    QString uri;
    Character character;
  };
  SessionEngine* engine() const;
  void receiveOnceFound();
  void refuse(const Error& error);
  bool receive();
  void sendTo(const StreamUri& uri, Character character);
  void beginSession();
  void showInput();
  void nameInput(const QString& words);
  void showNotice();
  void advanceCalibration();
  const PerformerHealth* userHealth() const;

  MainWindow& m_window;
  widgets::ConnectionPanel& m_panel;
  QPointer<widgets::SceneNotice> m_notice;
  QString m_uri;                     ///< connected to, or to be connected to; empty = nothing
  std::optional<StreamUri> m_found;  ///< the same with addresses in the place of names; nothing before
  HostLookup m_sourceLookup, m_sinkLookup;
  QString m_user, m_second;
  std::vector<Sink> m_sinks;
  widgets::SinkRates m_rates;
  std::optional<StreamHealth> m_health;
  CalibrationSteps m_calibration;
  QString m_inputName;   ///< of the session's clip
  QString m_inputWords;  ///< as given to the window
  std::shared_ptr<const MotionLibrary> m_library;
  QTimer m_poll, m_soon;
};

}  // namespace abrazo::app
