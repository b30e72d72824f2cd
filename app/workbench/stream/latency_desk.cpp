#include "app/workbench/stream/latency_desk.hpp"

#include <QDockWidget>
#include <QStatusBar>
#include <algorithm>
#include <cmath>

#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/plots/latency_plot.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/stream/latency_button.hpp"
#include "widgets/stream/latency_rows.hpp"
#include "widgets/stream/latency_table.hpp"

namespace abrazo::app {
namespace {

using widgets::LatencySample;

constexpr int refresh_ms = 240;
constexpr double judged_s = 5, plotted_s = 10;
constexpr std::size_t interval_row = 0, way_row = 1 + widgets::latency_stage_count;

}  // namespace

LatencyDesk::LatencyDesk(MainWindow& window, const StreamDesk& stream)
    : QObject(&window), m_window(window), m_stream(stream), m_button(new widgets::LatencyButton(&window)) {
  setObjectName("latency desk");
  window.statusBar()->addPermanentWidget(m_button);
  makePanel();
  connect(m_button, &QAbstractButton::clicked, this, [this] {
    const bool on = !isPanelSeen();
    m_window.panels().want("latency", on);
    if (QDockWidget* dock = m_window.panels().panel("latency"); dock && on) dock->raise();
    m_sinceRefresh.invalidate();
  });
  window.colour(m_button);
  connect(&window.document(), &Document::ending, this, [this] { m_log.clear(); });
  connect(&window.document(), &Document::opened, this,
          [this] { m_button->setVisible(!m_window.session()->material().is_clip()); });
  connect(&window.ticker(), &FrameTicker::panelsDue, this, &LatencyDesk::refresh);
  connect(&window.scene(), &widgets::SceneView::pictureDrawn, this, &LatencyDesk::pictureDrawn);
}

void LatencyDesk::makePanel() {
  auto* content = new QWidget;
  auto* row = widgets::row_in(content, {}, 0);
  m_table = new widgets::LatencyTable(content);
  m_plot = new widgets::LatencyPlot(content);
  row->addWidget(m_table, 0, Qt::AlignTop);
  row->addWidget(m_plot, 1);
  const auto colour = [this](const widgets::Palette& palette) {
    m_table->setColours(palette);
    m_plot->setColours(palette);
  };
  colour(m_window.colours());
  connect(&m_window, &MainWindow::coloursChanged, this, colour);
  connect(m_plot, &widgets::LatencyPlot::seekRequested, &m_window.ticker(), &FrameTicker::seek);
  m_window.addPanel("latency", "Latency", content, Qt::BottomDockWidgetArea, false);
}

bool LatencyDesk::isPanelSeen() const {
  const QDockWidget* dock = m_window.panels().panel("latency");
  return dock && dock->isVisible() && !m_table->visibleRegion().isEmpty();
}

void LatencyDesk::refresh() {
  const FrameHistory* history = m_window.ticker().history();
  const FrameSnapshotPtr& shown = m_window.ticker().shown();
  if (m_window.session() && m_window.session()->looksElsewhere()) return;
  if (!history || !shown || (m_sinceRefresh.isValid() && m_sinceRefresh.elapsed() < refresh_ms)) return;
  m_sinceRefresh.start();
  m_log.follow(*history);
  const double to_s = shown->time_s, span_s = isPanelSeen() ? plotted_s : judged_s;
  const auto samples = m_log.range(*history, to_s - span_s, to_s);
  const auto first = std::find_if(samples.begin(), samples.end(),
                                  [to_s](const LatencySample& s) { return s.time_s >= to_s - judged_s; });
  const LatencySample here = m_log.of(*history, *shown);
  auto rows = widgets::latency_rows({first, samples.end()}, &here);
  const auto& health = m_stream.health();
  double delay_ms = 0;
  if (health)
    for (const PerformerHealth& performer : health->performers)
      delay_ms = std::max(delay_ms, performer.delay_ms);
  // The last frames before a stream stalled are no figure of now.
  const bool is_still = health && health->state != StreamHealth::State::Receiving &&
                        m_window.ticker().playback().state == Playback::State::Following;
  is_still ? m_button->show(nullptr, widgets::LatencyVerdict::None)
           : m_button->show(&rows[way_row],
                            widgets::verdict_of(rows[way_row].p95, delay_ms, rows[interval_row].p50));
  if (!isPanelSeen()) return;
  m_table->show(std::move(rows), QString("%1 s to here").arg(judged_s));
  m_plot->show(samples, to_s - plotted_s, to_s, to_s);
}

/// The latency to the screen counts only for frames shown live.
void LatencyDesk::pictureDrawn(const FrameSnapshotPtr& frame, double took_ms) {
  if (!frame || !m_window.session() || m_window.session()->looksElsewhere()) return;
  const bool follows = m_window.ticker().playback().state == Playback::State::Following;
  const double arrived_s = frame->times.arrived_s;
  const double age_s = m_window.session()->engine().clock().now_s() - arrived_s;
  if (m_window.ticker().history()) m_log.follow(*m_window.ticker().history());
  m_log.drawn(frame->index, took_ms, follows && arrived_s >= 0 ? 1000 * age_s : LatencySample::none);
}

}  // namespace abrazo::app
