#include "widgets/plots/plot_pane.hpp"

#include <qcustomplot.h>

#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/value_range.hpp"

namespace abrazo::widgets {
namespace {

constexpr int head_height = 30;
constexpr double key_gap = 10;

QString unitOf(const PlotPane::Curve& curve) {
  return curve.unit.isEmpty() ? QString() : " " + curve.unit;
}

}  // namespace

PlotPane::PlotPane(const QString& title, std::vector<Curve> curves, QWidget* parent)
    : QWidget(parent),
      m_title(title),
      m_curves(std::move(curves)),
      m_palette(palette_of(Theme::Dark)),
      m_plot(new QCustomPlot(this)),
      m_cursor(new QCPItemLine(m_plot)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, head_height, 10, 6);
  column->addWidget(m_plot);
  m_plot->setMinimumHeight(50);
  m_plot->axisRect()->setAutoMargins(QCP::msLeft);
  m_plot->axisRect()->setMinimumMargins({34, 2, 2, 4});
  m_plot->axisRect()->setMargins({38, 2, 2, 4});
  m_plot->xAxis->setTickLabels(false);
  m_plot->yAxis->ticker()->setTickCount(3);
  m_plot->yAxis->setNumberPrecision(3);
  m_plot->setNotAntialiasedElements(QCP::aeAll);
  m_plot->setAntialiasedElements(QCP::aePlottables);
  m_plot->setNoAntialiasingOnDrag(true);
  for (int c = 0; c < 2 * curveCount(); ++c) m_plot->addGraph();  // the curves, then the marks of their cuts
  m_cursor->start->setTypeY(QCPItemPosition::ptAxisRectRatio);
  m_cursor->end->setTypeY(QCPItemPosition::ptAxisRectRatio);
  m_cursor->setClipToAxisRect(true);
  connect(m_plot, &QCustomPlot::mousePress, this, [this](QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) emit seekRequested(m_plot->xAxis->pixelToCoord(event->pos().x()));
  });
  connect(m_plot, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) emit seekRequested(m_plot->xAxis->pixelToCoord(event->pos().x()));
  });
  connect(m_plot, &QCustomPlot::mouseWheel, this, [this](QWheelEvent* event) {
    emit zoomRequested(std::pow(0.85, event->angleDelta().y() / 120.0));
  });
}

void PlotPane::setColours(const Palette& palette, const std::vector<QColor>& curves) {
  m_palette = palette;
  m_colours = curves;
  m_plot->setBackground(QBrush(palette.panel));
  const QColor faint = mixed(palette.secondary, palette.panel, 0.22);
  for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
    axis->setBasePen(QPen(faint));
    axis->setTickPen(Qt::NoPen);
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(palette.secondary);
    axis->setTickLabelFont(interface_font(10));
    axis->grid()->setPen(QPen(faint, 1));
    axis->grid()->setZeroLinePen(QPen(faint, 1));
  }
  m_plot->xAxis->grid()->setVisible(false);
  for (int c = 0; c < curveCount(); ++c) {
    const QColor& colour = curves[static_cast<std::size_t>(c)];
    m_plot->graph(c)->setPen(QPen(colour, 1.3));
    QCPGraph* marks = m_plot->graph(curveCount() + c);
    marks->setLineStyle(QCPGraph::lsNone);
    marks->setScatterStyle({QCPScatterStyle::ssTriangle, QPen(colour), QBrush(colour), 6});
  }
  m_cursor->setPen(QPen(palette.dark ? QColor("#c7ccd6") : palette.text, 1));
  update();
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void PlotPane::append(double time_s, const std::vector<double>& values) {
  for (int c = 0; c < curveCount(); ++c)
    m_plot->graph(c)->addData(time_s, values[static_cast<std::size_t>(c)]);
}

void PlotPane::dropBefore(double time_s) {
  for (int c = 0; c < m_plot->graphCount(); ++c) m_plot->graph(c)->data()->removeBefore(time_s);
}

void PlotPane::clear() {
  for (int c = 0; c < m_plot->graphCount(); ++c) m_plot->graph(c)->data()->clear();
  m_range.reset();
}

void PlotPane::showValues(std::vector<double> values) {
  m_values = std::move(values);
  update(0, 0, width(), head_height);
}

/// The same height until the values have been smaller for a while, so that the numbers can be read.
void PlotPane::fitHeight(double from_s, double to_s) {
  double upper = 0;
  for (int c = 0; c < curveCount(); ++c) {
    std::vector<double> visible;
    const auto values = m_plot->graph(c)->data();
    for (auto it = values->findBegin(from_s, false); it != values->findEnd(to_s, false); ++it)
      visible.push_back(it->value);
    upper = std::max(upper, robust_upper(std::move(visible)));
  }
  m_range.show(upper, to_s);
  m_plot->yAxis->setRange(0, std::max(m_range.upper(), m_least));
}

/// One mark for each run of values above the plot.
void PlotPane::markCuts(double from_s, double to_s) {
  const double upper = m_plot->yAxis->range().upper;
  for (int c = 0; c < curveCount(); ++c) {
    const auto values = m_plot->graph(c)->data();
    const auto marks = m_plot->graph(curveCount() + c)->data();
    marks->clear();
    bool above = false;
    for (auto it = values->findBegin(from_s, false); it != values->findEnd(to_s, false); ++it) {
      if (it->value > upper && !above) marks->add({it->key, 0.95 * upper});
      above = it->value > upper;
    }
  }
}

void PlotPane::draw(double from_s, double to_s, double cursor_s) {
  fitHeight(from_s, to_s);
  markCuts(from_s, to_s);
  m_plot->xAxis->setRange(from_s, to_s);
  m_cursor->start->setCoords(cursor_s, 0);
  m_cursor->end->setCoords(cursor_s, 1);
  m_plot->replot(QCustomPlot::rpQueuedReplot);
}

double PlotPane::xOf(double time_s) const {
  return m_plot->x() + m_plot->xAxis->coordToPixel(time_s);
}

void PlotPane::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), m_palette.panel);
  painter.setFont(interface_font(12, QFont::DemiBold));
  // Where there is no room for the values the names stay, and at last the names without the title.
  const double title_end = 12 + painter.fontMetrics().horizontalAdvance(m_title) + 14;
  const bool with_values = title_end + headWidth(true) < width();
  const bool with_title = title_end + headWidth(false) < width();
  painter.setPen(m_palette.text);
  if (with_title)
    painter.drawText(QRectF(12, 4, width(), head_height - 4), Qt::AlignVCenter | Qt::AlignLeft, m_title);
  double x = with_title ? title_end : 12;
  for (std::size_t c = 0; c < m_curves.size() && c < m_colours.size(); ++c) {
    const Curve& curve = m_curves[c];
    painter.setFont(interface_font(11));
    painter.fillRect(QRectF(x, head_height / 2.0 - 2, 8, 8), m_colours[c]);
    painter.setPen(m_palette.secondary);
    painter.drawText(QRectF(x + 12, 4, width(), head_height - 4), Qt::AlignVCenter, curve.name);
    x += 12 + painter.fontMetrics().horizontalAdvance(curve.name) + 5;
    if (with_values) {
      const QString value =
          c < m_values.size() ? QString::number(m_values[c], 'f', curve.decimals) : QString("–");
      painter.setPen(m_palette.text);
      draw_tabular(painter, QRectF(x, 4, 90, head_height - 4), Qt::AlignLeft, value + unitOf(curve));
      x += tabular_width(painter.font(), QString(curve.decimals + 2, '0') + unitOf(curve));
    }
    x += key_gap;
  }
}

double PlotPane::headWidth(bool with_values) const {
  const QFont font = interface_font(11);
  double sum = 0;
  for (const Curve& curve : m_curves) {
    sum += 12 + tabular_width(font, curve.name) + 5 + key_gap;
    if (with_values) sum += tabular_width(font, QString(curve.decimals + 2, '0') + unitOf(curve));
  }
  return sum;
}

}  // namespace abrazo::widgets
