#include "widgets/settings/setting_row.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include "core/base/text.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/settings/value_slider.hpp"

namespace abrazo::widgets {
namespace {

QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<int>(utf8.size()));
}

/// "w_Δ" with its index set low.
QString typeset(const QString& symbol) {
  const int low = symbol.indexOf('_');
  if (low < 0) return symbol.toHtmlEscaped();
  return symbol.left(low).toHtmlEscaped() + "<sub>" + symbol.mid(low + 1).toHtmlEscaped() + "</sub>";
}

/// What is typed after a click replaces the value. Escape leaves it as it was.
class ValueField : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    const bool had_focus = m_focused;
    m_focused = true;
    QLineEdit::mousePressEvent(event);
    if (!had_focus) selectAll();
  }
  void mouseDoubleClickEvent(QMouseEvent*) override { selectAll(); }
  void focusOutEvent(QFocusEvent* event) override {
    m_focused = false;
    QLineEdit::focusOutEvent(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() != Qt::Key_Escape) return QLineEdit::keyPressEvent(event);
    setText(m_before);
    clearFocus();
  }
  void focusInEvent(QFocusEvent* event) override {
    m_before = text();
    QLineEdit::focusInEvent(event);
  }

 private:
  QString m_before;
  bool m_focused = false;
};

}  // namespace

SettingRow::SettingRow(const SettingInfo& info, QWidget* parent) : QWidget(parent), m_info(info) {
  const QString range = info.kind == SettingInfo::Kind::Real || info.kind == SettingInfo::Kind::Integer
                            ? QString("<br><span>%1 … %2 %3 · double-click resets</span>")
                                  .arg(info.minimum)
                                  .arg(info.maximum)
                                  .arg(text(info.unit))
                            : QString();
  setToolTip("<p>" + text(info.help).toHtmlEscaped() + range + "</p>");
  switch (info.kind) {
    case SettingInfo::Kind::Real:
    case SettingInfo::Kind::Integer:
      buildNumber();
      break;
    case SettingInfo::Kind::Flag:
      buildToggle();
      break;
    case SettingInfo::Kind::Choice:
      buildChoice();
      break;
  }
}

QLabel* SettingRow::titleLabel() {
  const QString symbol = typeset(text(m_info.symbol));
  auto* label =
      new QLabel((symbol.isEmpty() ? QString() : symbol + " ") + text(m_info.title).toHtmlEscaped(), this);
  label->setTextFormat(Qt::RichText);
  return label;
}

void SettingRow::buildNumber() {
  m_scale = {m_info.minimum, m_info.maximum, m_info.logarithmic, m_info.kind == SettingInfo::Kind::Integer};
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 2, 12, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(0);
  m_value = new ValueField(this);
  m_value->setObjectName("value");
  m_value->setAlignment(Qt::AlignRight);
  m_value->setFixedSize(84, 20);
  m_value->setFocusPolicy(Qt::ClickFocus);
  m_slider = new ValueSlider(this);
  grid->addWidget(titleLabel(), 0, 0);
  grid->addWidget(m_value, 0, 1, Qt::AlignRight);
  grid->addWidget(m_slider, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  setFixedHeight(43);
  const QString key = text(m_info.key);
  connect(m_slider, &ValueSlider::moved, this, [this, key](double place, int gesture) {
    emit changed(key, QString::fromStdString(exact_text(m_scale.value(place))), gesture);
  });
  connect(m_slider, &ValueSlider::resetRequested, this, [this, key] { emit changed(key, m_defaultText, 0); });
  connect(m_value, &QLineEdit::editingFinished, this, [this, key] {
    QString typed = m_value->text().trimmed();
    const QString unit = text(m_info.unit);
    if (!unit.isEmpty() && typed.endsWith(unit)) typed.chop(unit.size());
    const bool typed_in = m_value->isModified();
    m_value->setModified(false);
    m_value->clearFocus();
    if (typed_in) emit changed(key, typed.trimmed(), 0);
  });
}

void SettingRow::buildToggle() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 12, 2);
  m_toggle = new Toggle(this);
  row->addWidget(titleLabel(), 1);
  row->addWidget(m_toggle);
  setFixedHeight(28);
  connect(m_toggle, &Toggle::toggled, this,
          [this](bool on) { emit changed(text(m_info.key), on ? "on" : "off", 0); });
}

void SettingRow::buildChoice() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 3, 12, 3);
  m_choice = new QComboBox(this);
  m_choice->addItems(text(m_info.choices).split('|'));
  m_choice->setMinimumWidth(118);
  m_choice->setFocusPolicy(Qt::TabFocus);
  row->addWidget(titleLabel(), 1);
  row->addWidget(m_choice);
  setFixedHeight(34);
  connect(m_choice, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { emit changed(text(m_info.key), m_choice->itemText(index), 0); });
}

void SettingRow::setColours(const Palette& palette) {
  if (m_slider) m_slider->setColours(palette);
  if (m_toggle) m_toggle->setColours(palette);
}

void SettingRow::show(const Settings& settings, const Settings& defaults) {
  const double number = setting_number(settings, m_info.key);
  m_defaultText = QString::fromStdString(setting_text(defaults, m_info.key));
  if (m_toggle) m_toggle->setOn(number > 0.5);
  if (m_choice) m_choice->setCurrentIndex(static_cast<int>(number));
  if (!m_slider) return;
  m_slider->setPlace(m_scale.place(number));
  m_slider->setDefaultPlace(m_scale.place(setting_number(defaults, m_info.key)));
  if (m_value->hasFocus() && m_value->isModified()) return;
  QString shown = m_scale.whole_numbers ? QString::number(number, 'f', 0) : QString::number(number, 'g', 4);
  if (m_info.key == "step-rate" && number == 0)
    shown = "input's";
  else if (!m_info.unit.empty())
    shown += " " + text(m_info.unit);
  m_value->setText(shown);
}

}  // namespace abrazo::widgets
