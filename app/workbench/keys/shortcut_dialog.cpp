#include "app/workbench/keys/shortcut_dialog.hpp"

#include <algorithm>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "app/workbench/base/dialog_size.hpp"
#include "app/workbench/keys/key_entry.hpp"
#include "app/workbench/keys/shortcuts.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::app {
namespace {

enum ShortcutColumn { Menu, Action, Keys, Usual };
constexpr int id_role = Qt::UserRole;

QString shown_keys(const std::vector<std::string>& keys) {
  QStringList words;
  for (const std::string& key : keys) words << Shortcuts::shown(key);
  return words.join("   ");
}

QString place_words(KeyPlace place) {
  const std::string_view words = words_of(place);
  return QString::fromUtf8(words.data(), static_cast<int>(words.size()));
}

QString menu_words(const Shortcut& shortcut) {
  if (shortcut.is_fixed) return shortcut.place == KeyPlace::Scene ? "in the scene" : "in the timeline";
  return QString::fromStdString(shortcut.menu);
}

}  // namespace

ShortcutDialog::ShortcutDialog(Shortcuts& shortcuts, QWidget* parent)
    : QDialog(parent), m_shortcuts(shortcuts) {
  setObjectName("shortcuts");
  setWindowTitle("Shortcuts");
  resize_within_screen(*this, {820, 640});
  auto* column = widgets::column_in(this, {16, 16, 16, 16});
  m_filter = new QLineEdit(this);
  m_filter->setPlaceholderText("Filter by menu, action or key");
  m_filter->setAccessibleName("Filter shortcuts");
  m_filter->setClearButtonEnabled(true);
  m_rows = new QTreeWidget(this);
  m_rows->setAccessibleName("Actions and their keys");
  m_rows->setHeaderLabels({"Menu", "Action", "Keys", "Default keys"});
  m_rows->setRootIsDecorated(false);
  m_rows->setUniformRowHeights(true);
  m_rows->setSortingEnabled(true);
  m_rows->sortByColumn(-1, Qt::AscendingOrder);  // as in the menus until a head is clicked
  column->addWidget(m_filter);
  column->addWidget(m_rows, 1);
  column->addWidget(makeEditor());
  fill();
  m_rows->setColumnWidth(Menu, 170);
  m_rows->setColumnWidth(Action, 290);
  m_rows->setColumnWidth(Keys, 156);
  connect(m_filter, &QLineEdit::textChanged, this, &ShortcutDialog::filter);
  connect(m_rows, &QTreeWidget::currentItemChanged, this, &ShortcutDialog::showChosen);
  connect(m_rows, &QTreeWidget::itemActivated, m_entry, [this] { m_entry->setFocus(); });
  connect(&shortcuts, &Shortcuts::changed, this, &ShortcutDialog::fill);
  m_rows->setCurrentItem(m_rows->topLevelItem(0));
  setTabOrder(m_filter, m_rows);
  setTabOrder(m_rows, m_entry);
  setTabOrder(m_entry, m_add);
  m_filter->setFocus();
}

QWidget* ShortcutDialog::makeEditor() {
  auto* box = new QWidget(this);
  auto* column = widgets::column_in(box, {0, 4, 0, 0});
  m_name = new QLabel(box);
  m_keys = new QHBoxLayout;
  m_entry = new KeyEntry(box);
  m_add = new QPushButton("Add", box);
  m_reset = new QPushButton("Default keys", box);
  m_resetAll = new QPushButton("Default keys for all", box);
  auto* close = new QPushButton("Close", box);
  m_verdict = new QLabel(box);
  m_verdict->setWordWrap(true);
  m_verdict->setMinimumHeight(m_verdict->fontMetrics().lineSpacing() * 2);
  for (QPushButton* button : {m_add, m_reset, m_resetAll, close}) button->setAutoDefault(false);
  auto* first = new QHBoxLayout;
  first->addWidget(m_name);
  first->addLayout(m_keys);
  first->addStretch(1);
  first->addWidget(m_entry);
  first->addWidget(m_add);
  auto* last = new QHBoxLayout;
  last->addWidget(m_reset);
  last->addWidget(m_resetAll);
  last->addStretch(1);
  last->addWidget(close);
  column->addLayout(first);
  column->addWidget(m_verdict);
  column->addLayout(last);
  connect(m_entry, &KeyEntry::pressed, this, &ShortcutDialog::judge);
  connect(m_add, &QPushButton::clicked, this, &ShortcutDialog::addKey);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(m_reset, &QPushButton::clicked, this, [this] {
    ShortcutTable next = m_shortcuts.table();
    next.reset(chosen());
    m_shortcuts.change(next);
  });
  connect(m_resetAll, &QPushButton::clicked, this, [this] {
    ShortcutTable next = m_shortcuts.table();
    next.reset_all();
    m_shortcuts.change(next);
  });
  return box;
}

void ShortcutDialog::fill() {
  const std::string before = chosen();
  const QSignalBlocker quiet(m_rows);
  m_rows->clear();
  for (const Shortcut& shortcut : m_shortcuts.table().all()) {
    auto* row = new QTreeWidgetItem({menu_words(shortcut), QString::fromStdString(shortcut.text),
                                     shown_keys(shortcut.keys), shown_keys(shortcut.usual)});
    row->setData(0, id_role, QString::fromStdString(shortcut.id));
    QFont font = row->font(Keys);
    font.setBold(shortcut.is_changed());
    row->setFont(Keys, font);
    if (shortcut.is_fixed) row->setToolTip(Keys, "A fixed key of the view; it cannot be changed");
    m_rows->addTopLevelItem(row);
  }
  filter(m_filter->text());
  choose(before);
  showChosen();
}

void ShortcutDialog::filter(const QString& words) {
  const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
  for (int i = 0; i < m_rows->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = m_rows->topLevelItem(i);
    const QString line = row->text(Menu) + " " + row->text(Action) + " " + row->text(Keys);
    const bool fits = std::all_of(wanted.begin(), wanted.end(), [&line](const QString& word) {
      return line.contains(word, Qt::CaseInsensitive);
    });
    row->setHidden(!fits);
  }
}

std::string ShortcutDialog::chosen() const {
  const QTreeWidgetItem* row = m_rows->currentItem();
  return row ? row->data(0, id_role).toString().toStdString() : std::string();
}

void ShortcutDialog::choose(const std::string& id) {
  for (int i = 0; i < m_rows->topLevelItemCount(); ++i)
    if (m_rows->topLevelItem(i)->data(0, id_role).toString().toStdString() == id)
      m_rows->setCurrentItem(m_rows->topLevelItem(i));
}

QString ShortcutDialog::verdict() const {
  return m_verdict->text();
}

void ShortcutDialog::showChosen() {
  while (QLayoutItem* item = m_keys->takeAt(0)) {
    if (QWidget* old = item->widget()) old->hide(), old->deleteLater();  // it may be the clicked button
    delete item;
  }
  m_entry->forget();
  const Shortcut* shortcut = m_shortcuts.table().find(chosen());
  const bool can_change = shortcut && !shortcut->is_fixed;
  m_name->setText(shortcut ? QString::fromStdString(shortcut->text) + "  " : "Choose an action");
  for (const std::string& key : can_change ? shortcut->keys : std::vector<std::string>()) {
    auto* button = new QPushButton(Shortcuts::shown(key) + "  ×", this);
    button->setAutoDefault(false);
    widgets::describe(*button, "Remove " + Shortcuts::shown(key), "Remove this key");
    connect(button, &QPushButton::clicked, this, [this, key] { removeKey(key); });
    m_keys->addWidget(button);
  }
  m_entry->setEnabled(can_change);
  m_reset->setEnabled(can_change && shortcut->is_changed());
  judge();
}

/// Says immediately which action has the key that was pressed, and where.
void ShortcutDialog::judge() {
  const Shortcut* shortcut = m_shortcuts.table().find(chosen());
  m_add->setText("Add");
  m_add->setEnabled(shortcut && !m_entry->key().empty());
  m_verdict->clear();
  if (!shortcut || m_entry->key().empty()) return;
  QStringList words;
  bool takes_over = false;
  for (const Shortcut* other : m_shortcuts.table().clashes(shortcut->id, m_entry->key())) {
    const QString text = QString::fromStdString(other->text);
    const QString place = place_words(other->place);
    if (other->is_fixed)
      words << QString("%1 stays%2: %3.").arg(m_entry->text(), place, text);
    else
      words << QString("%1 belongs to \"%2\"%3 (%4), which would lose it.")
                   .arg(m_entry->text(), text, place, QString::fromStdString(other->menu));
    takes_over |= !other->is_fixed;
  }
  if (std::find(shortcut->keys.begin(), shortcut->keys.end(), m_entry->key()) != shortcut->keys.end()) {
    words << "It has this key already.";
    m_add->setEnabled(false);
  }
  if (takes_over) m_add->setText("Take over");
  m_verdict->setText(words.isEmpty() ? m_entry->text() + " is free." : "⚠ " + words.join(" "));
}

void ShortcutDialog::addKey() {
  ShortcutTable next = m_shortcuts.table();
  next.give(chosen(), m_entry->key());
  m_entry->setFocus();
  m_shortcuts.change(next);
}

void ShortcutDialog::removeKey(const std::string& key) {
  ShortcutTable next = m_shortcuts.table();
  next.take(chosen(), key);
  m_shortcuts.change(next);
}

}  // namespace abrazo::app
