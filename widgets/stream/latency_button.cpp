#include "widgets/stream/latency_button.hpp"

#include <QPainter>
#include <cmath>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/stream/stream_sign.hpp"

namespace abrazo::widgets {
namespace {

constexpr double left_px = 22, gap_px = 6, right = 10;
constexpr const char* widest = "0.00 / 0.00 ms";

const char* word_of(LatencyVerdict verdict) {
  switch (verdict) {
    case LatencyVerdict::Good:
      return "within one interval of the input";
    case LatencyVerdict::Warning:
      return "longer than one interval of the input";
    case LatencyVerdict::Bad:
      return "three intervals of the input or more: the partner answers late";
    case LatencyVerdict::None:
      break;
  }
  return "measured once a live stream is received";
}

}  // namespace

LatencyButton::LatencyButton(QWidget* parent) : QAbstractButton(parent), m_palette(palette_of(Theme::Dark)) {
  setObjectName("latency");
  setFixedHeight(22);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  show(nullptr, LatencyVerdict::None);
}

void LatencyButton::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void LatencyButton::show(const LatencyRow* row, LatencyVerdict verdict) {
  m_verdict = verdict;
  m_name = row ? QString::fromStdString(row->name).toLower() : "in → out";
  m_value = row && std::isfinite(row->p50)
                ? QString::fromStdString(latency_text(row->p50) + " / " + latency_text(row->p95) + " ms")
                : "–";
  setAccessibleName("Latency " + words());
  setToolTip("Latency, median and 95th percentile: " + words() + ", " + word_of(verdict) +
             ". A click shows where the time goes");
  update();
}

QString LatencyButton::words() const {
  return m_name + " " + m_value;
}

QSize LatencyButton::sizeHint() const {
  const double name = tabular_width(interface_font(12), "in → pose"),
               value = tabular_width(interface_font(12, QFont::DemiBold), widest);
  return {static_cast<int>(std::ceil(left_px + name + gap_px + value + right)), 22};
}

void LatencyButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underMouse() || hasFocus()) {
    painter.setPen(hasFocus() ? QPen(m_palette.accent) : QPen(Qt::NoPen));
    painter.setBrush(m_palette.raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  }
  draw_sign(painter, {12, height() / 2.0}, mark_of(m_verdict), m_palette);
  painter.setFont(interface_font(12));
  painter.setPen(m_palette.secondary);
  draw_tabular(painter, QRectF(left_px, 0, width(), height()), Qt::AlignLeft, m_name);
  painter.setFont(interface_font(12, QFont::DemiBold));
  painter.setPen(m_palette.text);
  draw_tabular(painter, QRectF(0, 0, width() - right, height()), Qt::AlignRight, m_value);
}

}  // namespace abrazo::widgets
