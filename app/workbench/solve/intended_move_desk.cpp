#include "app/workbench/solve/intended_move_desk.hpp"

#include <QToolButton>
#include <algorithm>
#include <map>

#include "app/workbench/shell/main_window.hpp"
#include "core/session/frames/decision_edits.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/intended/intended_move_popup.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

using widgets::IntendedMoveChoice;

constexpr int refresh_interval_ms = 300;
constexpr double answered_within_s = 0.5;  // by then a frame has been solved with the declaration
const QPoint chip_place(12, 46);           // in the scene, below the choice of what colours the mesh

using widgets::text;

}  // namespace

IntendedMoveDesk::IntendedMoveDesk(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_popup(new widgets::IntendedMovePopup(&window)),
      m_chip(new QToolButton(&window.scene())) {
  window.colour(m_popup);
  m_chip->setObjectName("chip");
  m_chip->setFocusPolicy(Qt::NoFocus);
  m_chip->setToolTip("Only this is selected. A click cancels it (W)");
  m_chip->hide();
  connect(m_chip, &QToolButton::clicked, this, &IntendedMoveDesk::takeBack);
  connect(m_popup, &widgets::IntendedMovePopup::chosen, this, &IntendedMoveDesk::declare);
  connect(&window.document(), &Document::ending, m_popup, &widgets::IntendedMovePopup::leave);
  connect(&window.ticker(), &FrameTicker::panelsDue, this, &IntendedMoveDesk::onPanels);
  m_refresh.setInterval(refresh_interval_ms);
  connect(&m_refresh, &QTimer::timeout, this, &IntendedMoveDesk::refreshDistances);
  m_refresh.start();
}

void IntendedMoveDesk::toggle() {
  if (m_popup->isVisible()) return m_popup->leave();
  m_window.document().decisions().meant ? takeBack() : offer();
}

void IntendedMoveDesk::offer() {
  if (!m_window.session()) return m_window.messages().showInformation("Nothing is open yet");
  auto offered = choices();
  if (offered.empty())
    return m_window.messages().showInformation("The library has no move or take to choose");
  m_popup->setChoices(std::move(offered));
  m_popup->openOver(m_window.scene());
}

/// Moves with the distance of their nearest pair; takes with that of their nearest candidate, if they have
/// one.
std::vector<IntendedMoveChoice> IntendedMoveDesk::choices() const {
  std::vector<IntendedMoveChoice> found;
  for (const MeantChoice& choice : m_window.session()->engine().meant_choices())
    found.push_back({choice.label, {}, choice.pairs, choice.feature_distance});
  const MotionLibrary& library = *m_window.session()->material().library;
  std::map<std::size_t, double> nearest;
  if (const FrameSnapshotPtr newest =
          in_library(m_window.session()->engine().latest().newest(), m_window.session()->material().library))
    for (const Candidate& candidate : newest->result.candidates) {
      if (candidate.pair < 0 || candidate.pair >= library.pair_count()) continue;
      const auto take = static_cast<std::size_t>(library.source(candidate.pair).take);
      const auto known = nearest.emplace(take, candidate.feature_distance).first;
      known->second = std::min(known->second, candidate.feature_distance);
    }
  for (std::size_t take = 0; take < library.takes().size(); ++take) {
    const auto distance = nearest.find(take);
    found.push_back({{},
                     library.takes()[take].name,
                     library.takes()[take].frames,
                     distance == nearest.end() ? -1 : distance->second});
  }
  return widgets::in_order(std::move(found));
}

/// Only the figures: rows that change places would take a digit for another move.
void IntendedMoveDesk::refreshDistances() {
  if (!m_popup->isVisible() || !m_window.session()) return;
  const auto fresh = choices();
  auto shown = m_popup->choices();
  for (IntendedMoveChoice& choice : shown)
    for (const IntendedMoveChoice& other : fresh)
      if (other.label == choice.label && other.take == choice.take) choice.distance_m = other.distance_m;
  m_popup->setChoices(std::move(shown));
}

void IntendedMoveDesk::declare(const IntendedMoveChoice& choice, widgets::IntendedMoveSpan span) {
  // Of a clip it is meant from its beginning.
  m_since_s = m_window.session()->material().is_clip() ? 0 : m_window.session()->engine().clock().now_s();
  Decisions next = m_window.document().decisions();
  next.meant = widgets::meant_move(choice, span, m_since_s);
  m_window.document().change(next, "intend " + text(widgets::choice_title(choice)));
  showChip();
}

void IntendedMoveDesk::takeBack() {
  Decisions next = m_window.document().decisions();
  if (!next.meant) return;
  next.meant.reset();
  m_window.document().change(next, "cancel the intended move");
  showChip();
}

/// The solver ends it by itself when its time is over or the move is done.
void IntendedMoveDesk::onPanels() {
  const Decisions& decisions = m_window.document().decisions();
  const FrameSnapshotPtr newest =
      m_window.session() ? m_window.session()->engine().latest().newest() : nullptr;
  const bool is_live = m_window.session() && !m_window.session()->material().is_clip();
  if (is_live && decisions.meant && newest && newest->time_s > m_since_s + answered_within_s &&
      !(newest->decisions && newest->decisions->meant)) {
    Decisions rest = decisions;
    rest.meant.reset();
    m_window.document().put(rest);
  }
  showChip();
}

void IntendedMoveDesk::showChip() {
  const auto& meant = m_window.document().decisions().meant;
  m_chip->setVisible(meant.has_value());
  if (!meant) return;
  const QString words = "intended: " + text(meant_words(*meant)) + "  ✕";
  if (words == m_chip->text()) return;
  m_chip->setText(words);
  m_chip->setAccessibleName("Cancel it, " + words);
  m_chip->adjustSize();
  m_chip->move(chip_place);
  m_chip->raise();
}

}  // namespace abrazo::app
