#include "widgets/settings/settings_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/scrolled.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/common/typeset.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/settings/preset_bar.hpp"
#include "widgets/settings/setting_help.hpp"
#include "widgets/settings/setting_row.hpp"

namespace abrazo::widgets {
namespace {

constexpr int least_filter_width = 44, filter_width = 96, group_head_height = 24;
constexpr std::size_t tuned_rows = 5;  ///< method, alpha, k and the first weights

/// "α, w_Δ, foot locks": what of a frame's settings is otherwise.
QString differing(const Settings& of_frame, const Settings& now) {
  QStringList names;
  for (const SettingInfo& info : all_settings())
    if (setting_text(of_frame, info.key) != setting_text(now, info.key))
      names << QString::fromStdString(typeset(info.symbol.empty() ? info.title : info.symbol));
  if (names.size() > 4)
    return QString("%1 and %2 more").arg(names.mid(0, 3).join(", ")).arg(names.size() - 3);
  return names.join(", ");
}

}  // namespace

SettingsPanel::SettingsPanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  m_heads.push_back(new SectionHeader("Settings", this));
  column->addWidget(m_heads.back());
  m_presets = new PresetBar(this);
  auto* above = new QHBoxLayout;
  above->setSpacing(0);
  above->addWidget(m_presets, 1);
  above->addWidget(filterField());
  column->addLayout(above);
  auto* scroll = new QScrollArea(this);
  scroll_vertically(*scroll, rowList());
  scroll->setFocusPolicy(Qt::NoFocus);
  column->addWidget(scroll, 1);
  column->addWidget(frameNotice());  // comes and goes while a slider is dragged: below, so that none moves
  connect(m_presets, &PresetBar::chosen, this,
          [this](const QString& name) { emit presetRequested(name, false); });
  connect(m_presets, &PresetBar::ownChosen, this,
          [this](const QString& name) { emit presetRequested(name, true); });
  showSettings(m_choice.settings, m_choice);
}

QWidget* SettingsPanel::filterField() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 12, 8);
  m_filter = new QLineEdit(box);
  m_filter->setObjectName("filter");
  m_filter->setPlaceholderText("Filter");
  m_filter->setMinimumWidth(least_filter_width);  // long names of presets come first
  m_filter->setMaximumWidth(filter_width);
  m_filter->setAccessibleName("Filter settings");
  m_filter->setClearButtonEnabled(true);
  m_filter->setFocusPolicy(Qt::StrongFocus);
  row->addWidget(m_filter);
  connect(m_filter, &QLineEdit::textChanged, this, &SettingsPanel::filter);
  return box;
}

QWidget* SettingsPanel::frameNotice() {
  m_notice = new QWidget(this);
  auto* row = new QHBoxLayout(m_notice);
  row->setContentsMargins(12, 6, 12, 8);
  row->setSpacing(8);
  m_noticeText = new QLabel(m_notice);
  m_noticeText->setTextFormat(Qt::RichText);
  m_noticeText->setWordWrap(true);
  auto* use = new QPushButton("Use its settings", m_notice);
  use->setObjectName("useFrameSettings");
  use->setToolTip("Applies the settings of the shown frame to the solver");
  use->setFocusPolicy(Qt::TabFocus);
  row->addWidget(m_noticeText, 1);
  row->addWidget(use);
  m_notice->hide();
  connect(use, &QPushButton::clicked, this, [this] {
    if (m_ofFrame) emit settingsRequested(*m_ofFrame, "settings of the shown frame");
  });
  return m_notice;
}

QWidget* SettingsPanel::rowList() {
  auto* list = new QWidget(this);
  auto* column = new QVBoxLayout(list);
  column->setContentsMargins(0, 0, 0, 8);
  column->setSpacing(0);
  for (const SettingInfo& info : all_settings()) {
    if (m_rows.empty() || m_rows.back()->info().group != info.group) {
      m_heads.push_back(new SectionHeader(text(info.group), list));
      m_heads.back()->setFixedHeight(group_head_height);
      column->addWidget(m_heads.back());
      m_groups.push_back({m_heads.back(), {}});
    }
    m_rows.push_back(new SettingRow(info, list));
    m_groups.back().rows.push_back(m_rows.back());
    connect(m_rows.back(), &SettingRow::changed, this, &SettingsPanel::entryRequested);
    connect(m_rows.back(), &SettingRow::sweepRequested, this, &SettingsPanel::sweepRequested);
    connect(m_rows.back(), &SettingRow::fileRequested, this, &SettingsPanel::fileRequested);
    column->addWidget(m_rows.back());
  }
  m_noMatch = new QLabel("No setting has these words.", list);
  m_noMatch->setObjectName("secondary");
  m_noMatch->setContentsMargins(12, 8, 12, 8);
  m_noMatch->hide();
  column->addWidget(m_noMatch);
  column->addStretch(1);
  return list;
}

QSize SettingsPanel::sizeHint() const {
  int height = m_presets->sizeHint().height() + group_head_height;
  for (std::size_t row = 0; row < tuned_rows; ++row) height += m_rows[row]->minimumHeight();
  return {QWidget::sizeHint().width(), height};
}

void SettingsPanel::filter(const QString& wanted) {
  if (m_filter->text() != wanted) m_filter->setText(wanted);
  const std::string words = wanted.toStdString();
  bool any = false;
  for (const Group& group : m_groups) {
    bool any_here = false;
    for (SettingRow* row : group.rows) {
      const bool fits = matches(row->info(), words);
      row->setVisible(fits);
      any_here = any_here || fits;
    }
    group.head->setVisible(any_here);
    any = any || any_here;
  }
  m_noMatch->setVisible(!any);
}

void SettingsPanel::takeFocus() {
  m_filter->setFocus();
  m_filter->selectAll();
}

void SettingsPanel::setColours(const Palette& palette) {
  for (SectionHeader* head : m_heads) head->setColours(palette);
  for (SettingRow* row : m_rows) row->setColours(palette);
  refresh();
}

void SettingsPanel::showSettings(const Settings& settings, const PresetChoice& choice) {
  m_settings = settings;
  m_choice = choice;
  refresh();
}

void SettingsPanel::showFrameSettings(const std::optional<Settings>& of_frame) {
  if (of_frame == m_ofFrame) return;
  m_ofFrame = of_frame;
  refresh();
}

void SettingsPanel::refresh() {
  m_presets->showChoice(m_choice, m_settings != m_choice.settings);
  const bool differs = m_ofFrame && *m_ofFrame != m_settings;
  for (SettingRow* row : m_rows) row->show(m_settings, m_choice.settings, differs ? &*m_ofFrame : nullptr);
  if (differs)
    m_noticeText->setText("The shown frame was solved with other settings: " +
                          differing(*m_ofFrame, m_settings));
  m_notice->setVisible(differs);
}

}  // namespace abrazo::widgets
