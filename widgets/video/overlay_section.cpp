#include "widgets/video/overlay_section.hpp"

#include <algorithm>

#include "widgets/common/value_slider.hpp"
#include "widgets/video/section_parts.hpp"

namespace abrazo::widgets {

OverlaySection::OverlaySection(QWidget* parent) : QWidget(parent) {
  auto* column = section_column(this);
  auto* toggles = section_row(column);
  toggles->addWidget(makeToggle("Leader", "The active character, solid", &OverlayParts::active));
  toggles->addWidget(makeToggle("Follower", "The passive character, dashed", &OverlayParts::passive));
  toggles->addWidget(makeToggle("Mesh", "Edges between the bodies", &OverlayParts::mesh));
  toggles->addWidget(makeToggle("Within", "The mesh's edges within a body", &OverlayParts::within_bodies));
  toggles->addStretch(1);
  auto* row = section_row(column);
  row->addWidget(new QLabel("Opacity", this));
  m_slider = new ValueSlider(this);
  m_slider->setAccessibleName("Opacity of the overlay");
  m_slider->setDefaultPlace(usual_opacity);
  m_slider->setPlace(m_opacity);
  row->addWidget(m_slider, 1);
  connect(m_slider, &ValueSlider::moved, this, [this](double place, int) { setOpacity(place); });
  connect(m_slider, &ValueSlider::stepped, this,
          [this](int steps, int) { setOpacity(m_opacity + 0.05 * steps); });
  connect(m_slider, &ValueSlider::resetRequested, this, [this](int) { setOpacity(usual_opacity); });
}

QToolButton* OverlaySection::makeToggle(const QString& text, const QString& tip, bool OverlayParts::*part) {
  QToolButton* button = text_chip(text, tip, this);
  button->setAccessibleName("Overlay: " + text);
  button->setCheckable(true);
  button->setChecked(m_parts.*part);
  connect(button, &QToolButton::toggled, this, [this, part](bool on) {
    m_parts.*part = on;
    emit partsChanged(m_parts);
  });
  return button;
}

void OverlaySection::setOpacity(double opacity) {
  m_opacity = std::clamp(opacity, 0.0, 1.0);
  m_slider->setPlace(m_opacity);
  emit opacityChanged(m_opacity);
}

void OverlaySection::setColours(const Palette& palette) {
  m_slider->setColours(palette);
}

}  // namespace abrazo::widgets
