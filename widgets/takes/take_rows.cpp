#include "widgets/takes/take_rows.hpp"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>

#include "widgets/common/plain_text.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/takes/recording_status.hpp"

namespace abrazo::widgets {
namespace {

constexpr int row_height = 44, side = 12, first_line = 20;
constexpr int id_role = Qt::UserRole, length_role = Qt::UserRole + 1, facts_role = Qt::UserRole + 2,
              running_role = Qt::UserRole + 3;

/// "at 01:23 · 4 180 frames · Ana, Ben"
QString facts_of(const RecordedTake& take) {
  QString words = "at " + text(duration_text(take.from_s));
  if (take.frames > 0) words += QString(" · %1 frame%2").arg(take.frames).arg(take.frames == 1 ? "" : "s");
  QStringList performers;
  for (const std::string& performer : take.performers) performers << text(performer);
  if (!performers.isEmpty()) words += " · " + performers.join(", ");
  return words;
}

class TakeRowLook : public QStyledItemDelegate {
 public:
  explicit TakeRowLook(QObject* parent) : QStyledItemDelegate(parent), palette(palette_of(Theme::Dark)) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {160, row_height}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& row) const override {
    const bool running = row.data(running_role).toBool(), chosen = option.state & QStyle::State_Selected;
    const QRect area = option.rect.adjusted(side, 4, -side, -4);
    if (chosen) painter->fillRect(option.rect, palette.raised);
    const bool by_key = option.state & QStyle::State_HasFocus;
    if (chosen)
      painter->fillRect(QRect(option.rect.topLeft(), QSize(2, row_height)),
                        by_key ? palette.accent : palette.border);
    const QRect top(area.left(), area.top(), area.width(), first_line);
    const QRect below(area.left(), area.top() + first_line, area.width(), area.height() - first_line);
    painter->setFont(interface_font(13, QFont::DemiBold));
    const QString length = row.data(length_role).toString();
    const int length_width = static_cast<int>(tabular_width(interface_font(12), length)) + 8;
    painter->setPen(palette.text);
    painter->drawText(top.adjusted(0, 0, -length_width, 0), Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(row.data(Qt::DisplayRole).toString(), Qt::ElideRight,
                                                        top.width() - length_width));
    painter->setFont(interface_font(12));
    painter->setPen(running ? palette.dark ? palette.live.lighter(140) : palette.live : palette.text);
    draw_tabular(*painter, top, Qt::AlignRight, length);
    painter->setPen(palette.secondary);
    painter->drawText(
        below, Qt::AlignVCenter,
        painter->fontMetrics().elidedText(row.data(facts_role).toString(), Qt::ElideRight, below.width()));
  }

  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex&) const override {
    editor->setGeometry(option.rect.adjusted(side - 9, 3, -side, 3 + first_line + 5 - row_height));
  }

  Palette palette;
};

/// Keys that mean a take while the list has the focus, and something else elsewhere.
bool is_of_the_list(const QKeyEvent& event) {
  if (event.modifiers() & ~Qt::KeypadModifier) return false;
  switch (event.key()) {
    case Qt::Key_Delete:
    case Qt::Key_F2:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Home:
    case Qt::Key_End:
      return true;
    default:
      return false;
  }
}

}  // namespace

TakeRows::TakeRows(QWidget* parent) : QListWidget(parent) {
  setItemDelegate(new TakeRowLook(this));
  setFrameShape(QFrame::NoFrame);
  setUniformItemSizes(true);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setObjectName("bare");
  setStyleSheet("QLineEdit { padding: 0 8px; }");  // the field of a row, which is lower than others
  setAccessibleName("Takes of this session");
  setAccessibleDescription("Return goes to a take, F2 renames it, Delete removes it from the list");
  connect(this, &QListWidget::itemDoubleClicked, this,
          [this](QListWidgetItem* item) { emit goToRequested(takeAt(row(item))); });
  connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    const RecordedTake* take = m_takes.find(takeAt(row(item)));
    const QString name = item->text();
    if (!take || name == text(take->name)) return;
    const std::int64_t id = take->id;
    blockSignals(true);
    item->setText(text(take->name));  // until the answer shows the new one
    blockSignals(false);
    emit renameRequested(id, name);
  });
}

std::int64_t TakeRows::takeAt(int row) const {
  const QListWidgetItem* item = this->item(row);
  return item ? item->data(id_role).toLongLong() : -1;
}

std::int64_t TakeRows::currentTake() const {
  return takeAt(currentRow());
}

void TakeRows::setCurrentTake(std::int64_t id) {
  for (int row = 0; row < count(); ++row)
    if (takeAt(row) == id) setCurrentRow(row);
}

void TakeRows::setTakes(const RecordedTakes& takes) {
  if (takes == m_takes && count() == static_cast<int>(takes.all().size())) return;
  const std::int64_t chosen = currentTake();
  m_takes = takes;
  const QSignalBlocker quiet(this);
  while (count() > static_cast<int>(takes.all().size())) delete takeItem(count() - 1);
  while (count() < static_cast<int>(takes.all().size())) addItem(new QListWidgetItem);
  int row = 0;
  for (const RecordedTake& take : takes.all()) {
    QListWidgetItem* shown = item(row++);
    shown->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable);
    shown->setText(text(take.name));
    shown->setData(id_role, static_cast<qlonglong>(take.id));
    shown->setData(running_role, take.id == m_running);
    shown->setData(length_role, (take.id == m_running ? "● " : "") + text(duration_text(take.length_s())));
    shown->setData(facts_role, facts_of(take));
    shown->setData(Qt::AccessibleTextRole, text(take.name) + ", " + shown->data(length_role).toString() +
                                               ", " + shown->data(facts_role).toString());
    shown->setToolTip(plain_tip(shown->data(facts_role).toString() + "\nDouble click goes there"));
  }
  setCurrentTake(chosen);
}

void TakeRows::setRunning(std::int64_t id) {
  if (id == m_running) return;
  m_running = id;
  const RecordedTakes again = m_takes;
  m_takes = {};
  setTakes(again);
}

void TakeRows::setColours(const Palette& palette) {
  static_cast<TakeRowLook*>(itemDelegate())->palette = palette;
  viewport()->update();
}

void TakeRows::rename() {
  if (currentItem()) editItem(currentItem());
}

bool TakeRows::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && is_of_the_list(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QListWidget::event(event);
}

void TakeRows::keyPressEvent(QKeyEvent* event) {
  const std::int64_t take = currentTake();
  // What the editor has done with its Return comes by here, too.
  if (take < 0 || state() == QAbstractItemView::EditingState) return QListWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_F2:
      return rename();
    case Qt::Key_Delete:
      return emit removeRequested(take);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return emit goToRequested(take);
    default:
      QListWidget::keyPressEvent(event);
  }
}

void TakeRows::contextMenuEvent(QContextMenuEvent* event) {
  const std::int64_t take = currentTake();
  if (take < 0) return;
  QMenu menu(this);
  menu.addAction("Go to it", this, [this, take] { emit goToRequested(take); });
  menu.addAction("Rename\tF2", this, &TakeRows::rename);
  menu.addAction("Remove from the list\tDel", this, [this, take] { emit removeRequested(take); });
  menu.exec(event->reason() == QContextMenuEvent::Keyboard
                ? mapToGlobal(visualItemRect(currentItem()).bottomLeft())
                : event->globalPos());
}

}  // namespace abrazo::widgets
