#include "widgets/scene/panel/morph_strip.hpp"

#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/common/tabular.hpp"

namespace abrazo::widgets {

MorphStrip::MorphStrip(QWidget* parent)
    : QWidget(parent),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_back(new QToolButton(this)),
      m_forth(new QToolButton(this)),
      m_close(new QToolButton(this)),
      m_text(new TabularLabel(this)) {
  auto* row = row_in(this, {10, 3, 4, 3}, 4);
  const auto dress = [](QToolButton* button, const QString& name) {
    button->setObjectName("flat");
    describe(*button, name, name);
  };
  dress(m_back, "Previous morph step (,)");
  dress(m_forth, "Next morph step (.)");
  dress(m_close, "Back to the result");
  describe(*m_slider, "Morph step",
           "From the selected pair through morph and projection steps to the result");
  m_slider->setPageStep(1);
  m_slider->setFixedWidth(110);
  for (QWidget* part : std::initializer_list<QWidget*>{m_text, m_back, m_slider, m_forth, m_close})
    row->addWidget(part);
  connect(m_slider, &QSlider::valueChanged, this, &MorphStrip::stepRequested);
  connect(m_back, &QToolButton::clicked, this, [this] { emit stepRequested(m_slider->value() - 1); });
  connect(m_forth, &QToolButton::clicked, this, [this] { emit stepRequested(m_slider->value() + 1); });
  connect(m_close, &QToolButton::clicked, this, &MorphStrip::closeRequested);
  setColours(palette_of(Theme::Dark));
}

void MorphStrip::setColours(const Palette& palette) {
  m_palette = palette;
  m_back->setIcon(icon(Icon::StepBack, palette.secondary));
  m_forth->setIcon(icon(Icon::StepForward, palette.secondary));
  m_close->setIcon(icon(Icon::Close, palette.secondary));
  m_text->setColour(palette.text);
  update();
}

void MorphStrip::showStep(int step, int steps, const QString& text) {
  const QSignalBlocker silent(m_slider);
  m_slider->setRange(0, steps);
  m_slider->setValue(step);
  m_back->setEnabled(step > 0);
  m_forth->setEnabled(step < steps);
  m_text->setText(step == 0 ? "selected pair, " + text : "morph step " + text);
  adjustSize();
}

void MorphStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor back = m_palette.panel;
  back.setAlphaF(colour_part(0.94));
  painter.setBrush(back);
  painter.setPen(m_palette.border);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
}

}  // namespace abrazo::widgets
