#include "widgets/settings/settings_panel.hpp"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QToolButton>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QVariant>

#include "widgets/common/section_header.hpp"
#include "widgets/settings/setting_row.hpp"

namespace abrazo::widgets {

/// From one whole value to another. Moves of one drag become one change.
class ChangeSettings : public QUndoCommand {
 public:
  ChangeSettings(SettingsPanel& panel, Settings before, Settings after, QString key, int gesture)
      : m_panel(panel), m_before(before), m_after(after), m_key(std::move(key)), m_gesture(gesture) {}

  void redo() override { m_panel.apply(m_after); }
  void undo() override { m_panel.apply(m_before); }
  int id() const override { return m_gesture > 0 ? 1 : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const ChangeSettings*>(other);
    if (next->m_key != m_key || next->m_gesture != m_gesture) return false;
    m_after = next->m_after;
    return true;
  }

 private:
  SettingsPanel& m_panel;
  Settings m_before, m_after;
  QString m_key;
  int m_gesture;
};

SettingsPanel::SettingsPanel(QUndoStack& undo, QWidget* parent) : QWidget(parent), m_undo(undo) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  m_heads.push_back(new SectionHeader("Settings", this));
  column->addWidget(m_heads.back());
  column->addWidget(presetButtons());
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(rowList());
  scroll->viewport()->setAutoFillBackground(false);
  scroll->widget()->setAutoFillBackground(false);
  column->addWidget(scroll, 1);
  m_preset = QString::fromUtf8(preset_names[0].data());
  showSettings(preset(preset_names[0]).value());
}

QWidget* SettingsPanel::presetButtons() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(12, 0, 12, 8);
  row->setSpacing(0);
  for (std::size_t i = 0; i < preset_names.size(); ++i) {
    auto* button = new QToolButton(box);
    button->setObjectName("segment");
    button->setProperty("first", i == 0);
    button->setProperty("last", i + 1 == preset_names.size());
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
    const QString name = QString::fromUtf8(preset_names[i].data(), static_cast<int>(preset_names[i].size()));
    button->setProperty("preset", name);
    connect(button, &QToolButton::clicked, this, [this, name] { choosePreset(name); });
    row->addWidget(button, 1);
    m_presets.push_back(button);
  }
  m_presets.front()->setToolTip("The method to the letter: 15 steps a second, no further terms");
  m_presets.back()->setToolTip("Small lag and few jumps, at the input's own rate");
  return box;
}

QWidget* SettingsPanel::rowList() {
  auto* list = new QWidget(this);
  auto* column = new QVBoxLayout(list);
  column->setContentsMargins(0, 0, 0, 8);
  column->setSpacing(0);
  std::string_view group;
  for (const SettingInfo& info : all_settings()) {
    if (info.group != group) {
      group = info.group;
      m_heads.push_back(
          new SectionHeader(QString::fromUtf8(group.data(), static_cast<int>(group.size())), list));
      m_heads.back()->setFixedHeight(28);
      column->addWidget(m_heads.back());
    }
    m_rows.push_back(new SettingRow(info, list));
    connect(m_rows.back(), &SettingRow::changed, this, &SettingsPanel::change);
    column->addWidget(m_rows.back());
  }
  column->addStretch(1);
  return list;
}

void SettingsPanel::setColours(const Palette& palette) {
  for (SectionHeader* head : m_heads) head->setColours(palette);
  for (SettingRow* row : m_rows) row->setColours(palette);
}

void SettingsPanel::showSettings(const Settings& settings) {
  m_settings = settings;
  for (const std::string_view name : preset_names) {
    if (preset(name).value() != settings) continue;
    m_preset = QString::fromUtf8(name.data(), static_cast<int>(name.size()));
  }
  m_presetSettings = preset(m_preset.toStdString()).value();
  for (QToolButton* button : m_presets) {
    const QString name = button->property("preset").toString();
    const bool chosen = name == m_preset;
    button->setChecked(chosen);
    button->setText(chosen && m_settings != m_presetSettings ? name + " *" : name);
  }
  for (SettingRow* row : m_rows) row->show(m_settings, m_presetSettings);
}

void SettingsPanel::apply(const Settings& settings) {
  showSettings(settings);
  emit commandRequested(SetSettings{settings});
}

void SettingsPanel::push(const Settings& next, const QString& what, const QString& key, int gesture) {
  if (next == m_settings) return showSettings(m_settings);
  auto* command = new ChangeSettings(*this, m_settings, next, key, gesture);
  command->setText(what);
  m_undo.push(command);
}

void SettingsPanel::choosePreset(const QString& name) {
  const auto chosen = preset(name.toStdString());
  if (!chosen) return emit mistaken(QString::fromStdString(chosen.error().text()));
  push(*chosen, "preset " + name, "preset", 0);
}

void SettingsPanel::change(const QString& key, const QString& text, int gesture) {
  Settings next = m_settings;
  const Status set = set_setting(next, key.toStdString(), text.toStdString());
  if (!set) {
    showSettings(m_settings);
    return emit mistaken(QString::fromStdString(set.error().text()));
  }
  push(next, key, key, gesture);
}

}  // namespace abrazo::widgets
