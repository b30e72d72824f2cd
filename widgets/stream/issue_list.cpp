#include "widgets/stream/issue_list.hpp"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <set>

#include "widgets/common/icons.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/stream/stream_sign.hpp"
#include "widgets/stream/stream_words.hpp"

namespace abrazo::widgets {
namespace {

constexpr int usual_height = 148;

/// As high as the text is when it is wrapped in the room that it has.
class WrappingDelegate : public QStyledItemDelegate {
 public:
  explicit WrappingDelegate(QTreeWidget* tree) : QStyledItemDelegate(tree), m_tree(*tree) {}
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int beside = 34, above = 4;  // sign and margins
    const int depth = index.parent().isValid() ? 2 : 1;
    const int room = m_tree.viewport()->width() - depth * m_tree.indentation() - beside;
    const QRect taken = option.fontMetrics.boundingRect(0, 0, std::max(room, 40), 4000, Qt::TextWordWrap,
                                                        index.data().toString());
    return {room, taken.height() + above};
  }

 private:
  QTreeWidget& m_tree;
};

}  // namespace

IssueList::IssueList(QWidget* parent)
    : QTreeWidget(parent),
      m_palette(palette_of(Theme::Dark)),
      m_calm(new QTreeWidgetItem({"Nothing is wrong"})) {
  setAccessibleName("What is wrong with the stream");
  setHeaderHidden(true);
  setWordWrap(true);
  setIndentation(16);
  setFixedHeight(usual_height);
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // its coming and going would wrap the lines again
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setFont(interface_font(12));
  setItemDelegate(new WrappingDelegate(this));
  addTopLevelItem(m_calm);
  m_calm->setFlags(Qt::ItemIsEnabled);
  show(nullptr);
}

void IssueList::setColours(const Palette& palette) {
  m_palette = palette;
  m_calm->setForeground(0, palette.secondary);
  for (const auto& [key, item] : m_items)
    for (int child = 0; child < item->childCount(); ++child)
      item->child(child)->setForeground(0, palette.secondary);
}

QIcon IssueList::signOf(StreamDiagnosis::Severity severity) const {
  return painted_icon({16, 16}, [&](QPainter& painter) {
    draw_sign(painter, {8, 8}, mark_of(severity), m_palette);
  });
}

QTreeWidgetItem& IssueList::itemOf(const QString& key) {
  QTreeWidgetItem*& item = m_items[key];
  if (!item) item = new QTreeWidgetItem(this);
  return *item;
}

void IssueList::showDiagnosis(const StreamDiagnosis& diagnosis) {
  QTreeWidgetItem& item = itemOf("diagnosis " + widgets::text(diagnosis.kind));
  const QString severity = diagnosis.severity == StreamDiagnosis::Severity::Error     ? "error"
                           : diagnosis.severity == StreamDiagnosis::Severity::Warning ? "warning"
                                                                                      : "note";
  item.setText(0, widgets::text(diagnosis.text));
  item.setIcon(0, signOf(diagnosis.severity));
  item.setData(0, Qt::AccessibleTextRole, severity + ": " + widgets::text(diagnosis.text));
  item.setToolTip(0, plain_tip(severity + ", " + widgets::text(diagnosis.kind)));
}

void IssueList::showIssue(const IssueCount& issue) {
  QTreeWidgetItem& item = itemOf("issue " + widgets::text(issue.kind));
  item.setText(0, widgets::text(count_text(issue.count)) + " × " + widgets::text(issue.kind));
  item.setToolTip(0, plain_tip(widgets::text(issue.latest)));
  if (item.childCount() == 0) {
    auto* latest = new QTreeWidgetItem(&item);
    latest->setForeground(0, m_palette.secondary);
  }
  item.child(0)->setText(0, widgets::text(issue.latest));
}

void IssueList::show(const StreamHealth* health) {
  std::set<QString> there;
  if (health) {
    for (const StreamDiagnosis& diagnosis : health->diagnoses) {
      showDiagnosis(diagnosis);
      there.insert("diagnosis " + widgets::text(diagnosis.kind));
    }
    for (const IssueCount& issue : health->issues) {
      showIssue(issue);
      there.insert("issue " + widgets::text(issue.kind));
    }
  }
  for (auto item = m_items.begin(); item != m_items.end();) {
    if (there.contains(item->first)) {
      ++item;
      continue;
    }
    delete item->second;
    item = m_items.erase(item);
  }
  m_calm->setText(0, health ? "Nothing is wrong" : "Nothing is connected");
  m_calm->setHidden(!m_items.empty());
}

QString IssueList::text() const {
  QStringList lines;
  const bool some = !selectedItems().isEmpty();
  for (int row = 0; row < topLevelItemCount(); ++row) {
    const QTreeWidgetItem* item = topLevelItem(row);
    const QTreeWidgetItem* latest = item->child(0);
    if (item->isHidden() || (some && !item->isSelected() && !(latest && latest->isSelected()))) continue;
    const QString spoken = item->data(0, Qt::AccessibleTextRole).toString();
    lines << (spoken.isEmpty() ? item->text(0) : spoken) + (latest ? ": " + latest->text(0) : QString());
  }
  return lines.join("\n");
}

void IssueList::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  scheduleDelayedItemsLayout();  // the lines break elsewhere
}

void IssueList::copy() const {
  QGuiApplication::clipboard()->setText(text());
}

void IssueList::keyPressEvent(QKeyEvent* event) {
  event->matches(QKeySequence::Copy) ? copy() : QTreeWidget::keyPressEvent(event);
}

bool IssueList::event(QEvent* event) {
  // With the focus on the list the arrows are its own, not the transport's.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool moves = key->key() >= Qt::Key_Home && key->key() <= Qt::Key_PageDown;
    if (key->matches(QKeySequence::Copy) || (moves && !(key->modifiers() & Qt::ControlModifier)))
      event->accept();
  }
  return QTreeWidget::event(event);
}

void IssueList::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(selectedItems().isEmpty() ? "Copy all" : "Copy", this, [this] { copy(); });
  menu.exec(event->globalPos());
}

}  // namespace abrazo::widgets
