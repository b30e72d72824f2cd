#include "app/workbench/keys/shortcuts.hpp"

#include <QAction>
#include <QActionEvent>
#include <QFile>
#include <QKeySequence>
#include <QMenu>

#include "app/workbench/base/action_id.hpp"
#include "app/workbench/base/error_words.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/atomic_file.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

constexpr const char* usual_keys = "usual keys";

QStringList keys_of(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) keys << key.toString(QKeySequence::PortableText);
  keys.removeAll({});
  return keys;
}

std::vector<std::string> texts(const QStringList& keys) {
  std::vector<std::string> result;
  for (const QString& key : keys) result.push_back(key.toStdString());
  return result;
}

KeyPlace place_of(const MainWindow& window, const QAction& action) {
  if (action.shortcutContext() != Qt::WidgetWithChildrenShortcut) return KeyPlace::Window;
  for (const QWidget* widget : action.associatedWidgets()) {
    if (widget == &window.scene()) return KeyPlace::Scene;
    if (widget == &window.timeline()) return KeyPlace::Timeline;
  }
  return KeyPlace::Window;
}

/// What views take before any action; see their ShortcutOverride and KeyRouting.
const std::vector<Shortcut>& fixed_keys() {
  const auto row = [](std::string id, std::string text, const std::vector<std::string>& keys,
                      KeyPlace place) {
    return Shortcut{std::move(id), "", std::move(text), keys, keys, place, true};
  };
  static const std::vector<Shortcut> rows = {
      row("scene.all", "Show all", {"Home"}, KeyPlace::Scene),
      row("timeline.labels", "Reserved for labels", {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"},
          KeyPlace::Timeline),
      row("timeline.shorter", "Shorter span", {"+", "="}, KeyPlace::Timeline),
      row("timeline.longer", "Longer span", {"-"}, KeyPlace::Timeline),
      row("timeline.earlier", "Move the view back", {"PgUp"}, KeyPlace::Timeline),
      row("timeline.later", "Move the view forward", {"PgDown"}, KeyPlace::Timeline)};
  return rows;
}

}  // namespace

std::string Shortcuts::normal(const std::string& key) {
  const QKeySequence parsed(QString::fromStdString(key), QKeySequence::PortableText);
  const bool is_one = parsed.count() == 1 && (parsed[0] & ~Qt::KeyboardModifierMask) != Qt::Key_unknown;
  return is_one ? parsed.toString(QKeySequence::PortableText).toStdString() : std::string();
}

QString Shortcuts::shown(const std::string& key) {
  return QKeySequence(QString::fromStdString(key), QKeySequence::PortableText)
      .toString(QKeySequence::NativeText);
}

Shortcuts::Shortcuts(MainWindow& window)
    : QObject(&window), m_window(window), m_file(window.remembered().folder() + "/shortcuts.json") {}

void Shortcuts::begin() {
  collect();
  m_window.installEventFilter(this);
}

QAction* Shortcuts::action(const std::string& id) const {
  return m_actions.value(QString::fromStdString(id));
}

void Shortcuts::add(QAction& action) {
  if (action.isSeparator() || action.menu() || action.text().isEmpty()) return;
  if (!action.property(usual_keys).isValid()) action.setProperty(usual_keys, keys_of(action));
  const QString menu = menu_path(action);
  // Named once, for some actions change their words: "Undo alpha 0.5". A name that others share is no id.
  std::string id = action_id(menu.toStdString(), action.text().toStdString());
  if (action.objectName().isEmpty()) action.setObjectName(QString::fromStdString(id));
  if (action.objectName().contains('.')) id = action.objectName().toStdString();
  if (m_table.find(id)) return;
  m_actions[QString::fromStdString(id)] = &action;
  m_table.add({id, menu.toStdString(), action.text().toStdString(), texts(keys_of(action)),
               texts(action.property(usual_keys).toStringList()), place_of(m_window, action)});
}

/// All actions with default keys, overridden by the stored ones.
void Shortcuts::collect() {
  m_isDue = false;
  m_table = {};
  m_actions.clear();
  for (QAction* action : m_window.findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly)) add(*action);
  for (const Shortcut& fixed : fixed_keys()) m_table.add(fixed);
  m_table.reset_all();
  if (!QFile::exists(m_file)) return apply();
  const auto text = read_whole_file(m_file.toStdString());
  QStringList troubles;
  if (!text)
    troubles << words(text.error());
  else
    for (const std::string& trouble : m_table.read(*text, normal))
      troubles << m_file + ": " + QString::fromStdString(trouble);
  m_isDamaged = troubles.size() == 1 && troubles.front().contains("damaged");
  tell(troubles);
  apply();
}

void Shortcuts::tell(const QStringList& troubles) {
  if (troubles == m_told) return;
  m_told = troubles;
  if (!troubles.isEmpty()) m_window.messages().showWarnings(troubles);
}

void Shortcuts::apply() {
  for (const Shortcut& each : m_table.all()) {
    QAction* action = this->action(each.id);
    if (!action) continue;
    QList<QKeySequence> keys;
    for (const std::string& key : each.keys)
      keys << QKeySequence(QString::fromStdString(key), QKeySequence::PortableText);
    if (action->shortcuts() != keys) action->setShortcuts(keys);
  }
  emit changed();
}

void Shortcuts::change(const ShortcutTable& next) {
  m_table = next;
  apply();
  save();
}

void Shortcuts::save() {
  if (m_isDamaged) {
    QFile::remove(m_file + ".damaged");
    QFile::rename(m_file, m_file + ".damaged");
    m_isDamaged = false;
  }
  const Status written = write_whole_file(m_file.toStdString(), m_table.text());
  if (!written) m_window.messages().showError(words(written.error()));
}

bool Shortcuts::eventFilter(QObject* watched, QEvent* event) {
  const bool is_new = event->type() == QEvent::ActionAdded || event->type() == QEvent::ActionRemoved;
  if (is_new && !m_isDue) {
    m_isDue = true;
    QMetaObject::invokeMethod(this, &Shortcuts::collect, Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace abrazo::app
