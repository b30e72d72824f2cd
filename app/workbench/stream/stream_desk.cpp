#include "app/workbench/stream/stream_desk.hpp"

#include <QApplication>
#include <algorithm>
#include <utility>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/offer_bar.hpp"
#include "widgets/scene/panel/scene_tree.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/stream/address_form.hpp"
#include "widgets/stream/connection_panel.hpp"
#include "widgets/stream/scene_notice.hpp"
#include "widgets/stream/sink_list.hpp"
#include "widgets/stream/stream_words.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::AddressForm;
using widgets::ConnectionPanel;
using widgets::SinkList;
using widgets::StreamMark;
using widgets::UserInput;

constexpr int poll_ms = 250, calibration_ms = 50;
constexpr int most_recent_streams = 8;
constexpr const char* calibration_job = "calibration";

/// Why nothing of use comes in.
QString short_state(const StreamHealth& health) {
  switch (health.state) {
    case StreamHealth::State::Waiting:
      return "waiting";
    case StreamHealth::State::Stalled:
      return "stalled";
    case StreamHealth::State::Failed:
      return "failed";
    case StreamHealth::State::Receiving:
      break;
  }
  return "not tracked";
}

QStringList with_first(QStringList list, const QString& first) {
  list.removeAll(first);
  list.prepend(first);
  return list.mid(0, most_recent_streams);
}

}  // namespace

StreamDesk::StreamDesk(MainWindow& window, ConnectionPanel& panel)
    : QObject(&window),
      m_window(window),
      m_panel(panel),
      m_notice(new widgets::SceneNotice(&window.scene())),
      m_question(new widgets::OfferBar) {
  setObjectName("stream desk");
  m_question->setObjectName("which user");
  window.addBelowMessages(m_question);
  window.colour(m_question.data());
  panel.form().setRecent(recent());
  if (!recent().isEmpty()) panel.form().setUri(recent().front());
  connect(&panel.form(), &AddressForm::connectRequested, this, &StreamDesk::connectTo);
  connect(&panel.form(), &AddressForm::disconnectRequested, this, &StreamDesk::disconnectStream);
  connect(&panel, &ConnectionPanel::userChosen, this, &StreamDesk::setUser);
  connect(&panel, &ConnectionPanel::secondChosen, this, &StreamDesk::setSecond);
  connect(&panel, &ConnectionPanel::calibrateRequested, this, &StreamDesk::calibrate);
  connect(&panel, &ConnectionPanel::forgetRequested, this, &StreamDesk::forgetCalibration);
  connect(&panel, &ConnectionPanel::delayRequested, this, [this](int ms) {
    if (engine() && engine()->receiver()) engine()->receiver()->set_delay(ms / 1000.0);
  });
  connect(&panel, &ConnectionPanel::stepRateRequested, this,
          [this](const QString& value) { m_window.document().changeSetting("step-rate", value); });
  connect(&panel.sinks(), &SinkList::sendRequested, this, &StreamDesk::send);
  connect(&panel.sinks(), &SinkList::stopRequested, this, &StreamDesk::stopSending);
  connect(&window.document(), &Document::began, this, &StreamDesk::beginSession);
  window.colour(m_notice.data());
  connect(&m_poll, &QTimer::timeout, this, &StreamDesk::poll);
  m_poll.start(poll_ms);
  connect(&m_soon, &QTimer::timeout, this, &StreamDesk::advanceCalibration);
  m_soon.setInterval(calibration_ms);
}

SessionEngine* StreamDesk::engine() const {
  return m_window.session() ? &m_window.session()->engine() : nullptr;
}

QStringList StreamDesk::recent() const {
  return m_window.remembered().recentStreams();
}

void StreamDesk::connectTo(const QString& text) {
  const auto uri = parse_stream_uri(text.toStdString());
  if (!uri) return m_window.messages().showError(words(uri.error()));
  if (uri->scheme == StreamUri::Scheme::Clip) {
    if (!engine()) disconnectStream();  // a session may go on, with its stream
    return m_window.openFiles({QString::fromStdString(uri->file)});
  }
  const QString before = isConnected() && text != m_uri ? m_uri : QString();
  disconnectStream();
  m_before = before;
  m_returns = false;
  m_isAsked = true;
  look(*uri, text);
}

void StreamDesk::look(const StreamUri& uri, const QString& text) {
  m_uri = text;
  m_window.setWantsStream(true);
  m_panel.form().setUri(text);
  m_sourceLookup.find(uri, [this](const Result<StreamUri>& found) {
    if (!found) return refuse(found.error());
    m_found = *found;
    receiveOnceFound();
  });
  if (m_found || !isConnected()) return;
  poll();
  emit connectionChanged();  // so that it can be cancelled
}

/// Nothing is connected any more, but what was before.
void StreamDesk::refuse(const Error& error) {
  m_window.fail(words(error));
  m_isAsked = false;
  m_uri.clear();
  m_window.setWantsStream(false);
  m_found.reset();
  poll();
  emit connectionChanged();
  // What worked goes on: a slip of the keys must not end it, least of all while it is recorded.
  const QString before = std::exchange(m_before, {});
  const auto uri = parse_stream_uri(before.toStdString());
  if (before.isEmpty() || !uri) return;
  m_returns = true;
  look(*uri, before);
}

void StreamDesk::receiveOnceFound() {
  if (!m_found || !engine() || engine()->receiver()) return;
  if (m_window.session()->material().is_clip()) return leaveClip();
  bool ready = true;
  emit addressFound(ready);
  if (ready) receive();
}

/// A stream has a session of its own, on the same library: the clip is a document that is closed.
void StreamDesk::leaveClip() {
  const bool leaves = m_window.openMaterial([next = for_next_session(m_window.session()->material())](
                                                const Progress&) { return Result<Material>(next); });
  if (leaves) return;  // the session that begins opens the stream
  const QString uri = m_uri;
  disconnectStream();
  m_window.messages().showInformation(uri + " was not connected; the clip stays open");
}

/// @return whether the stream is open; if not, nothing is connected any more
bool StreamDesk::receive() {
  emit aboutToReceive();
  if (const Status opened = engine()->receive(*m_found, m_user.toStdString()); !opened) {
    refuse(opened.error());
    return false;
  }
  m_before.clear();
  if (!m_returns) m_window.messages().withdrawErrorsOf("open");
  m_window.remembered().setRecentStreams(with_first(recent(), m_uri));
  m_panel.form().setRecent(recent());
  const auto delay = milliseconds_option(*m_found, "delay", 500);
  m_panel.setDelay(delay && *delay ? static_cast<int>(1000 * **delay) : 0);
  if (std::exchange(m_isAsked, false)) leaveForm();
  showLiveEnd();
  poll();
  emit connectionChanged();
  return true;
}

/// The keys are the session's again. Whoever went on elsewhere in the meantime stays there.
void StreamDesk::leaveForm() {
  const QWidget* focused = QApplication::focusWidget();
  if (!focused || !m_panel.form().isAncestorOf(focused)) return;
  m_window.scene().activateWindow();  // the panel may float
  m_window.scene().setFocus();
}

/// The live end is the session's: while a take is annotated, its cursor stays where it is.
void StreamDesk::showLiveEnd() {
  if (m_window.document().subject().empty()) m_window.ticker().follow();
}

void StreamDesk::disconnectStream() {
  if (!isConnected()) return;
  emit aboutToDisconnect();
  dropCalibration();
  m_sourceLookup.cancel();
  m_isAsked = false;
  m_before.clear();
  const bool was_open = engine() && engine()->receiver();
  m_uri.clear();
  m_window.setWantsStream(false);
  m_found.reset();
  m_user.clear();
  m_second.clear();
  m_panel.setParts({}, {});
  if (engine()) engine()->stop_receiving();
  if (was_open && !m_window.session()->material().input_plays())
    m_window.messages().showInformation(
        QString("Disconnected: the partner stands still%1. Live > Back to the clip opens the one before")
            .arg(m_sinks.empty() ? "" : ", and nothing is sent"));
  poll();
  emit connectionChanged();
}

/// What the receiver that ends had measured, and what was said of it.
void StreamDesk::dropCalibration() {
  m_calibration.cancel();
  m_soon.stop();
  m_panel.showCalibration({}, false);
  m_window.messages().withdrawErrorsOf(calibration_job);
}

/// Another library keeps the stream; a motion that the user asked for takes the user's part. Of those that
/// were asked for at the start it is the stream.
void StreamDesk::beginSession() {
  const Material& material = m_window.session()->material();
  const bool ends_stream = material.is_input_asked && m_hasBegun;
  const bool was_calibrated = userHealth() && userHealth()->calibrated;
  m_hasBegun = true;
  m_inputWords.clear();  // the window has just named the clip
  for (const Sink& sink : std::exchange(m_sinks, {})) send(sink.uri, sink.character);
  if (!isConnected()) return;
  const QString was = m_uri;
  if (ends_stream) {
    disconnectStream();
    return m_window.messages().showInformation(
        QString("%1 plays the user; %2 was disconnected%3")
            .arg(QString::fromStdString(material.input.name), was,
                 was_calibrated ? ", and its calibration ended" : QString()));
  }
  dropCalibration();
  if (was_calibrated)
    m_window.messages().showInformation(was + " goes on without its calibration; Ctrl+T calibrates again");
  // After all other receivers, because the recorder must know its file by then.
  QTimer::singleShot(0, this, [this] { receiveOnceFound(); });
}

void StreamDesk::send(const QString& text, Character character) {
  const auto uri = parse_stream_uri(text.toStdString());
  if (!uri) return m_window.messages().showError(words(uri.error()));
  if (!engine()) return m_window.messages().showError("There is nothing to send yet; open a library first");
  m_sinkLookup.find(*uri, [this, character](const Result<StreamUri>& found) {
    if (!found) return m_window.messages().showError(words(found.error()));
    sendTo(*found, character);
  });
}

void StreamDesk::sendTo(const StreamUri& uri, Character character) {
  if (!engine()) return;  // it ended while the name was looked for
  if (const Status opened = engine()->send(uri, character); !opened)
    return m_window.messages().showError(words(opened.error()));
  const QString text = QString::fromStdString(uri.text);
  std::erase_if(m_sinks, [&text](const Sink& sink) { return sink.uri == text; });
  m_sinks.push_back({text, character});
  m_window.remembered().setRecentSinks(with_first(m_window.remembered().recentSinks(), text));
  poll();
}

void StreamDesk::stopSending(const QString& uri) {
  std::erase_if(m_sinks, [&uri](const Sink& sink) { return sink.uri == uri; });
  if (engine()) engine()->stop_sending(uri.toStdString());
  poll();
}

void StreamDesk::setUser(const QString& performer) {
  if (performer == m_second) m_second = user();  // they change places
  m_user = performer;
  if (engine() && isConnected()) engine()->follow_performer(performer.toStdString());
  m_panel.setParts(m_user, m_second);
}

void StreamDesk::setSecond(const QString& performer) {
  m_second = performer;
  m_panel.setParts(m_user, m_second);
}

const PerformerHealth* StreamDesk::userHealth() const {
  if (!m_health) return nullptr;
  // Without a name it is the one that is followed: another, when the first stopped.
  const std::string user = m_user.isEmpty() ? m_health->followed : m_user.toStdString();
  for (const PerformerHealth& one : m_health->performers)
    if (user.empty() || one.performer == user) return &one;
  return nullptr;
}

QString StreamDesk::user() const {
  const PerformerHealth* health = userHealth();
  return health ? QString::fromStdString(health->performer) : m_user;
}

void StreamDesk::calibrate() {
  if (m_calibration.is_under_way()) {
    m_calibration.cancel();
    m_soon.stop();
    m_panel.showCalibration("Cancelled; the calibration is unchanged", false);
    return showNotice();
  }
  if (!isConnected() || !userHealth())
    return m_window.messages().showError(
        "There is no performer to calibrate: connect to a stream first (Live > Connect to a stream) and wait "
        "until "
        "a performer "
        "is seen");
  showLiveEnd();
  m_calibration.start(engine()->clock().now_s());
  m_soon.start();
  advanceCalibration();
}

void StreamDesk::advanceCalibration() {
  const auto receiver = engine() ? engine()->receiver() : nullptr;
  if (!receiver || !m_calibration.is_under_way()) return m_soon.stop();
  const double now_s = engine()->clock().now_s();
  m_health = receiver->health();
  const PerformerHealth* user_health = userHealth();
  const std::string name = user().toStdString();
  CalibrationSteps::Seen seen{user_health && user_health->tracked, receiver->measured_body(name), {}};
  if (user_health) seen.doubts = user_health->calibration_doubts;
  if (m_calibration.advance(now_s, seen)) receiver->calibrate(name, CalibrationSteps::hold_s);
  const QString said = QString::fromStdString(m_calibration.words());
  m_panel.showCalibration(said, m_calibration.is_under_way());
  if (m_calibration.is_under_way()) {
    const bool counts = m_calibration.stage() == CalibrationSteps::Stage::Countdown;
    m_notice->say(QString::fromStdString(m_calibration.large(now_s)), counts ? said : QString(),
                  "Ctrl+T cancels");
    return;
  }
  m_soon.stop();
  const QString brief = QString::fromStdString(m_calibration.brief());
  if (m_calibration.stage() != CalibrationSteps::Stage::Done)
    m_window.messages().showError(brief);
  else if (m_calibration.is_doubtful())  // the panel has all of it, the scene should be seen
    m_window.messages().showErrorOf(
        calibration_job, brief + ". Ctrl+T calibrates again, Live > Forget the calibration undoes it");
  else
    m_window.messages().succeed(calibration_job, brief);
  poll();
}

void StreamDesk::forgetCalibration() {
  if (!isConnected() || !engine()) return;
  m_calibration.cancel();
  m_window.messages().withdrawErrorsOf(calibration_job);
  engine()->stop_receiving();
  if (receive()) m_panel.showCalibration("Reset; the rest pose is the sender's again", false);
}

void StreamDesk::poll() {
  SessionEngine* running = engine();
  const auto receiver = running ? running->receiver() : nullptr;
  m_health = receiver && isConnected() ? std::optional(receiver->health()) : std::nullopt;
  m_cores.keep(m_health && m_health->state == StreamHealth::State::Receiving);
  m_panel.showHealth(m_health ? &*m_health : nullptr);
  m_panel.setStepRate(m_window.document().settings().step_rate_hz);
  m_panel.showSinks(running ? m_rates.update(running->sinks(), running->clock().now_s())
                            : std::vector<widgets::SinkRow>{});
  showInput();
  showNotice();
  askForUser();
  emit polled();
}

/// Where the window names the user's input.
void StreamDesk::showInput() {
  if (!m_window.session()) return;
  const Material& material = m_window.session()->material();
  if (!m_health) {
    const auto from = material.input_plays() ? UserInput::Clip : UserInput::None;
    nameInput(title_of_input(material));
    m_window.sceneTree().setInputName(material.input_plays() ? "clip" : "recorded");
    m_window.transport().showUserInput(from);
    return m_window.status().showInput({name_of_input(material), from, material.input.fps});
  }
  const PerformerHealth* user_health = userHealth();
  const bool comes = m_health->state == StreamHealth::State::Receiving && user_health && user_health->tracked;
  const QString name = streamName() + (comes ? QString() : " · " + short_state(*m_health));
  nameInput(comes ? QString("%1 · %2 Hz").arg(name).arg(user_health->rate_hz, 0, 'f', 0) : name,
            QString::fromStdString(widgets::headline_of(&*m_health).detail));
  const auto from = comes ? UserInput::Stream : UserInput::None;
  m_window.transport().showUserInput(from);
  m_window.status().showInput(
      {name, from, user_health ? user_health->rate_hz : 0, user_health ? user_health->lost : 0});
  m_window.sceneTree().setInputName("stream");
}

/// The stream by its performer and sender.
QString StreamDesk::streamName() const {
  return QString::fromStdString(widgets::stream_name(*m_health, user().toStdString()));
}

/// Only when it is another: others may write there, too.
void StreamDesk::nameInput(const QString& words, const QString& detail) {
  if (words == m_inputWords) return;
  m_inputWords = words;
  m_window.transport().setInput(words, detail);
}

/// The notice over the scene; none for past frames.
void StreamDesk::showNotice() {
  if (!m_notice || m_calibration.is_under_way()) return;
  const bool follows = m_window.ticker().playback().state == Playback::State::Following;
  if (isConnected() && !m_found)
    return m_notice->say({}, "Looking up the address of " + m_uri, "Live > Disconnect cancels");
  if (!m_health) return m_notice->clear();
  // That it ended concerns also who looks at earlier frames, most of all while they are recorded.
  const bool has_ended =
      m_health->state == StreamHealth::State::Stalled || m_health->state == StreamHealth::State::Failed;
  if (!follows && !has_ended) return m_notice->clear();
  const QString advice =
      m_health->diagnoses.empty() ? QString() : QString::fromStdString(m_health->diagnoses.front().text);
  const PerformerHealth* user_health = userHealth();
  switch (m_health->state) {
    case StreamHealth::State::Waiting:
      return m_notice->say({}, "Waiting for the first packet of " + m_uri, advice);
    case StreamHealth::State::Stalled:
      return m_notice->badge(StreamMark::Warning, "No more packets: " + streamName());
    case StreamHealth::State::Failed:
      return m_notice->badge(StreamMark::Bad, streamName() + " failed. " + advice);
    case StreamHealth::State::Receiving:
      break;
  }
  if (!user_health) return m_notice->say({}, "Packets arrive, but no pose yet", advice);
  if (user_health->tracked) return m_notice->clear();
  m_notice->badge(StreamMark::Warning, "Tracking lost: " + user());
}

/// Of senders that began together only a person knows which one is the user. Whoever closes the question
/// leaves it at the one that is followed.
void StreamDesk::askForUser() {
  constexpr std::size_t most_answers = 3;  // the panel has all
  std::vector<std::string> open;
  if (m_health && m_user.isEmpty()) open = m_health->undecided;
  std::vector<std::string> asked = open;
  if (!open.empty()) asked.push_back(m_health->followed);  // another question when it is another
  if (!m_question || asked == m_asked) return;
  m_asked = asked;
  if (open.empty()) return m_question->hide();
  QStringList answers;
  for (const std::string& name : open)
    if (answers.size() < static_cast<int>(most_answers)) answers << QString::fromStdString(name);
  m_question->ask(QString("Who is the user? %1 senders began together; %2 is followed now")
                      .arg(open.size())
                      .arg(QString::fromStdString(m_health->followed)),
                  answers, [this](const QString& chosen) { setUser(chosen); });
}

}  // namespace abrazo::app
