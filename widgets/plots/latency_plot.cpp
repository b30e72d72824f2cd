#include "widgets/plots/latency_plot.hpp"

#include <qcustomplot.h>

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "widgets/common/latency_sample.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/plots/plot_colours.hpp"

namespace abrazo::widgets {
namespace {

constexpr int column_px = 3;
constexpr double least_reach_ms = 2;
/// Send follows Solve; drawing the scene is parallel and not part of the output latency.
constexpr LatencyStage stacked[] = {LatencyStage::Assembly, LatencyStage::Wait, LatencyStage::Solve,
                                    LatencyStage::Send};

/// In to out; of a clip, that has no packets, the step alone.
double way_ms(const LatencySample& sample) {
  return std::isfinite(sample.end_to_end) ? sample.end_to_end : sample.stage(LatencyStage::Solve);
}

double or_zero(double ms) {
  return std::isfinite(ms) ? ms : 0;
}

}  // namespace

std::vector<LatencySample> slowest_of_each(std::span<const LatencySample> samples, double from_s, double to_s,
                                           int columns) {
  std::vector<LatencySample> slowest;
  if (columns < 1 || !(to_s > from_s)) return slowest;
  int last = -1;
  for (const LatencySample& sample : samples) {
    if (sample.time_s < from_s || sample.time_s > to_s || !std::isfinite(way_ms(sample))) continue;
    const int column =
        std::min(columns - 1, static_cast<int>((sample.time_s - from_s) / (to_s - from_s) * columns));
    if (column != last)
      slowest.push_back(sample);
    else if (way_ms(sample) > way_ms(slowest.back()))
      slowest.back() = sample;
    last = column;
  }
  return slowest;
}

LatencyPlot::LatencyPlot(QWidget* parent)
    : QWidget(parent), m_palette(palette_of(Theme::Dark)), m_plot(new QCustomPlot(this)) {
  setAccessibleName("Latency over time");
  setMinimumSize(160, 80);
  auto* column = column_in(this, {4, 4, 8, 4});
  column->addWidget(m_plot);
  setUp();
  setColours(m_palette);
}

void LatencyPlot::setUp() {
  m_plot->setFocusPolicy(Qt::NoFocus);
  m_plot->axisRect()->setAutoMargins(QCP::msLeft | QCP::msBottom);
  m_plot->axisRect()->setMinimumMargins({34, 4, 2, 4});
  m_plot->xAxis->setTicker(QSharedPointer<QCPAxisTickerTime>::create());
  m_plot->xAxis->ticker().staticCast<QCPAxisTickerTime>()->setTimeFormat("%m:%s");
  m_plot->yAxis->ticker()->setTickCount(4);
  m_plot->setNotAntialiasedElements(QCP::aeAll);
  // Areas lie over one another down to the axis, so the highest is drawn first.
  for (std::size_t i = 0; i < std::size(stacked); ++i) {
    m_stages.insert(m_stages.begin(), m_plot->addGraph());
    m_stages.front()->setLineStyle(QCPGraph::lsStepCenter);
  }
  m_total = m_plot->addGraph();
  m_total->setLineStyle(QCPGraph::lsStepCenter);
  m_cursor = new QCPItemLine(m_plot);
  m_cursor->start->setTypeY(QCPItemPosition::ptAxisRectRatio);
  m_cursor->end->setTypeY(QCPItemPosition::ptAxisRectRatio);
  m_cursor->setClipToAxisRect(true);
  const auto seek = [this](const QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) emit seekRequested(m_plot->xAxis->pixelToCoord(event->pos().x()));
  };
  connect(m_plot, &QCustomPlot::mousePress, this, seek);
  connect(m_plot, &QCustomPlot::mouseMove, this, seek);
  m_plot->setToolTip("The slowest frame of each column, stage by stage [ms]; a click goes there");
}

void LatencyPlot::setColours(const Palette& palette) {
  m_palette = palette;
  set_frame_colours(*m_plot, palette);
  m_plot->yAxis->setLabel("ms");
  for (std::size_t i = 0; i < std::size(stacked); ++i) {
    const QColor colour = latency_colour(stacked[i], palette);
    m_stages[i]->setPen(Qt::NoPen);
    m_stages[i]->setBrush(QBrush(mixed(colour, palette.panel, 0.85)));
  }
  m_total->setPen(QPen(palette.text, 1));
  m_cursor->setPen(QPen(palette.dark ? QColor("#c7ccd6") : palette.text, 1));
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

double LatencyPlot::upperEnd() const {
  return m_plot->yAxis->range().upper;
}

void LatencyPlot::show(std::span<const LatencySample> samples, double from_s, double to_s, double cursor_s) {
  const int columns = std::max(20, m_plot->axisRect()->width() / column_px);
  m_columns = slowest_of_each(samples, from_s, to_s, columns);
  fill();
  m_plot->xAxis->setRange(from_s, to_s);
  m_cursor->start->setCoords(cursor_s, 0);
  m_cursor->end->setCoords(cursor_s, 1);
  m_plot->replot(QCustomPlot::rpQueuedRefresh);
}

void LatencyPlot::fill() {
  std::vector<double> ways;
  QVector<QCPGraphData> total;
  std::vector<QVector<QCPGraphData>> areas(std::size(stacked));
  for (const LatencySample& sample : m_columns) {
    double height = 0;
    for (std::size_t i = 0; i < std::size(stacked); ++i) {
      height += or_zero(sample.stage(stacked[i]));
      areas[i].push_back({sample.time_s, height});
    }
    ways.push_back(std::max(height, way_ms(sample)));
    total.push_back({sample.time_s, way_ms(sample)});
  }
  for (std::size_t i = 0; i < areas.size(); ++i) m_stages[i]->data()->set(areas[i], true);
  m_total->data()->set(total, true);
  m_upper.show(robust_upper(std::move(ways)), m_columns.empty() ? 0 : m_columns.back().time_s);
  m_plot->yAxis->setRange(0, std::max(m_upper.upper(), least_reach_ms));
}

void LatencyPlot::resizeEvent(QResizeEvent*) {
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace abrazo::widgets
