#include "widgets/settings/settings_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/section_header.hpp"
#include "widgets/common/typeset.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/settings/preset_bar.hpp"
#include "widgets/settings/setting_help.hpp"
#include "widgets/settings/setting_row.hpp"

namespace abrazo::widgets {
namespace {

/// "α, w_Δ, foot locks": what of a frame's settings is otherwise.
QString differing(const Settings& of_frame, const Settings& now) {
  QStringList names;
  for (const SettingInfo& info : all_settings())
    if (setting_number(of_frame, info.key) != setting_number(now, info.key))
      names << QString::fromStdString(typeset(info.symbol.empty() ? info.title : info.symbol));
  if (names.size() > 4)
    return QString("%1 and %2 more").arg(names.mid(0, 3).join(", ")).arg(names.size() - 3);
  return names.join(", ");
}

}  // namespace

/// From one whole value to another. Moves of one drag become one change, and none when it ends where it
/// began.
class ChangeSettings : public QUndoCommand {
 public:
  ChangeSettings(SettingsPanel& panel, SettingsPanel::State after, QString key, int gesture)
      : m_panel(panel),
        m_before{panel.m_settings, panel.m_choice},
        m_after(std::move(after)),
        m_key(std::move(key)),
        m_gesture(gesture) {}

  void redo() override { m_panel.apply(m_after); }
  void undo() override { m_panel.apply(m_before); }
  int id() const override { return m_gesture > 0 ? 1 : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const ChangeSettings*>(other);
    if (next == nullptr || next->m_key != m_key || next->m_gesture != m_gesture) return false;
    m_after = next->m_after;
    setText(next->text());
    setObsolete(m_after.settings == m_before.settings);
    return true;
  }

 private:
  SettingsPanel& m_panel;
  SettingsPanel::State m_before, m_after;
  QString m_key;
  int m_gesture;
};

SettingsPanel::SettingsPanel(QUndoStack& undo, QWidget* parent) : QWidget(parent), m_undo(undo) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  m_heads.push_back(new SectionHeader("Settings", this));
  column->addWidget(m_heads.back());
  m_presets = new PresetBar(this);
  column->addWidget(m_presets);
  column->addWidget(frameNotice());
  column->addWidget(filterField());
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(rowList());
  scroll->viewport()->setAutoFillBackground(false);
  scroll->widget()->setAutoFillBackground(false);
  column->addWidget(scroll, 1);
  connect(m_presets, &PresetBar::chosen, this, &SettingsPanel::choosePreset);
  connect(m_presets, &PresetBar::ownChosen, this, &SettingsPanel::chooseOwnPreset);
  showSettings(m_choice.settings);
}

QWidget* SettingsPanel::filterField() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(12, 0, 12, 2);
  m_filter = new QLineEdit(box);
  m_filter->setObjectName("filter");
  m_filter->setPlaceholderText("Filter settings");
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
  row->setContentsMargins(12, 0, 12, 8);
  row->setSpacing(8);
  m_noticeText = new QLabel(m_notice);
  m_noticeText->setTextFormat(Qt::RichText);
  m_noticeText->setWordWrap(true);
  auto* use = new QPushButton("Use its settings", m_notice);
  use->setObjectName("useFrameSettings");
  use->setToolTip("The settings that the shown frame was solved under become those of the solver");
  use->setFocusPolicy(Qt::TabFocus);
  row->addWidget(m_noticeText, 1);
  row->addWidget(use);
  m_notice->hide();
  connect(use, &QPushButton::clicked, this, [this] {
    if (m_ofFrame) adopt(*m_ofFrame, "settings of the shown frame");
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
      m_heads.back()->setFixedHeight(28);
      column->addWidget(m_heads.back());
      m_groups.push_back({m_heads.back(), {}});
    }
    m_rows.push_back(new SettingRow(info, list));
    m_groups.back().rows.push_back(m_rows.back());
    connect(m_rows.back(), &SettingRow::changed, this, &SettingsPanel::change);
    connect(m_rows.back(), &SettingRow::sweepRequested, this, &SettingsPanel::sweepRequested);
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

void SettingsPanel::setColours(const Palette& palette) {
  for (SectionHeader* head : m_heads) head->setColours(palette);
  for (SettingRow* row : m_rows) row->setColours(palette);
  refresh();
}

void SettingsPanel::setOwnPresets(std::vector<OwnPreset> own) {
  m_own = own;
  m_presets->setOwn(std::move(own));
  const bool is_gone = m_choice.own && std::none_of(m_own.begin(), m_own.end(), [this](const OwnPreset& p) {
                         return p.name == m_choice.name;
                       });
  if (is_gone) m_choice = {};
  for (const OwnPreset& preset : m_own)
    if (m_choice.own && preset.name == m_choice.name) m_choice.settings = preset.settings;
  showSettings(m_settings);
}

void SettingsPanel::showSettings(const Settings& settings) {
  m_settings = settings;
  m_choice = choice_for(settings, m_choice, m_own);
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

void SettingsPanel::apply(const State& state) {
  m_settings = state.settings;
  m_choice = state.choice;
  refresh();
  emit commandRequested(SetSettings{state.settings});
}

void SettingsPanel::push(const State& next, const QString& what, const QString& key, int gesture) {
  if (next.settings == m_settings) {  // of another name, perhaps: nothing that a step of undo would show
    m_choice = next.choice;
    return refresh();
  }
  auto* command = new ChangeSettings(*this, next, key, gesture);
  command->setText(what);
  m_undo.push(command);
}

void SettingsPanel::choosePreset(const QString& name) {
  const auto chosen = preset(name.toStdString());
  if (!chosen) return emit mistaken(QString::fromStdString(chosen.error().text()));
  push({*chosen, {name.toStdString(), false, *chosen}}, "preset " + name, "preset", 0);
}

void SettingsPanel::chooseOwnPreset(const QString& name) {
  const std::string wanted = name.toStdString();
  const auto found =
      std::find_if(m_own.begin(), m_own.end(), [&](const OwnPreset& p) { return p.name == wanted; });
  if (found == m_own.end()) return emit mistaken("There is no own preset \u201c" + name + "\u201d");
  push({found->settings, {wanted, true, found->settings}}, "preset " + name, "preset", 0);
}

void SettingsPanel::adopt(const Settings& settings, const QString& what) {
  push({settings, choice_for(settings, m_choice, m_own)}, what, "adopt", 0);
}

void SettingsPanel::change(const QString& key, const QString& entry, int gesture) {
  Settings next = m_settings;
  const Status set = set_setting(next, key.toStdString(), entry.toStdString());
  if (!set) {
    refresh();
    return emit mistaken(QString::fromStdString(set.error().text()));
  }
  const SettingInfo* info = find_setting(key.toStdString());
  const QString value = QString::fromStdString(setting_text(next, info->key));
  push({next, choice_for(next, m_choice, m_own)}, text(info->title) + " to " + value, key, gesture);
}

}  // namespace abrazo::widgets
