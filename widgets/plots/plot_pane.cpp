#include "widgets/plots/plot_pane.hpp"

#include <qcustomplot.h>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/common/parts.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/plots/plot_colours.hpp"

namespace abrazo::widgets {
namespace {

constexpr int head_height = 30;
constexpr int head_left = 12;
constexpr int menu_width = 26;
constexpr int labelled_height = 84;  // minimum height of the curves for time labels below them
constexpr double zoom_step = 0.85;
constexpr double pan_step = 0.2;  // of the span

/// A value below what matters must not look large: the axis reaches at least this far.
double least_reach(const PaneSeries& series) {
  if (series.empty()) return 1;
  const std::string_view unit = info_of(series.front()).unit;
  return unit == "mm" ? 0.5 : unit == "%" ? 0.01 : unit == "ms" ? 0.01 : unit == "per 100" ? 1 : 0;
}

/// Of a pane on paper.
QSize curves_of(QSize place) {
  return {place.width() - 20, place.height() - head_height - 6};
}

}  // namespace

PlotPane::PlotPane(QWidget* parent)
    : QWidget(parent),
      m_palette(palette_of(Theme::Dark)),
      m_plot(new QCustomPlot(this)),
      m_cursor(new QCPItemLine(m_plot)),
      m_pointer(new QCPItemLine(m_plot)),
      m_menu(new QToolButton(this)) {
  setFocusPolicy(Qt::StrongFocus);
  m_menu->setObjectName("flat");
  m_menu->setText("⋯");
  m_menu->setFocusPolicy(Qt::NoFocus);  // the menu key opens the same
  show_under_pointer(*this, *m_menu);
  connect(m_menu, &QToolButton::clicked, this,
          [this] { emit menuRequested(m_menu->mapToGlobal(QPoint(0, m_menu->height()))); });
  setUpPlot();
  setUpMouse();
}

void PlotPane::setUpPlot() {
  m_plot->setObjectName("curves");
  m_plot->setFocusPolicy(Qt::NoFocus);
  m_plot->axisRect()->setAutoMargins(QCP::msLeft);
  m_plot->axisRect()->setMinimumMargins({34, 2, 2, 4});
  m_plot->axisRect()->setMargins({38, 2, 2, 4});
  m_plot->xAxis->setTicker(QSharedPointer<QCPAxisTickerTime>::create());
  m_plot->yAxis->ticker()->setTickCount(3);
  m_plot->yAxis->setNumberPrecision(3);
  m_plot->setNotAntialiasedElements(QCP::aeAll);
  m_plot->setAntialiasedElements(QCP::aePlottables);
  for (QCPItemLine* line : {m_cursor, m_pointer}) {
    line->start->setTypeY(QCPItemPosition::ptAxisRectRatio);
    line->end->setTypeY(QCPItemPosition::ptAxisRectRatio);
    line->setClipToAxisRect(true);
  }
  m_pointer->setVisible(false);
}

void PlotPane::setUpMouse() {
  connect(m_plot, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) { press(*event); });
  connect(m_plot, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) { move(*event); });
  connect(m_plot, &QCustomPlot::mouseRelease, this, [this](const QMouseEvent* event) { release(*event); });
  connect(m_plot, &QCustomPlot::mouseWheel, this, [this](const QWheelEvent* event) { wheel(*event); });
  connect(m_plot, &QCustomPlot::mouseDoubleClick, this, [this](const QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) emit followRequested();
  });
  m_plot->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(m_plot, &QWidget::customContextMenuRequested, this,
          [this](const QPoint& at) { emit menuRequested(m_plot->mapToGlobal(at)); });
  m_plot->installEventFilter(this);
}

void PlotPane::setSeries(PaneSeries series) {
  m_series = std::move(series);
  m_lines.clear();
  m_plot->clearGraphs();
  for (int g = 0; g < 2 * seriesCount(); ++g) m_plot->addGraph();  // curves, then the marks of their cuts
  m_axis = std::make_shared<ValueAxis>();
  const QString title = m_title.empty() ? text(title_of(m_series)) : text(m_title);
  QString about;
  for (const Series one : m_series) {
    const SeriesInfo& info = info_of(one);
    about += QString("<tr><td><b>%1</b>&nbsp;</td><td>%2</td></tr>").arg(text(info.name), text(info.meaning));
  }
  setToolTip("<table>" + about + "</table>");
  setAccessibleName("Plot of " + title);
  describe(*m_menu, "Series of the plot of " + title, "What this pane shows, and export");
  setColours(m_palette);
}

void PlotPane::setTitle(const std::string& title) {
  if (title == m_title) return;
  m_title = title;
  setAccessibleName("Plot of " + text(title.empty() ? title_of(m_series) : title));
  update();
}

void PlotPane::setColours(const Palette& palette) {
  m_palette = palette;
  set_frame_colours(*m_plot, palette);
  for (int c = 0; c < seriesCount(); ++c) {
    const Series series = m_series[static_cast<std::size_t>(c)];
    const QColor colour = colour_of(series, palette);
    m_plot->graph(c)->setPen(QPen(colour, 1.3, is_dashed(series) ? Qt::DashLine : Qt::SolidLine));
    QCPGraph* marks = m_plot->graph(seriesCount() + c);
    marks->setLineStyle(QCPGraph::lsNone);
    marks->setScatterStyle({QCPScatterStyle::ssTriangle, QPen(colour), QBrush(colour), 6});
  }
  m_cursor->setPen(QPen(palette.dark ? QColor("#c7ccd6") : palette.text, 1));
  m_pointer->setPen(QPen(palette.secondary, 1, Qt::DotLine));
  update();
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void PlotPane::setMark(PlotMark mark) {
  if (mark == m_mark) return;
  m_mark = mark;
  update(0, 0, width(), head_height);
}

void PlotPane::setCollapsed(bool collapsed) {
  m_collapsed = collapsed;
  m_plot->setVisible(!collapsed);
}

void PlotPane::showValues(const SeriesValues* values) {
  m_values = values ? std::optional<SeriesValues>(*values) : std::nullopt;
  update(0, 0, width(), head_height);
}

double PlotPane::upperEnd() const {
  return m_plot->yAxis->range().upper;
}

void PlotPane::read(const SampleTable& table, const PlotView& view, QSize curves) {
  constexpr int margins = 40, fewest_columns = 50;
  m_view = view;
  m_lines.clear();
  const int columns = std::max(fewest_columns, curves.width() - margins);
  double upper = 0, lower = 0;
  for (const Series series : m_series) {
    m_lines.push_back(table.line(series, view.from_s, view.to_s, columns));
    std::vector<double> above, below;
    for (const SampleTable::Point& point : m_lines.back()) {
      if (point.time_s < view.from_s || point.time_s > view.to_s) continue;
      (point.value < 0 ? below : above).push_back(std::abs(point.value));
    }
    upper = std::max(upper, robust_upper(std::move(above)));
    lower = std::max(lower, robust_upper(std::move(below)));
  }
  m_axis->include(upper, lower, least_reach(m_series));
}

/// The curves, and one mark for each run of values above the plot.
void PlotPane::fillGraphs(bool within_border) {
  const QCPRange range = m_plot->yAxis->range();
  for (int c = 0; c < seriesCount(); ++c) {
    QVector<QCPGraphData> curve;
    const auto marks = m_plot->graph(seriesCount() + c)->data();
    marks->clear();
    bool above = false;
    for (const SampleTable::Point& point : m_lines[static_cast<std::size_t>(c)]) {
      const bool outside = point.time_s < m_view.from_s || point.time_s > m_view.to_s;
      if (outside && within_border) continue;
      const double value = within_border && std::isfinite(point.value)
                               ? std::clamp(point.value, range.lower, range.upper)
                               : point.value;
      curve.push_back({point.time_s, value});
      if (point.value > range.upper && !above && !outside) marks->add({point.time_s, 0.95 * range.upper});
      above = point.value > range.upper;
    }
    m_plot->graph(c)->data()->set(curve, true);
  }
}

/// Times below the curves, to the second or finer where the span is short.
void PlotPane::showTimes(QSize curves) {
  const double span_s = m_view.to_s - m_view.from_s;
  const auto ticker = m_plot->xAxis->ticker().staticCast<QCPAxisTickerTime>();
  ticker->setTimeFormat(span_s < 4 ? "%m:%s.%z" : span_s < 3600 ? "%m:%s" : "%h:%m:%s");
  ticker->setFieldWidth(QCPAxisTickerTime::tuMinutes, 1);
  ticker->setTickCount(std::clamp(curves.width() / 70, 2, 8));
  const bool room = curves.height() >= labelled_height;
  m_plot->xAxis->setTickLabels(room);
  m_plot->axisRect()->setMargins({38, 2, 2, room ? 18 : 4});
}

/// Gives the plot all that was read, for curves of some size on the screen or on paper.
void PlotPane::lay(QSize curves, bool within_border) {
  m_axis->settle(m_view.to_s);
  m_plot->yAxis->setRange(m_axis->lower(), m_axis->upper());
  fillGraphs(within_border);
  m_plot->xAxis->setRange(m_view.from_s, m_view.to_s);
  showTimes(curves);
  m_cursor->start->setCoords(m_view.cursor_s, 0);
  m_cursor->end->setCoords(m_view.cursor_s, 1);
  m_cursor->setVisible(m_view.from_s <= m_view.cursor_s && m_view.cursor_s <= m_view.to_s);
  m_pointer->setVisible(m_view.pointer_s.has_value());
  m_pointer->start->setCoords(m_view.pointer_s.value_or(0), 0);
  m_pointer->end->setCoords(m_view.pointer_s.value_or(0), 1);
}

void PlotPane::read(const SampleTable& table, const PlotView& view) {
  m_view = view;
  if (!m_collapsed) read(table, view, m_plot->size());
}

void PlotPane::draw() {
  if (m_collapsed) return;
  lay(m_plot->size(), false);
  m_plot->replot(QCustomPlot::rpQueuedRefresh);
}

void PlotPane::readFor(QSize place, const SampleTable& table, const PlotView& view) {
  read(table, view, curves_of(place));
}

void PlotPane::paintInto(QCPPainter& painter, const QRect& place) {
  const QSize curves = curves_of(place.size());
  lay(curves, true);
  painter.save();
  painter.fillRect(place, m_palette.panel);
  painter.translate(place.left(), place.top());
  paint_plot_head(painter, QRectF(0, 0, place.width(), head_height),
                  {m_series, m_values, m_palette, PlotMark::None, m_title});
  painter.translate(10, head_height);
  m_plot->toPainter(&painter, curves.width(), curves.height());
  painter.restore();
}

double PlotPane::xOf(double time_s) const {
  return m_plot->x() + m_plot->xAxis->coordToPixel(time_s);
}

double PlotPane::timeAt(int x) const {
  return m_plot->xAxis->pixelToCoord(x);
}

bool PlotPane::isAtCursor(int x) const {
  constexpr double reach_px = 5;
  return std::abs(m_plot->xAxis->coordToPixel(m_view.cursor_s) - x) <= reach_px;
}

void PlotPane::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return;
  setFocus(Qt::MouseFocusReason);
  m_pressX = m_lastX = event.pos().x();
  m_drag = isAtCursor(m_pressX) ? Drag::Scrub : Drag::Undecided;
}

void PlotPane::move(const QMouseEvent& event) {
  constexpr int click_px = 4;
  const int x = event.pos().x();
  if (!(event.buttons() & Qt::LeftButton)) {
    m_drag = Drag::None;
    m_plot->setCursor(isAtCursor(x) ? Qt::SplitHCursor : Qt::ArrowCursor);
    return emit pointerMoved(timeAt(x), m_plot->mapToGlobal(event.pos()));
  }
  if (m_drag == Drag::Undecided && std::abs(x - m_pressX) > click_px) m_drag = Drag::Pan;
  if (m_drag == Drag::Scrub) emit seekRequested(timeAt(x));
  if (m_drag == Drag::Pan) {
    m_plot->setCursor(Qt::ClosedHandCursor);
    const double seconds_per_pixel = (m_view.to_s - m_view.from_s) / std::max(1, m_plot->axisRect()->width());
    emit panRequested((m_lastX - x) * seconds_per_pixel);
    m_lastX = x;
  }
}

void PlotPane::release(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return;
  if (m_drag == Drag::Undecided) emit seekRequested(timeAt(event.pos().x()));
  m_drag = Drag::None;
  m_plot->setCursor(Qt::ArrowCursor);
}

void PlotPane::wheel(const QWheelEvent& event) {
  const QPoint turned = event.angleDelta();
  const bool along = (event.modifiers() & Qt::ShiftModifier) || std::abs(turned.x()) > std::abs(turned.y());
  const double steps = (turned.x() + turned.y()) / 120.0;
  if (along)
    emit panRequested(-steps * pan_step / 2 * (m_view.to_s - m_view.from_s));
  else
    emit zoomRequested(std::pow(zoom_step, steps), timeAt(static_cast<int>(event.position().x())));
}

void PlotPane::keyPressEvent(QKeyEvent* event) {
  const double span_s = m_view.to_s - m_view.from_s;
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return emit zoomRequested(zoom_step, m_view.cursor_s);
    case Qt::Key_Minus:
      return emit zoomRequested(1 / zoom_step, m_view.cursor_s);
    case Qt::Key_PageUp:
      return emit panRequested(-pan_step * span_s);
    case Qt::Key_PageDown:
      return emit panRequested(pan_step * span_s);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return emit menuRequested(mapToGlobal(QPoint(head_left, head_height)));
    default:
      QWidget::keyPressEvent(event);
  }
}

void PlotPane::focusInEvent(QFocusEvent*) {
  update();
}

void PlotPane::focusOutEvent(QFocusEvent*) {
  update();
}

void PlotPane::contextMenuEvent(QContextMenuEvent* event) {
  emit menuRequested(event->globalPos());
}

bool PlotPane::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Leave) emit pointerLeft();
  // The readout shows these values already.
  if (event->type() == QEvent::ToolTip) return true;
  return QWidget::eventFilter(watched, event);
}

void PlotPane::resizeEvent(QResizeEvent*) {
  m_plot->setGeometry(10, head_height, std::max(1, width() - 20), std::max(1, height() - head_height - 6));
  m_menu->setGeometry(width() - menu_width - 6, 4, menu_width, head_height - 6);
}

void PlotPane::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), m_palette.panel);
  paint_plot_head(painter, QRectF(0, 0, width() - menu_width - 6, head_height),
                  {m_series, m_values, m_palette, m_mark, m_title});
  if (!hasFocus()) return;
  painter.setPen(m_palette.accent);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace abrazo::widgets
