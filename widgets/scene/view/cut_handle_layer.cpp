#include "widgets/scene/view/cut_handle_layer.hpp"

#include <QPainter>

namespace abrazo::widgets {
namespace {

constexpr double knob_radius = 7, middle_radius = 3.5;

QPointF at(const PicturePoint& point) {
  return {point.x, point.y};
}

}  // namespace

CutHandleLayer::CutHandleLayer(QWidget* parent) : QWidget(parent) {
  setObjectName("cut handles");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void CutHandleLayer::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void CutHandleLayer::show(const std::optional<CutHandles>& handles, CutGrip held) {
  m_handles = handles;
  m_held = held;
  setVisible(handles.has_value());
  update();
}

void CutHandleLayer::paintEvent(QPaintEvent*) {
  if (!m_handles) return;
  const CutHandles& handles = *m_handles;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = m_palette.accent.lighter(m_palette.dark ? 150 : 110);
  const bool moves = m_held == CutGrip::Move, turns = m_held == CutGrip::Turn;
  const auto line = [&painter](const auto& from, const auto& to) {
    if (from && to) painter.drawLine(at(*from), at(*to));
  };
  painter.setPen(QPen(colour, moves ? 3.0 : 1.5));
  if (moves)  // the scene draws the outline itself, thinner
    for (std::size_t c = 0; c < handles.outline.size(); ++c)
      line(handles.outline[c], handles.outline[(c + 1) % handles.outline.size()]);
  line(handles.middle, handles.knob);
  painter.setPen(QPen(m_palette.window, 1.5));
  painter.setBrush(colour);
  if (handles.middle) painter.drawEllipse(at(*handles.middle), middle_radius, middle_radius);
  if (!handles.knob) return;
  const double radius = turns ? knob_radius + 2 : knob_radius;
  painter.drawEllipse(at(*handles.knob), radius, radius);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, 1.5));
  painter.drawEllipse(at(*handles.knob), radius + 4, radius + 4);
}

}  // namespace abrazo::widgets
