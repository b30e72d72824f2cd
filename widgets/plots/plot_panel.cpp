#include "widgets/plots/plot_panel.hpp"

#include <QHBoxLayout>
#include <algorithm>

#include "widgets/plots/plot_pane.hpp"

namespace abrazo::widgets {
namespace {

constexpr double shortest_s = 1, longest_s = 60;

std::vector<double> energies(const FrameSnapshot& frame) {
  const FrameEnergy& e = frame.result.energy;
  return {e.deformation, e.velocity, e.constraint};
}

std::vector<double> residuals(const FrameSnapshot& frame) {
  const FrameResidual& r = frame.result.residual;
  return {100 * r.bone_length_max, 1000 * r.foot_lock_max_m, 1000 * r.excess_penetration_max_m};
}

}  // namespace

struct PlotPanel::Parts {
  PlotPane* energy = nullptr;
  PlotPane* residual = nullptr;
  std::uint64_t next_index = 0;
  double span_s = 20;
  double to_s = 0;  ///< right end of the window
  double cursor_s = 0;
};

PlotPanel::PlotPanel(QWidget* parent) : QWidget(parent), m_parts(std::make_unique<Parts>()) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  using Curves = std::vector<PlotPane::Curve>;
  m_parts->energy = new PlotPane(
      "Energy", Curves{{"deformation", "", 3}, {"velocity", "", 3}, {"constraint", "", 3}}, this);
  m_parts->residual = new PlotPane(
      "Residuals", Curves{{"bones", "%", 2}, {"foot lock", "mm", 1}, {"penetration", "mm", 1}}, this);
  m_parts->energy->setToolTip(
      "Energies of Eq. 11 at the result [m²]: E_L deformation, E_V velocity, E_C constraint");
  m_parts->residual->setToolTip(
      "How far the nonlinear constraints are from being met: largest bone length error, largest drift of a "
      "locked "
      "foot, deepest penetration beyond the selected pair's own");
  m_parts->residual->setLeastHeight(0.5);
  for (PlotPane* pane : {m_parts->energy, m_parts->residual}) {
    row->addWidget(pane, 1);
    connect(pane, &PlotPane::seekRequested, this, &PlotPanel::seekRequested);
    connect(pane, &PlotPane::zoomRequested, this, [this](double factor) {
      m_parts->span_s = std::clamp(m_parts->span_s * factor, shortest_s, longest_s);
    });
  }
  setMinimumHeight(110);
  setColours(palette_of(Theme::Dark));
}

PlotPanel::~PlotPanel() = default;

void PlotPanel::setColours(const Palette& p) {
  m_parts->energy->setColours(p, {p.energy_deformation, p.energy_velocity, p.energy_constraint});
  m_parts->residual->setColours(p, {p.residual_bones, p.residual_locks, p.residual_penetration});
}

void PlotPanel::clear() {
  m_parts->next_index = 0;
  m_parts->energy->clear();
  m_parts->residual->clear();
}

double PlotPanel::cursorX() const {
  return m_parts->energy->x() + m_parts->energy->xOf(m_parts->cursor_s);
}

void PlotPanel::refresh(const FrameHistory& history, const Playback& playback,
                        const FrameSnapshotPtr& shown) {
  Parts& p = *m_parts;
  for (const FrameSnapshotPtr& frame : history.since(p.next_index)) {
    p.next_index = frame->index + 1;
    p.energy->append(frame->time_s, energies(*frame));
    p.residual->append(frame->time_s, residuals(*frame));
  }
  p.energy->dropBefore(playback.first_s);
  p.residual->dropBefore(playback.first_s);
  p.cursor_s = playback.cursor_s;
  // Following keeps the newest at the right edge, once there is more than fits; else the window moves only
  // when the cursor would leave it.
  if (playback.state == Playback::State::Following)
    p.to_s = std::max(playback.last_s, playback.first_s + p.span_s);
  p.to_s = std::clamp(p.to_s, playback.cursor_s, playback.cursor_s + p.span_s);
  p.energy->showValues(shown ? energies(*shown) : std::vector<double>{});
  p.residual->showValues(shown ? residuals(*shown) : std::vector<double>{});
  p.energy->draw(p.to_s - p.span_s, p.to_s, p.cursor_s);
  p.residual->draw(p.to_s - p.span_s, p.to_s, p.cursor_s);
}

}  // namespace abrazo::widgets
