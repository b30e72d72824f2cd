#include "app/workbench/library/factor_field.hpp"

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "widgets/common/parts.hpp"
#include "widgets/common/value_slider.hpp"

namespace abrazo::app {
namespace {

constexpr double middle = 0.5;
constexpr double factor_step = 0.05, key_step = 0.02;  // the latter of the slider's length

}  // namespace

FactorField::FactorField(const QString& name, double greatest, QWidget* parent)
    : QWidget(parent), m_bend(-std::log(greatest) / std::log(middle)), m_greatest(greatest) {
  m_slider = new widgets::ValueSlider(this);
  m_slider->setAccessibleName(name);
  m_slider->setDefaultPlace(middle);
  m_number = new QLabel(this);
  m_number->setMinimumWidth(m_number->fontMetrics().horizontalAdvance("0.00×"));
  auto* row = widgets::row_in(this);
  row->addWidget(m_slider, 1);
  row->addWidget(m_number);
  setFocusProxy(m_slider);
  connect(m_slider, &widgets::ValueSlider::moved, this, &FactorField::slideTo);
  connect(m_slider, &widgets::ValueSlider::stepped, this,
          [this](int steps) { slideTo(m_slider->place() + steps * key_step); });
  connect(m_slider, &widgets::ValueSlider::resetRequested, this, [this] { slideTo(middle); });
  slideTo(middle);
}

void FactorField::setColours(const widgets::Palette& palette) {
  m_slider->setColours(palette);
}

void FactorField::slideTo(double place) {
  place = std::clamp(place, 0.0, 1.0);
  m_slider->setPlace(place);
  const double factor = std::round(m_greatest * std::pow(place, m_bend) / factor_step) * factor_step;
  m_number->setText(QString("%1×").arg(factor, 0, 'f', 2));
  if (factor == m_factor) return;
  m_factor = factor;
  emit changed();
}

}  // namespace abrazo::app
