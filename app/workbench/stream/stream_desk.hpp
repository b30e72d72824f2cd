#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/stream/cores_for_answers.hpp"
#include "app/workbench/stream/host_lookup.hpp"
#include "core/motion/body/clip.hpp"
#include "core/session/frames/command.hpp"
#include "core/stream/protocol/stream_health.hpp"
#include "core/stream/protocol/stream_uri.hpp"
#include "core/stream/receive/calibration_steps.hpp"
#include "widgets/stream/sink_rates.hpp"

namespace abrazo {
class SessionEngine;
class StreamReceiver;
}  // namespace abrazo

namespace abrazo::widgets {
class ConnectionPanel;
class OfferBar;
class SceneNotice;
enum class StreamMark;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MainWindow;

/// The live stream of the window: connection, health, calibration, sinks. A connection persists when another
/// library is opened, without its calibration, and ends when a motion that was opened plays the user.
class StreamDesk : public QObject {
  Q_OBJECT
 public:
  StreamDesk(MainWindow& window, widgets::ConnectionPanel& panel);

  /// Connects now, or as soon as there is a session. Errors are reported in the message bar.
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
  /// The performer that plays the user; empty until one appears.
  QString user() const;
  /// The second performer of a recorded pair; empty = none.
  const QString& second() const { return m_second; }

  /// Opens the stream that was asked for, if its address is known and it is not open yet.
  void receiveOnceFound();
  /// Starts a calibration, or cancels the running one.
  void calibrate();
  void forgetCalibration();
  const CalibrationSteps& calibration() const { return m_calibration; }

  /// Last polled health; none if not connected.
  const std::optional<StreamHealth>& health() const { return m_health; }
  void poll();

 signals:
  /// Emitted before a stream is opened, so that recording can include its first frame.
  void aboutToReceive();
  /// The address is known. Set `ready` to false to call receiveOnceFound() later.
  void addressFound(bool& ready);
  /// Emitted before what comes in ends, while it still plays the user.
  void aboutToDisconnect();
  /// The connection changed or ended.
  void connectionChanged();
  void polled();

 private:
  struct Sink {
    QString uri;
    Character character;
  };
  SessionEngine* engine() const;
  void refuse(const Error& error);
  void look(const StreamUri& uri, const QString& text);
  void leaveClip();
  bool receive();
  void leaveForm();
  void showLiveEnd();
  void sendTo(const StreamUri& uri, Character character);
  void beginSession();
  void dropCalibration();
  void showInput();
  void nameInput(const QString& words, const QString& detail = {});
  QString streamName() const;
  void showNotice();
  void askForUser();
  void advanceCalibration();
  const PerformerHealth* userHealth() const;

  MainWindow& m_window;
  widgets::ConnectionPanel& m_panel;
  QPointer<widgets::SceneNotice> m_notice;
  QPointer<widgets::OfferBar> m_question;
  std::vector<std::string> m_asked;  ///< the senders of whom it asks or asked, and the one followed then
  QString m_before;        ///< connected before the pending connection, which may fail; empty = none
  bool m_returns = false;  ///< to what was connected before
  bool m_isAsked = false;  ///< a person asked for the pending connection
  QString m_uri;           ///< present or pending connection; empty = none
  std::optional<StreamUri> m_found;  ///< the same with resolved addresses; none before
  HostLookup m_sourceLookup, m_sinkLookup;
  QString m_user, m_second;
  std::vector<Sink> m_sinks;
  widgets::SinkRates m_rates;
  std::optional<StreamHealth> m_health;
  CalibrationSteps m_calibration;
  QString m_inputWords;     ///< text passed to the window
  bool m_hasBegun = false;  ///< a session
  QTimer m_poll, m_soon;
  CoresForAnswers m_cores;  ///< while something comes in
};

}  // namespace abrazo::app
