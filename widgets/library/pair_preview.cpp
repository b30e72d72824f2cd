#include "widgets/library/pair_preview.hpp"

#include <QPainter>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_set.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/library/take_picture.hpp"

namespace abrazo::widgets {
namespace {

constexpr int slider_height = 26, facts_height = 20;

/// Head above the lower foot [m].
double stands(const Pose& pose) {
  return pose(joints::Head, 1) - std::min(pose(joints::LeftToes, 1), pose(joints::RightToes, 1));
}

}  // namespace

PairPreview::PairPreview(QWidget* parent)
    : QWidget(parent), m_palette(palette_of(Theme::Dark)), m_slider(new QSlider(Qt::Horizontal, this)) {
  m_slider->setAccessibleName("Frame of the preview");
  setAccessibleName("Preview of the pair from the side and from above");
  setMinimumSize(240, 170);
  connect(m_slider, &QSlider::valueChanged, this, &PairPreview::setFrame);
}

void PairPreview::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void PairPreview::show(const PreviewedClip& a, const PreviewedClip& b) {
  const bool same = a.clip == m_a.clip && b.clip == m_b.clip;
  m_a = a, m_b = b;
  m_scale = preview_scale(a, b);
  const int frames = common_frames(a, b);
  m_slider->setRange(0, std::max(0, frames - 1));
  m_slider->setEnabled(frames > 1);
  if (!same) m_slider->setValue(frames / 2);
  m_frame = m_slider->value();
  update();
}

void PairPreview::setFrame(int frame) {
  m_frame = frame;
  m_slider->setValue(frame);
  update();
}

void PairPreview::resizeEvent(QResizeEvent*) {
  m_slider->setGeometry(8, height() - slider_height, width() - 16, slider_height);
}

QString PairPreview::facts() const {
  QStringList words{QString("frame %1").arg(m_frame)};
  const Pose *a = m_a.pose(m_frame), *b = m_b.pose(m_frame);
  if (a) words << QString("A reaches %1 m").arg(stands(*a), 0, 'f', 2);
  if (b) words << QString("B %1 m").arg(stands(*b), 0, 'f', 2);
  if (a && b)
    words
        << QString("%1 m apart").arg(std::hypot((*a)(0, 0) - (*b)(0, 0), (*a)(0, 2) - (*b)(0, 2)), 0, 'f', 2);
  return words.join(" · ");
}

void PairPreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(interface_font(11));
  const double bottom = height() - slider_height - facts_height, half = (width() - 4) / 2.0;
  paintView(painter, QRectF(0, 0, half, bottom), false);
  paintView(painter, QRectF(half + 4, 0, half, bottom), true);
  painter.setPen(m_palette.secondary);
  draw_tabular(painter, QRectF(8, bottom, width() - 16, facts_height), Qt::AlignLeft, facts());
}

/// Lines at 0, 1 and 2 m, so that a wrong unit shows.
void PairPreview::paintFloor(QPainter& painter, const QRectF& area, double scale, double floor) const {
  for (int metre = 0; metre <= 2; ++metre) {
    const double y = floor - metre * scale;
    if (y < area.top() + 14 || y > area.bottom()) continue;
    painter.setPen(QPen(metre == 0 ? m_palette.secondary : m_palette.border, 1,
                        metre == 0 ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(m_palette.secondary);
    painter.drawText(QPointF(area.left() + 4, y - 2), QString("%1 m").arg(metre));
  }
}

void PairPreview::paintView(QPainter& painter, const QRectF& area, bool from_above) const {
  painter.save();
  painter.setClipRect(area);
  painter.setPen(Qt::NoPen);
  painter.setBrush(mixed(m_palette.raised, m_palette.panel, 0.5));
  painter.drawRoundedRect(area, 5, 5);
  const bool any = m_a.pose(m_frame) || m_b.pose(m_frame);
  if (any) {
    const Vec3 middle = middle_of(m_a, m_b, m_frame);
    FlatView view;
    view.side = m_scale.side_axis;
    view.up = from_above ? 2 - m_scale.side_axis : 1;
    view.scale = (std::min(area.width(), area.height()) - 30) / m_scale.extent_m;
    view.origin = {area.center().x() - view.scale * middle[view.side],
                   area.center().y() + 6 + view.scale * middle[view.up]};
    if (!from_above) paintFloor(painter, area, view.scale, view.origin.y());
    for (const auto& [clip, colour] :
         {std::pair(&m_b, m_palette.passive), std::pair(&m_a, m_palette.active)}) {
      const Pose* pose = clip->pose(m_frame);
      if (!pose) continue;
      painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
      draw_bones(painter, *pose, view);
      painter.setBrush(colour);
      painter.drawEllipse(view.at(*pose, joints::Head), 3.5, 3.5);
      const QPointF head = view.at(*pose, joints::Head);
      painter.drawText(head + QPointF(6, -4), clip == &m_a ? "A" : "B");
    }
  }
  painter.setPen(m_palette.secondary);
  painter.drawText(area.adjusted(6, 3, -6, 0), Qt::AlignTop | Qt::AlignRight,
                   from_above ? "from above" : "from the side");
  if (!any) painter.drawText(area, Qt::AlignCenter, "nothing to show");
  painter.restore();
}

}  // namespace abrazo::widgets
