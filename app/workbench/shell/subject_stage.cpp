#include "app/workbench/shell/subject_stage.hpp"

#include <QAction>
#include <QUndoCommand>
#include <cmath>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/document_views.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

/// By hand: then it stays so.
bool is_held(const MainWindow& window) {
  const QAction* hold = action_of(window, "solve.hold_the_input_still");
  return hold && hold->isChecked();
}

constexpr int ends_step_id = 0x656e64;  // "end"; no other command has it

QString words_of(const Playback::Ends& before, const Playback::Ends& after) {
  const bool is_in = before.in_s != after.in_s, is_out = before.out_s != after.out_s;
  if (is_in && is_out && after.in_s.has_value() == after.out_s.has_value())
    return after.in_s ? "set in and out" : "clear in and out";
  // Of an in behind the out, and the reverse, the other one is cleared.
  if (is_in && (after.in_s || !is_out)) return after.in_s ? "set in" : "clear in";
  return after.out_s ? "set out" : "clear out";
}

}  // namespace

/// In and out of a subject, changed by a person.
class EndsStep : public QUndoCommand {
 public:
  EndsStep(SubjectStage& stage, std::string subject, const Playback::Ends& before,
           const Playback::Ends& after, int drag)
      : QUndoCommand(words_of(before, after)),
        m_stage(stage),
        m_subject(std::move(subject)),
        m_before(before),
        m_after(after),
        m_drag(drag) {}

  int id() const override { return m_drag > 0 ? ends_step_id : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const EndsStep&>(*other);
    if (later.m_drag != m_drag || later.m_subject != m_subject) return false;
    m_after = later.m_after;
    setText(words_of(m_before, m_after));
    setObsolete(m_after == m_before);
    return true;
  }
  void undo() override { m_stage.restoreEnds(m_subject, m_before, text()); }
  void redo() override { m_stage.restoreEnds(m_subject, m_after, text()); }

 private:
  SubjectStage& m_stage;
  std::string m_subject;
  Playback::Ends m_before, m_after;
  int m_drag;
};

SubjectStage::SubjectStage(MainWindow& window) : m_window(window) {
  FrameTicker& ticker = window.ticker();
  QObject::connect(
      &ticker, &FrameTicker::endsChanged, &ticker,
      [this](const Playback::Ends& before, const Playback::Ends& after, int drag) {
        m_window.undoStack().push(new EndsStep(*this, m_window.document().subject(), before, after, drag));
      });
}

void SubjectStage::restoreEnds(const std::string& subject, const Playback::Ends& ends, const QString& what) {
  if (subject == m_window.document().subject()) return m_window.ticker().restoreEnds(ends);
  m_places[subject].set_ends(ends);
  m_window.messages().showInformation(
      QString("%1 of %2, which is not shown")
          .arg(what, subject.empty() ? "the session" : QString::fromStdString(subject)));
}

Status SubjectStage::show(const std::string& subject) {
  LiveSession* session = m_window.session();
  if (!session) return Error{"nothing is open yet; open a library or the demo first", ""};
  std::shared_ptr<const TakeFrames> take;
  if (!subject.empty()) {
    auto frames = TakeFrames::create(session->material().library, subject);
    if (!frames) return frames.error();
    take = *frames;
  }
  m_places[m_window.document().subject()] = m_window.ticker().playback();
  // The clip that plays the user pauses; a stream does not.
  const bool clip_waits = !subject.empty() && !session->engine().receiver() && !is_held(m_window);
  if (clip_waits != m_heldInput) session->push(PauseInput{clip_waits});
  m_heldInput = clip_waits;
  look(take);
  m_window.document().setSubject(subject);
  restore(subject);
  write(subject);
  return Done{};
}

void SubjectStage::look(const std::shared_ptr<const TakeFrames>& take) {
  LiveSession& session = *m_window.session();
  m_window.ticker().setSources(nullptr, nullptr);
  m_window.plots().clear();
  session.lookAt(take);
  m_take = take;
  m_window.timeline().showOtherFrames();
  m_window.timeline().showOfTake(take != nullptr);
  m_window.transport().showOfTake(take != nullptr);
  if (take) {
    m_window.ticker().setSources(&session.history(), &session.latest());
    m_window.ticker().setEnd(take->span().last_s);
    m_window.transport().setFrames(static_cast<long long>(take->span().frames));
  } else {
    show_frames_of_session(m_window);
  }
  m_window.ticker().setFrameRate(take ? take->fps() : 0);
}

void SubjectStage::restore(const std::string& subject) {
  const auto known = m_places.find(subject);
  Playback place;
  place.state = Playback::State::Parked;  // at the beginning
  if (known != m_places.end()) place = known->second;
  if (place.state == Playback::State::Playing) place.pause();
  m_window.ticker().resume(place);
  if (subject.empty()) return;
  m_window.timeline().showPlayback(m_window.ticker().playback());
  m_window.timeline().showAll();
}

void SubjectStage::write(const std::string& subject) {
  const Material& material = m_window.session()->material();
  if (m_take) {
    m_window.transport().setInput(
        QString("take %1 · %2 Hz").arg(QString::fromStdString(subject)).arg(m_take->fps(), 0, 'f', 0));
    return m_window.transport().setRate(m_take->fps());
  }
  m_window.transport().setInput(title_of_input(material));
  m_window.transport().setRate(material.input.fps);
}

void SubjectStage::renew() {
  const auto frames =
      TakeFrames::create(m_window.session()->material().library, m_window.document().subject());
  if (!frames) return;
  m_window.session()->lookAt(*frames);
  m_take = *frames;
}

void SubjectStage::forget() {
  m_take.reset();
  m_window.ticker().setFrameRate(0);
  m_places.clear();
  m_window.document().setSubject("");
  m_heldInput = false;
  m_window.timeline().showOfTake(false);
  m_window.transport().showOfTake(false);
}

}  // namespace abrazo::app
