#include "widgets/settings/preset_bar.hpp"

#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

QToolButton* add_segment(QWidget* bar, QHBoxLayout* row, bool first, bool last) {
  auto* button = new QToolButton(bar);
  button->setObjectName("segment");
  button->setProperty("first", first);
  button->setProperty("last", last);
  button->setCheckable(true);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setFocusPolicy(Qt::TabFocus);
  row->addWidget(button, 1);
  return button;
}

}  // namespace

PresetBar::PresetBar(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 0, 12, 8);
  row->setSpacing(0);
  for (std::size_t i = 0; i < preset_names.size(); ++i) {
    QToolButton* button = add_segment(this, row, i == 0, false);
    const QString name = text(preset_names[i]);
    connect(button, &QToolButton::clicked, this, [this, name] {
      showChoice(m_choice, m_changed);  // the button has checked itself; what comes of it is shown later
      emit chosen(name);
    });
    m_given.push_back(button);
  }
  m_given.front()->setToolTip("Exactly the published method: 15 steps per second, no further terms");
  m_given.back()->setToolTip("Small lag and few jumps, at the input's own rate");
  m_ownButton = add_segment(this, row, false, true);
  m_ownButton->setToolTip("Your own presets: choose, save, rename, delete, export, import");
  m_ownButton->setPopupMode(QToolButton::InstantPopup);
  m_menu = new QMenu(m_ownButton);
  m_ownButton->setMenu(m_menu);
  connect(m_menu, &QMenu::aboutToShow, this, [this] { fillMenu(*m_menu); });
  connect(m_menu, &QMenu::aboutToHide, this, [this] { showChoice(m_choice, m_changed); });
  showChoice(m_choice, false);
}

void PresetBar::setOwn(std::vector<OwnPreset> own) {
  m_own = std::move(own);
}

void PresetBar::showChoice(const PresetChoice& choice, bool changed) {
  m_choice = choice;
  m_changed = changed;
  const QString star = changed ? " *" : "", spoken = changed ? ", changed" : "";
  for (std::size_t i = 0; i < m_given.size(); ++i) {
    const QString name = text(preset_names[i]);
    const bool is_chosen = !choice.own && choice.name == preset_names[i];
    m_given[i]->setChecked(is_chosen);
    m_given[i]->setText(is_chosen ? name + star : name);
    m_given[i]->setAccessibleName("Preset " + name + (is_chosen ? ", chosen" + spoken : ""));
  }
  const QString name = choice.own ? text(choice.name) : "mine";
  m_ownButton->setChecked(choice.own);
  m_ownButton->setText(m_ownButton->fontMetrics().elidedText(name, Qt::ElideRight, 96) +
                       (choice.own ? star : "") + " \u25be");
  m_ownButton->setAccessibleName(choice.own ? "Own preset " + name + ", chosen" + spoken : "Own presets");
}

void PresetBar::fillMenu(QMenu& menu) {
  menu.clear();
  for (const OwnPreset& preset : m_own) {
    const QString name = text(preset.name);
    QAction* action =
        menu.addAction(QString(name).replace("&", "&&"), this, [this, name] { emit ownChosen(name); });
    action->setCheckable(true);
    action->setChecked(m_choice.own && m_choice.name == preset.name);
  }
  if (!m_own.empty()) menu.addSeparator();
  addManagement(menu);
}

void PresetBar::addManagement(QMenu& menu) {
  menu.addAction("Save these settings as\u2026", this, &PresetBar::saveRequested);
  if (m_choice.own) {
    const QString name = text(m_choice.name), shown = "\u201c" + QString(name).replace("&", "&&") + "\u201d";
    menu.addAction("Save to " + shown, this, [this, name] { emit overwriteRequested(name); })
        ->setEnabled(m_changed);
    menu.addAction("Rename " + shown + "\u2026", this, [this, name] { emit renameRequested(name); });
    menu.addAction("Delete " + shown, this, [this, name] { emit removeRequested(name); });
  }
  menu.addSeparator();
  menu.addAction("Export these settings\u2026", this, &PresetBar::exportRequested);
  menu.addAction("Import settings\u2026", this, &PresetBar::importRequested);
}

}  // namespace abrazo::widgets
