#include "widgets/sweep/sweep_form.hpp"

#include <QAction>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>
#include <algorithm>

#include "widgets/common/parts.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/sweep/sweep_grid.hpp"

namespace abrazo::widgets {
namespace {

constexpr int highest_count = 15;

/// "temporal smoothness (α)"; a symbol with an index does without it in a plain list.
QString setting_name(const SettingInfo& info) {
  const bool plain = !info.symbol.empty() && info.symbol.find('_') == std::string_view::npos;
  return text(info.title) + (plain ? " (" + text(info.symbol) + ")" : QString());
}

/// Values without numbers are all taken.
int value_count(const SettingInfo& info) {
  if (info.kind == SettingInfo::Kind::Body) return 3;
  return info.kind == SettingInfo::Kind::Flag ? 2 : static_cast<int>(split_fields(info.choices, '|').size());
}

}  // namespace

SweepForm::SweepForm(QWidget* parent) : QWidget(parent), m_settings(*preset(preset_names.front())) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(6);
  int column = 1;
  for (const char* name : {"setting", "from", "to", "values"})
    grid->addWidget(quiet_label(name, this), 0, column++);
  const auto index_of = [](std::string_view key) {
    const auto all = all_settings();
    return static_cast<int>(
        std::find_if(all.begin(), all.end(), [key](const SettingInfo& info) { return info.key == key; }) -
        all.begin());
  };
  addSide(m_x, "Columns", 1, index_of("alpha"));
  addSide(m_y, "Rows", 2, index_of("velocity-weight"));
  grid->addWidget(new QLabel("Figure", this), 3, 0);
  m_metric = new QComboBox(this);
  describe(*m_metric, "Figure that is drawn", "A figure of the report, the mean over the takes");
  m_metric->setMaxVisibleItems(20);
  grid->addWidget(m_metric, 3, 1, 1, 2);
  m_takesButton = new QToolButton(this);
  m_takesButton->setObjectName("chip");
  m_takesButton->setPopupMode(QToolButton::InstantPopup);
  m_takesButton->setFocusPolicy(Qt::TabFocus);
  m_takesButton->setToolTip("The takes that play the user, each answered by all the others");
  m_takesMenu = new QMenu(m_takesButton);
  m_takesButton->setMenu(m_takesMenu);
  grid->addWidget(m_takesButton, 3, 3, 1, 3, Qt::AlignLeft);
  grid->setColumnStretch(1, 3);
  grid->setColumnStretch(5, 1);
  connect(m_metric, &QComboBox::currentTextChanged, this, [this] {
    const QString name = m_metric->currentData().toString();
    emit metricChosen(name);
    emit changed();
  });
  nameTakes();
}

void SweepForm::addSide(Side& side, const QString& name, int row, int chosen) {
  auto* grid = static_cast<QGridLayout*>(layout());
  side.setting = new QComboBox(this);
  side.setting->setAccessibleName(name + ": setting");
  for (const SettingInfo& info : all_settings()) side.setting->addItem(setting_name(info), text(info.key));
  side.setting->setCurrentIndex(chosen);
  side.from = new QLineEdit(this);
  side.from->setAccessibleName(name + ": from");
  side.to = new QLineEdit(this);
  side.to->setAccessibleName(name + ": to");
  for (QLineEdit* end : {side.from, side.to}) end->setFixedWidth(74);
  side.count = new QSpinBox(this);
  side.count->setRange(1, highest_count);
  side.count->setAccessibleName(name + ": number of values");
  side.count->setFixedWidth(58);
  side.scale = quiet_label({}, this);
  side.scale->setMinimumWidth(78);
  grid->addWidget(new QLabel(name, this), row, 0);
  grid->addWidget(side.setting, row, 1);
  grid->addWidget(side.from, row, 2);
  grid->addWidget(side.to, row, 3);
  grid->addWidget(side.count, row, 4);
  grid->addWidget(side.scale, row, 5);
  const auto touch = [this, &side] {
    side.touched = true;
    emit changed();
  };
  connect(side.setting, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, &side] {
    side.touched = false;
    propose(side);
    emit changed();
  });
  connect(side.from, &QLineEdit::textEdited, this, touch);
  connect(side.to, &QLineEdit::textEdited, this, touch);
  connect(side.count, qOverload<int>(&QSpinBox::valueChanged), this, [this] { emit changed(); });
  propose(side);
}

void SweepForm::propose(Side& side) {
  const SettingInfo& info = *find_setting(side.setting->currentData().toString().toStdString());
  const bool counted = is_counted(info);
  for (QWidget* field :
       {static_cast<QWidget*>(side.from), static_cast<QWidget*>(side.to), static_cast<QWidget*>(side.count)})
    field->setEnabled(counted);
  const QString unit = info.unit.empty() ? QString() : text(info.unit) + ", ";
  side.scale->setText(!applies(m_settings, info.key) ? "no effect now"
                      : !counted                     ? "all values"
                                 : unit + (info.logarithmic ? "equal ratios" : "equal steps"));
  side.scale->setToolTip(applies(m_settings, info.key) ? QString()
                                                       : text(why_it_does_not_apply(m_settings, info.key)));
  if (!counted) {
    side.from->clear();
    side.to->clear();
    side.count->setValue(value_count(info));
    return;
  }
  const SweepSpan span = usual_span(info, setting_number(m_settings, info.key));
  side.from->setText(QString::number(span.from, 'g', 6));
  side.to->setText(QString::number(span.to, 'g', 6));
  side.count->setValue(span.count);
}

void SweepForm::setSettings(const Settings& settings) {
  m_settings = settings;
  for (Side* side : {&m_x, &m_y}) {
    offer(*side);
    if (!side->touched) propose(*side);
  }
  emit changed();
}

/// A setting without effect now would give equal columns: it is shown, and cannot be chosen.
void SweepForm::offer(Side& side) {
  auto* model = qobject_cast<QStandardItemModel*>(side.setting->model());
  for (int row = 0; row < side.setting->count(); ++row) {
    const std::string key = side.setting->itemData(row).toString().toStdString();
    const bool has_effect = applies(m_settings, key);
    model->item(row)->setEnabled(has_effect);
    side.setting->setItemData(row, has_effect ? QString() : text(why_it_does_not_apply(m_settings, key)),
                              Qt::ToolTipRole);
  }
}

void SweepForm::setMetrics(const std::vector<std::string>& names, const std::string& proposed) {
  const QString before = m_metric->currentData().toString();
  {
    const QSignalBlocker quiet(m_metric);
    m_metric->clear();
    for (const std::string& name : names) m_metric->addItem(text(metric_words(name)), text(name));
    const int kept = m_metric->findData(before.isEmpty() ? text(proposed) : before);
    m_metric->setCurrentIndex(std::max(0, kept));
  }
  emit changed();
}

void SweepForm::setTakes(const std::vector<std::string>& names) {
  if (names == m_takes) return;
  m_takes = names;
  m_answered.assign(names.size(), true);
  refillTakes();
}

void SweepForm::refillTakes() {
  m_takesMenu->clear();
  m_takesMenu->addAction("All", this, [this] {
    std::fill(m_answered.begin(), m_answered.end(), true);
    refillTakes();
  });
  m_takesMenu->addAction("Every third", this, [this] {
    for (std::size_t t = 0; t < m_answered.size(); ++t) m_answered[t] = t % 3 == 0;
    refillTakes();
  });
  m_takesMenu->addSeparator();
  for (std::size_t t = 0; t < m_takes.size(); ++t) {
    QAction* take = m_takesMenu->addAction(text(m_takes[t]));
    take->setCheckable(true);
    take->setChecked(m_answered[t]);
    connect(take, &QAction::toggled, this, [this, t](bool on) {
      m_answered[t] = on;
      nameTakes();
      emit changed();
    });
  }
  nameTakes();
  emit changed();
}

void SweepForm::nameTakes() {
  const auto count = std::count(m_answered.begin(), m_answered.end(), true);
  const auto all = static_cast<std::ptrdiff_t>(m_takes.size());
  QString words =
      count == all ? QString("all %1 takes").arg(all) : QString("%1 of %2 takes").arg(count).arg(all);
  m_takesButton->setText(words + " \u25be");
  m_takesButton->setAccessibleName("Takes that are answered: " + words);
}

std::string SweepForm::axis(const Side& side) const {
  const SettingInfo& info = *find_setting(side.setting->currentData().toString().toStdString());
  return axis_text(info, side.from->text().trimmed().toStdString(), side.to->text().trimmed().toStdString(),
                   side.count->value());
}

SweepRequest SweepForm::request() const {
  SweepRequest request{axis(m_x), axis(m_y), m_metric->currentData().toString().toStdString(), {}};
  const bool all = std::find(m_answered.begin(), m_answered.end(), false) == m_answered.end();
  for (std::size_t t = 0; t < m_takes.size() && !all; ++t)
    if (m_answered[t]) request.takes.push_back(m_takes[t]);
  return request;
}

void SweepForm::setColumns(const std::string& key) {
  const int before = m_x.setting->currentIndex(), wanted = m_x.setting->findData(text(key));
  if (m_y.setting->currentIndex() == wanted) m_y.setting->setCurrentIndex(before);
  m_x.setting->setCurrentIndex(wanted);
}

void SweepForm::setRunning(bool running) {
  // What was computed stays in view, also when one of its points becomes the settings.
  if (running) m_x.touched = m_y.touched = true;
  for (Side* side : {&m_x, &m_y}) {
    const bool counted = is_counted(*find_setting(side->setting->currentData().toString().toStdString()));
    side->setting->setEnabled(!running);
    for (QWidget* field : {static_cast<QWidget*>(side->from), static_cast<QWidget*>(side->to),
                           static_cast<QWidget*>(side->count)})
      field->setEnabled(!running && counted);
  }
  m_takesButton->setEnabled(!running);
}

}  // namespace abrazo::widgets
