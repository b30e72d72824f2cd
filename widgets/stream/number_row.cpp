#include "widgets/stream/number_row.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <cmath>

#include "widgets/common/value_slider.hpp"

namespace abrazo::widgets {

NumberRow::NumberRow(const QString& title, const QString& unit, Range range, QWidget* parent)
    : QWidget(parent),
      m_unit(unit),
      m_range(range),
      m_number(range.usual),
      m_title(new QLabel(title, this)),
      m_field(new QLineEdit(this)),
      m_slider(new ValueSlider(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 2, 12, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(0);
  grid->setColumnStretch(0, 1);
  m_field->setObjectName("value");
  m_field->setAlignment(Qt::AlignRight);
  m_field->setFixedSize(84, 20);
  m_field->setAccessibleName(title + ", number");
  m_slider->setAccessibleName(title);
  grid->addWidget(m_title, 0, 0);
  grid->addWidget(m_field, 0, 1, Qt::AlignRight);
  grid->addWidget(m_slider, 1, 0, 1, 2);
  setFixedHeight(43);
  const double span = range.most - range.least;
  m_slider->setDefaultPlace((range.usual - range.least) / span);
  connect(m_slider, &ValueSlider::moved, this,
          [this, span](double place) { ask(m_range.least + static_cast<int>(std::lround(place * span))); });
  connect(m_slider, &ValueSlider::stepped, this, [this](int steps) { ask(m_number + steps * m_range.step); });
  connect(m_slider, &ValueSlider::resetRequested, this, [this] { ask(m_range.usual); });
  connect(m_field, &QLineEdit::editingFinished, this, &NumberRow::take);
  setNumber(range.usual);
}

void NumberRow::setColours(const Palette& palette) {
  m_slider->setColours(palette);
}

void NumberRow::setNumber(int number) {
  m_number = std::clamp(number, m_range.least, m_range.most);
  m_slider->setPlace(static_cast<double>(m_number - m_range.least) / (m_range.most - m_range.least));
  m_slider->setAccessibleDescription(QString("%1 %2").arg(m_number).arg(m_unit));
  if (!m_field->hasFocus() || !m_field->isModified())
    m_field->setText(QString("%1 %2").arg(m_number).arg(m_unit));
}

void NumberRow::ask(int number) {
  const int before = m_number;
  setNumber(number);
  if (m_number != before) emit changed(m_number);
}

/// Accepts typed text; restores the value if it is not a number.
void NumberRow::take() {
  QString typed = m_field->text().trimmed();
  if (typed.endsWith(m_unit)) typed.chop(m_unit.size());
  bool is_number = false;
  const double value = typed.trimmed().toDouble(&is_number);
  m_field->setModified(false);
  const int held = static_cast<int>(
      std::lround(std::clamp(value, static_cast<double>(m_range.least), static_cast<double>(m_range.most))));
  ask(is_number && std::isfinite(value) ? held : m_number);
  m_field->setText(QString("%1 %2").arg(m_number).arg(m_unit));
}

}  // namespace abrazo::widgets
