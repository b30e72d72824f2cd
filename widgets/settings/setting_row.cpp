#include "widgets/settings/setting_row.hpp"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include "core/base/text.hpp"
#include "widgets/common/chip.hpp"
#include "widgets/common/typeset.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/common/value_slider.hpp"
#include "widgets/settings/body_box.hpp"
#include "widgets/settings/setting_help.hpp"
#include "widgets/settings/toggle.hpp"

namespace abrazo::widgets {
namespace {

constexpr int least_letters = 3;           ///< of a title that has no room
constexpr double lowest_step_rate_hz = 5;  ///< but for 0, the input's own rate

/// Typing after a click replaces the value. Escape restores it.
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
  setToolTip(QString::fromStdString(setting_tooltip(info)));
  m_title = new QLabel(this);
  m_title->setTextFormat(Qt::RichText);
  m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // gets shorter words: showTitle
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
    case SettingInfo::Kind::Body:
      buildBody();
      break;
  }
  name(*this);
}

QString SettingRow::key() const {
  return text(m_info.key);
}

void SettingRow::name(QWidget& control) const {
  control.setAccessibleName(text(m_info.title));
  control.setAccessibleDescription(QString::fromStdString(setting_description(m_info)));
}

void SettingRow::buildNumber() {
  m_scale = {m_info.minimum, m_info.maximum, m_info.logarithmic, m_info.kind == SettingInfo::Kind::Integer,
             m_info.key == "step-rate" ? lowest_step_rate_hz : m_info.minimum};
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 2, 12, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(0);
  m_slider = new ValueSlider(this);
  m_value = new ValueField(this);
  m_value->setObjectName("value");
  m_value->setAlignment(Qt::AlignRight);
  m_value->setFixedSize(84, 20);
  m_value->setFocusPolicy(Qt::StrongFocus);
  grid->addWidget(m_title, 0, 0);
  grid->addWidget(m_value, 0, 1, Qt::AlignRight);
  grid->addWidget(m_slider, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  setFixedHeight(40);
  name(*m_slider);
  name(*m_value);
  connectSlider();
  connectField();
}

void SettingRow::connectSlider() {
  const auto ask = [this](double value, int gesture) {
    emit changed(key(), QString::fromStdString(exact_text(value)), gesture);
  };
  connect(m_slider, &ValueSlider::moved, this,
          [this, ask](double place, int gesture) { ask(m_scale.value(place), gesture); });
  connect(m_slider, &ValueSlider::stepped, this,
          [this, ask](int steps, int gesture) { ask(m_scale.stepped(m_number, steps), gesture); });
  connect(m_slider, &ValueSlider::resetRequested, this,
          [this](int gesture) { emit changed(key(), m_defaultText, gesture); });
}

void SettingRow::connectField() {
  connect(m_value, &QLineEdit::editingFinished, this, [this] {
    QString typed = m_value->text().trimmed();
    const QString unit = text(m_info.unit);
    if (!unit.isEmpty() && typed.endsWith(unit)) typed.chop(unit.size());
    const bool typed_in = m_value->isModified();
    m_value->setModified(false);
    m_value->clearFocus();
    if (typed_in) emit changed(key(), typed.trimmed(), 0);
  });
}

void SettingRow::buildToggle() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 10, 2);
  m_toggle = new Toggle(this);
  row->addWidget(m_title, 1);
  row->addWidget(m_toggle);
  setFixedHeight(28);
  name(*m_toggle);
  connect(m_toggle, &Toggle::clicked, this, [this](bool on) { emit changed(key(), on ? "on" : "off", 0); });
}

void SettingRow::buildChoice() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 3, 12, 3);
  m_choice = new QComboBox(this);
  // The keys of a role are the paper's words; the window says who leads.
  for (const QString& choice : text(m_info.choices).split('|'))
    m_choice->addItem(m_info.key != "user-role" ? choice : choice == "active" ? "leads" : "follows", choice);
  m_choice->setMinimumWidth(118);
  m_choice->setFocusPolicy(Qt::TabFocus);
  row->addWidget(m_title, 1);
  row->addWidget(m_choice);
  setFixedHeight(34);
  name(*m_choice);
  connect(m_choice, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { emit changed(key(), m_choice->itemData(index).toString(), 0); });
}

void SettingRow::buildBody() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 3, 12, 3);
  m_body = new BodyBox(m_info.choices.find("user") != std::string_view::npos, this);
  m_file = text_chip("…", "Measures the performer of a motion file", this);
  m_file->setAccessibleName(text(m_info.title) + ": choose a file");
  m_file->setAccessibleDescription(m_file->toolTip());
  row->addWidget(m_title, 1);
  row->addWidget(m_body);
  row->addWidget(m_file);
  setFixedHeight(34);
  name(*m_body);
  name(*m_body->lineEdit());
  const auto ask = [this] {
    const QString typed = m_body->currentText().trimmed();
    m_body->lineEdit()->setModified(false);  // a refusal restores what was there
    if (typed != m_bodyText) emit changed(key(), typed, 0);
  };
  connect(m_file, &QToolButton::clicked, this, [this] { emit fileRequested(key()); });
  connect(m_body, qOverload<int>(&QComboBox::activated), this, ask);
  connect(m_body->lineEdit(), &QLineEdit::editingFinished, this, ask);
}

void SettingRow::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction("Default (" + m_defaultText + ")", this, [this] { emit changed(key(), m_defaultText, 0); })
      ->setEnabled(m_changed);
  menu.addAction("Sweep this setting\u2026", this, [this] { emit sweepRequested(key()); })
      ->setEnabled(m_applies);
  menu.exec(event->globalPos());
}

void SettingRow::setColours(const Palette& palette) {
  m_mark = palette.warning;
  if (m_slider) m_slider->setColours(palette);
  if (m_toggle) m_toggle->setColours(palette);
}

QString SettingRow::valueText(double number) const {
  if (m_info.key == "step-rate" && number == 0) return "input's";
  const QString unit = m_info.unit.empty() ? QString() : " " + text(m_info.unit);
  return (m_scale.whole_numbers ? QString::number(number, 'f', 0) : QString::number(number, 'g', 4)) + unit;
}

/// In a narrow column with fewer words, so that no value is cut off; the tooltip has the rest.
void SettingRow::showTitle() {
  if (layout()) layout()->activate();
  const QString symbol = QString::fromStdString(typeset(m_info.symbol));
  const QString title = text(m_info.title);
  const auto fits = [&](const QString& name, const QString& without_effect) {
    QString words = (symbol.isEmpty() ? QString() : symbol + " ") + name.toHtmlEscaped();
    if (m_changed) words += " *";
    if (!m_applies) words += without_effect;  // why says the tooltip
    if (!m_ofFrame.isEmpty())
      words +=
          QString(" <span style='color: %1'>\u25b4 %2</span>").arg(m_mark.name(), m_ofFrame.toHtmlEscaped());
    if (m_title->text() != words) m_title->setText(words);
    return m_title->sizeHint().width() <= m_title->width();
  };
  if (fits(title, " · no effect now") || fits(title, " · no effect")) return;
  for (auto kept = title.size() - 2; kept > least_letters; --kept)
    if (fits(title.left(kept).trimmed() + "\u2026", " · no effect")) return;
}

void SettingRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showTitle();
}

/// The row itself stays enabled: its tooltip and menu are needed.
void SettingRow::showApplies(const Settings& settings) {
  if (applies(settings, m_info.key) == m_applies) return;
  m_applies = !m_applies;
  for (QWidget* part :
       std::initializer_list<QWidget*>{m_title, m_slider, m_value, m_toggle, m_choice, m_body, m_file})
    if (part) part->setEnabled(m_applies);
  QString help = QString::fromStdString(setting_tooltip(m_info));
  if (!m_applies)
    help += "<div style='margin-top: 6px'><b>" +
            text(why_it_does_not_apply(settings, m_info.key)).toHtmlEscaped() + "</b></div>";
  setToolTip(help);
}

void SettingRow::show(const Settings& settings, const Settings& defaults, const Settings* of_frame) {
  m_number = setting_number(settings, m_info.key);
  const double usual = setting_number(defaults, m_info.key);
  m_defaultText = QString::fromStdString(setting_text(defaults, m_info.key));
  const std::string now = setting_text(settings, m_info.key);
  const bool differs = of_frame && setting_text(*of_frame, m_info.key) != now;
  const double then = differs ? setting_number(*of_frame, m_info.key) : m_number;
  QString then_text;
  if (differs) then_text = m_slider ? valueText(then) : text(setting_text(*of_frame, m_info.key));
  m_changed = now != setting_text(defaults, m_info.key);
  showApplies(settings);
  m_ofFrame = then_text;
  showTitle();
  if (m_toggle) m_toggle->setOn(m_number > 0.5);
  if (m_choice) m_choice->setCurrentIndex(static_cast<int>(m_number));
  if (m_body && !m_body->lineEdit()->isModified()) {
    m_bodyText = text(now);
    m_body->setEditText(m_bodyText);
  }
  if (!m_slider) return;
  m_slider->setPlace(m_scale.place(m_number));
  m_slider->setDefaultPlace(m_scale.place(usual));
  m_slider->setMarkedPlace(differs ? std::optional(m_scale.place(then)) : std::nullopt);
  if (m_value->hasFocus() && m_value->isModified()) return;
  m_value->setText(valueText(m_number));
}

}  // namespace abrazo::widgets
