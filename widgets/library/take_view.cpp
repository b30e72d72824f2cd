#include "widgets/library/take_view.hpp"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "widgets/library/take_delegate.hpp"
#include "widgets/library/take_model.hpp"

namespace abrazo::widgets {
namespace {

constexpr int strip_reach = 7;  ///< pixels above and below the strip that still mean it

/// Keys that move along a take or through the list while it has the focus, and something else elsewhere.
bool is_of_the_list(const QKeyEvent& event) {
  if (event.modifiers() & Qt::AltModifier) return false;
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
      return true;
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Escape:
      return !(event.modifiers() & (Qt::ControlModifier | Qt::ShiftModifier));
    default:
      return false;
  }
}

}  // namespace

TakeView::TakeView(TakeModel& model, TakeFilter& filter, QWidget* parent)
    : QListView(parent), m_model(model), m_filter(filter) {
  setModel(&filter);
  setMouseTracking(true);
  setUniformItemSizes(true);
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setAutoFillBackground(false);
  setObjectName("bare");
  setAccessibleName("Takes of the library");
  setAccessibleDescription(
      "Left and Right browse a take, Return dances with it, the menu key opens all commands");
}

int TakeView::currentTake() const {
  return m_filter.takeAt(currentIndex());
}

void TakeView::setCurrentTake(int take) {
  const QModelIndex index = m_filter.indexOf(take);
  if (!index.isValid()) return clearSelection();
  setCurrentIndex(index);
  scrollTo(index);
}

bool TakeView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && is_of_the_list(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QListView::event(event);
}

void TakeView::step(int frames) {
  const int take = currentTake();
  if (take < 0) return;
  const int length = m_model.row(take).frames;
  const int from = m_model.cursorTake() == take ? m_model.cursorFrame() : frames > 0 ? -1 : length;
  emit lookedAt(take, std::clamp(from + frames, 0, std::max(0, length - 1)));
}

/// To the nearest beginning of a move before or after the cursor.
void TakeView::stepToMove(int direction) {
  const int take = currentTake();
  if (take < 0) return;
  const TakeRow& row = m_model.row(take);
  const int cursor = m_model.cursorTake() == take ? m_model.cursorFrame() : -1;
  int target = direction > 0 ? row.frames - 1 : 0;
  for (const TakeRow::Move& move : row.moves) {
    const int start = static_cast<int>(std::lround(move.from * row.frames));
    if (direction > 0 && start > cursor) target = std::min(target, start);
    if (direction < 0 && start < cursor) target = std::max(target, start);
  }
  emit lookedAt(take, target);
}

void TakeView::keyPressEvent(QKeyEvent* event) {
  const int many = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
  const bool by_move = event->modifiers() & Qt::ControlModifier;
  switch (event->key()) {
    case Qt::Key_Left:
      return by_move ? stepToMove(-1) : step(-many);
    case Qt::Key_Right:
      return by_move ? stepToMove(1) : step(many);
    case Qt::Key_Escape:
      return emit lookedAway();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (currentTake() >= 0) emit activatedTake(currentTake());
      return;
    default:
      QListView::keyPressEvent(event);
  }
}

bool TakeView::lookAlong(const QModelIndex& index, const QPoint& at, bool anywhere_in_height) {
  const int take = m_filter.takeAt(index);
  if (take < 0) return false;
  const QRect row = visualRect(index);
  const QRect reach = take_strip(row).adjusted(-2, -strip_reach, 2, strip_reach);
  if (!anywhere_in_height && !reach.contains(at)) return false;
  emit lookedAt(take, frame_at(row, at.x(), m_model.row(take).frames));
  return true;
}

void TakeView::mousePressEvent(QMouseEvent* event) {
  QListView::mousePressEvent(event);
  const QModelIndex index = indexAt(event->pos());
  m_dragged =
      event->button() == Qt::LeftButton && lookAlong(index, event->pos(), false) ? index : QModelIndex();
}

void TakeView::mouseMoveEvent(QMouseEvent* event) {
  if (m_dragged.isValid()) {
    lookAlong(m_dragged, event->pos(), true);
    return;  // without the list's own rubber band
  }
  QListView::mouseMoveEvent(event);
  if (!lookAlong(indexAt(event->pos()), event->pos(), false)) emit lookedAway();
}

void TakeView::mouseReleaseEvent(QMouseEvent* event) {
  m_dragged = QModelIndex();
  QListView::mouseReleaseEvent(event);
}

void TakeView::mouseDoubleClickEvent(QMouseEvent* event) {
  const int take = m_filter.takeAt(indexAt(event->pos()));
  if (take >= 0 && event->button() == Qt::LeftButton) emit activatedTake(take);
}

void TakeView::leaveEvent(QEvent* event) {
  QListView::leaveEvent(event);
  if (!m_dragged.isValid()) emit lookedAway();
}

void TakeView::contextMenuEvent(QContextMenuEvent* event) {
  const bool by_key = event->reason() == QContextMenuEvent::Keyboard;
  const QModelIndex index = by_key ? currentIndex() : indexAt(event->pos());
  const int take = m_filter.takeAt(index);
  if (take < 0) return;
  setCurrentIndex(index);
  emit menuRequested(take, by_key ? viewport()->mapToGlobal(visualRect(index).center()) : event->globalPos());
}

void TakeView::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QListView::currentChanged(current, previous);
  emit currentTakeChanged(m_filter.takeAt(current));
}

}  // namespace abrazo::widgets
