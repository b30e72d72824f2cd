#include <QAbstractItemView>
#include <QAction>
#include <QCompleter>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QStandardItemModel>
#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/workbench/keys/command_meaning.hpp"
#include "app/workbench/keys/command_row.hpp"
#include "app/workbench/shell/actions.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::app {
namespace {

QAction* find_action(QMainWindow& window, const QString& text) {
  for (QAction* action : window.actions())
    if (action->text() == text && action->isEnabled()) return action;
  return nullptr;
}

constexpr const char* last_use = "last use";  ///< property of an action: number of the use, later is higher

void note_use(QAction& action) {
  static int uses = 0;
  action.setProperty(last_use, ++uses);
}

/// Before anything is typed: the commands used last, then those that have a key.
int likelihood(const QAction& action) {
  return 2 * action.property(last_use).toInt() + (action.shortcut().isEmpty() ? 1 : 2);
}

/// The enabled actions that answer what was typed, best first, with their present keys; all of them while
/// nothing is typed.
void fill(const QMainWindow& window, QStandardItemModel& model, const QString& typed) {
  std::vector<std::pair<int, const QAction*>> found;
  for (const QAction* action : window.actions()) {
    if (action->text().isEmpty() || action->isSeparator() || !action->isEnabled()) continue;
    const int match = typed.trimmed().isEmpty()
                          ? likelihood(*action)
                          : command_match(typed, action->objectName(), action->text(), menu_path(*action));
    if (match > 0) found.emplace_back(match, action);
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &std::pair<int, const QAction*>::first);
  model.clear();
  for (const auto& [match, action] : found) {
    auto* item = new QStandardItem(action->text());
    item->setData(action->shortcut().toString(QKeySequence::NativeText), CommandRow::key_role);
    model.appendRow(item);
  }
  if (!found.empty()) return;
  auto* nothing = new QStandardItem("No command has these words");
  nothing->setFlags(Qt::NoItemFlags);
  model.appendRow(nothing);
}

/// The list is rebuilt whenever the field gets the keyboard: actions come, go and change their words.
class FillOnFocus : public QObject {
 public:
  FillOnFocus(const QMainWindow& window, QLineEdit* field, QStandardItemModel* model)
      : QObject(field), m_window(window), m_field(field), m_model(model) {
    field->installEventFilter(this);
    connect(field, &QLineEdit::textEdited, this,
            [this](const QString& typed) { fill(m_window, *m_model, typed); });
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    // Not when it comes back from its own list.
    const bool is_new = event->type() == QEvent::FocusIn &&
                        static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason;
    if (is_new) fill(m_window, *m_model, m_field->text());
    return QObject::eventFilter(watched, event);
  }

 private:
  const QMainWindow& m_window;
  QLineEdit* m_field;
  QStandardItemModel* m_model;
};

/// Escape leaves the search immediately, with or without its list open.
class LeaveOnEscape : public QObject {
 public:
  LeaveOnEscape(QLineEdit* field, QWidget* list) : QObject(field), m_field(field), m_list(list) {
    field->installEventFilter(this);
    list->installEventFilter(this);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    // Wider than the field, and on the screen: the field is at the right of the window.
    if (event->type() == QEvent::Show && watched == m_list)
      m_list->move(m_field->mapToGlobal(m_field->rect().bottomRight()).x() + 1 - m_list->width(),
                   m_list->y());
    const bool is_key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!is_key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
      return QObject::eventFilter(watched, event);
    event->accept();  // else Escape is the shortcut of another view
    if (event->type() == QEvent::ShortcutOverride) return true;
    m_list->hide();
    m_field->clear();
    m_field->clearFocus();
    return true;
  }

 private:
  QLineEdit* m_field;
  QWidget* m_list;
};

}  // namespace

void add_command_search(QMainWindow& window) {
  auto* name = new QLabel("  Abrazo  ", &window);
  name->setFont(widgets::interface_font(13, QFont::Bold));
  window.menuBar()->setCornerWidget(name, Qt::TopLeftCorner);

  auto* field = new QLineEdit(&window);
  field->setPlaceholderText("Search commands  Ctrl+P");
  field->setFixedWidth(252);
  field->setFocusPolicy(Qt::ClickFocus);
  field->setAccessibleName("Search commands");
  auto* model = new QStandardItemModel(field);
  auto* completer = new QCompleter(model, field);
  completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);  // the model has what answers
  completer->setMaxVisibleItems(12);
  completer->popup()->setMinimumWidth(420);  // wider than the field: a command has its key beside it
  QObject::connect(window.menuBar(), &QMenuBar::triggered, field, [](QAction* action) { note_use(*action); });
  completer->popup()->setItemDelegate(new CommandRow(completer->popup()));
  field->setCompleter(completer);
  new FillOnFocus(window, field, model);
  new LeaveOnEscape(field, completer->popup());
  title_row(window).addWidget(field);

  // Return reaches both the list and the field: what it switched on would be off again.
  const auto runs = std::make_shared<bool>(false);
  const auto run = [&window, field, model, runs](QString text) {
    if (!find_action(window, text) && model->rowCount() > 0) text = model->item(0)->text();
    QAction* action = find_action(window, text);
    if (!action || std::exchange(*runs, true)) return;
    // After the completer has put the text in.
    QMetaObject::invokeMethod(
        field,
        [field, action, runs] {
          *runs = false;
          field->clear();
          field->clearFocus();
          note_use(*action);
          action->trigger();
        },
        Qt::QueuedConnection);
  };
  QObject::connect(completer, qOverload<const QString&>(&QCompleter::activated), field, run);
  QObject::connect(field, &QLineEdit::returnPressed, field, [field, run] {
    if (!field->text().isEmpty()) run(field->text());
  });
  add_action(window, menu_of(window, "Help"), "Search commands", {QKeySequence("Ctrl+P"), QKeySequence("F3")},
             [field] {
               field->setFocus();
               field->selectAll();
             });
}

}  // namespace abrazo::app
