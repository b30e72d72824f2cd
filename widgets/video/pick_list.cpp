#include "widgets/video/pick_list.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "core/session/frames/time_place.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/video/video_words.hpp"

namespace abrazo::widgets {
namespace {

constexpr int row_height = 22, margin = 12, remove_width = 22, error_width = 84;

bool is_of_list(int key) {
  return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Delete || key == Qt::Key_Backspace ||
         key == Qt::Key_Return || key == Qt::Key_Enter;
}

QString error_text(const PickMark& pick) {
  return pick.error_px ? QString("%1 px").arg(*pick.error_px, 0, 'f', 2) : QString("–");
}

}  // namespace

PickList::PickList(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName("Picked joints");
  setToolTip("A click goes to the picture and selects the point; ✕ or Del removes it");
}

void PickList::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void PickList::show(std::vector<PickMark> picks) {
  const bool same_size = picks.size() == m_picks.size();
  m_picks = std::move(picks);
  m_selected = std::min(m_selected, static_cast<int>(m_picks.size()) - 1);
  if (!same_size) updateGeometry();
  setVisible(!m_picks.empty());
  update();
}

void PickList::select(int index) {
  m_selected = index;
  setAccessibleDescription(index < 0 ? QString() : lineOf(index));
  update();
}

QSize PickList::sizeHint() const {
  return {200, row_height * static_cast<int>(m_picks.size())};
}

QString PickList::lineOf(int index) const {
  const PickMark& pick = m_picks[static_cast<std::size_t>(index)];
  return QString::fromStdString(pick.name + " at " + clock_text(pick.subject_s) + ", ") + error_text(pick) +
         (pick.is_outlier ? ", left out" : "");
}

int PickList::rowAt(int y) const {
  const int row = y / row_height;
  return y >= 0 && row < static_cast<int>(m_picks.size()) ? row : -1;
}

QRect PickList::removeAt(int row) const {
  return {width() - margin - remove_width + 6, row * row_height, remove_width, row_height};
}

void PickList::mousePressEvent(QMouseEvent* event) {
  const int row = rowAt(event->pos().y());
  if (row < 0) return;
  removeAt(row).contains(event->pos()) ? emit removeRequested(row) : emit chosen(row);
}

void PickList::mouseMoveEvent(QMouseEvent* event) {
  const int row = rowAt(event->pos().y());
  if (std::exchange(m_hovered, row) != row) update();
}

void PickList::leaveEvent(QEvent*) {
  m_hovered = -1;
  update();
}

bool PickList::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->modifiers() == Qt::NoModifier && is_of_list(key->key())) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void PickList::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(m_picks.size()) - 1;
  if (last < 0 || !is_of_list(event->key())) return QWidget::keyPressEvent(event);
  if (event->key() == Qt::Key_Up) return emit chosen(std::max(0, m_selected - 1));
  if (event->key() == Qt::Key_Down) return emit chosen(std::min(last, m_selected + 1));
  if (m_selected < 0) return;
  const bool removes = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
  removes ? emit removeRequested(m_selected) : emit chosen(m_selected);
}

void PickList::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  for (int row = 0; row < static_cast<int>(m_picks.size()); ++row) {
    const PickMark& pick = m_picks[static_cast<std::size_t>(row)];
    const QRectF line(0, row * row_height, width(), row_height);
    if (row == m_selected || row == m_hovered)
      painter.fillRect(line,
                       row == m_selected ? mixed(m_palette.accent, m_palette.panel, 0.35) : m_palette.raised);
    painter.setFont(interface_font(12));
    painter.setPen(pick.is_here ? m_palette.text : m_palette.secondary);
    const QString name = QString::fromStdString(pick.name);
    const QRectF words = line.adjusted(margin, 0, -margin - remove_width - error_width, 0);
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, name);
    painter.setPen(m_palette.secondary);
    const double name_width = QFontMetricsF(painter.font()).horizontalAdvance(name) + 8;
    draw_tabular(painter, words.adjusted(name_width, 0, 0, 0), Qt::AlignLeft,
                 QString::fromStdString(clock_text(pick.subject_s)));
    const QRectF error(width() - margin - remove_width - error_width, line.top(), error_width, row_height);
    painter.setPen(pick.is_outlier ? m_palette.warning : m_palette.text);
    draw_tabular(painter, error, Qt::AlignRight, (pick.is_outlier ? "⚠ " : "") + error_text(pick));
    painter.setPen(m_palette.secondary);
    painter.drawText(removeAt(row), Qt::AlignCenter, "✕");
  }
  if (hasFocus()) {
    painter.setPen(m_palette.accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

}  // namespace abrazo::widgets
