#include "widgets/scene/panel/scene_tree.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/scrolled.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/scene/panel/character_rows.hpp"

namespace abrazo::widgets {
namespace {

constexpr int first_x = 12, indent = 14, arrow_room = 26, least_rows = 3;

}  // namespace

SceneTree::SceneTree(QWidget* parent)
    : QWidget(parent),
      m_filter(new QLineEdit(this)),
      m_scroll(new QScrollArea(this)),
      m_list(new SceneTreeList(this)),
      m_characters(new CharacterRows(this)) {
  auto* column = column_in(this, {0, 0, 0, 4}, 2);
  m_filter->setPlaceholderText("Find a part or joint");
  m_filter->setAccessibleName("Find a part or joint");
  m_filter->setClearButtonEnabled(true);
  m_filter->setFont(interface_font(12));
  auto* field = nested_row({10, 0, 10, 2});
  field->addWidget(m_filter);
  scroll_vertically(*m_scroll, m_list);
  m_scroll->setFocusPolicy(Qt::NoFocus);
  m_scroll->setMinimumHeight(least_rows * SceneTreeList::row_height);
  column->addLayout(field);
  column->addWidget(m_scroll, 1);
  column->addWidget(m_characters);
  setFocusProxy(m_list);
  leave_by_escape(*m_filter, *m_list);
  connect(m_filter, &QLineEdit::textChanged, m_list, &SceneTreeList::setFilter);
  connect(m_list, &SceneTreeList::visibilityRequested, this, &SceneTree::visibilityRequested);
  connect(m_list, &SceneTreeList::selectionRequested, this, &SceneTree::selectionRequested);
  connect(m_list, &SceneTreeList::currentChanged, this, [this](int row) {
    constexpr int height = SceneTreeList::row_height;
    if (row >= 0) m_scroll->ensureVisible(0, row * height + height / 2, 0, height / 2 + 1);
  });
}

QSize SceneTree::sizeHint() const {
  return {260, SceneTreeList::row_height * static_cast<int>(part_rows().size()) + 38 +
                   m_characters->sizeHint().height()};
}
void SceneTree::setColours(const Palette& palette) {
  m_list->setColours(palette);
}
void SceneTree::setInputName(const QString& name) {
  m_list->setInput(name);
}
void SceneTree::setVisibility(const PartVisibility& visibility) {
  m_list->setVisibility(visibility);
}
void SceneTree::setCounts(const PartCounts& counts) {
  m_list->setCounts(counts);
}
void SceneTree::showSelection(const Selection& selection) {
  m_list->setSelection(selection);
}

SceneTreeList::SceneTreeList(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName("Parts of the scene");
  rebuild();
}

void SceneTreeList::rebuild() {
  m_rows = tree_rows(m_open, m_filter.toStdString());
  setFixedHeight(row_height * std::max(1, static_cast<int>(m_rows.size())));
  m_hovered = -1;
  setCurrent(std::min(m_current, static_cast<int>(m_rows.size()) - 1));
  update();
}

void SceneTreeList::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void SceneTreeList::setFilter(const QString& filter) {
  m_filter = filter.trimmed();
  rebuild();
}

void SceneTreeList::setOpen(int character, bool open) {
  m_open[static_cast<std::size_t>(character)] = open;
  rebuild();
}

void SceneTreeList::setInput(const QString& name) {
  if (name == m_input) return;
  m_input = name;
  update();
}

void SceneTreeList::setVisibility(const PartVisibility& visibility) {
  m_visibility = visibility;
  describe();
  update();
}

/// Counts change with most frames, each in one row or two.
void SceneTreeList::setCounts(const PartCounts& counts) {
  QStringList before;
  for (const TreeRow& row : m_rows) before << note(row);
  m_counts = counts;
  for (int r = 0; r < before.size(); ++r)
    if (note(m_rows[static_cast<std::size_t>(r)]) != before[r])
      update(0, r * row_height, width(), row_height);
}

/// The joint that was selected last is in view when its character is open; nothing opens by itself.
void SceneTreeList::setSelection(const Selection& selection) {
  m_selection = selection;
  const auto found = std::ranges::find_if(
      m_rows, [&](const TreeRow& row) { return row.vertex >= 0 && row.vertex == m_selection.last_joint(); });
  if (found != m_rows.end()) setCurrent(static_cast<int>(found - m_rows.begin()));
  update();
}

QString SceneTreeList::note(const TreeRow& row) const {
  const auto count = [this](ScenePart part) { return m_counts[static_cast<std::size_t>(part)]; };
  if (row.vertex >= 0) return {};
  if (row.name == "User") return m_input;
  if (row.name == "Leader") return "leads";
  if (row.name == "Follower") return "follows";
  if (row.name == "Selected pair") return "ghost";
  if (row.name == "Interaction mesh")
    return QString("%1 edges").arg(count(ScenePart::MeshBetween) + count(ScenePart::MeshWithin));
  if (row.name == "Comparison") return "A and B";
  if (row.name == "Look-ahead")
    return is_on(row, m_visibility) ? QString("%1 s").arg(count(ScenePart::LookAhead) / 1000.0, 0, 'f', 1)
                                    : QString();
  if (row.parts.size() != 1 || row.parts[0] == ScenePart::Floor) return {};
  return QString::number(count(row.parts[0]));
}

void SceneTreeList::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(interface_font(13));
  if (m_rows.empty()) {
    painter.setPen(m_palette.secondary);
    painter.drawText(rect().adjusted(first_x, 0, 0, 0), Qt::AlignVCenter, "Nothing has that name");
  }
  const int first = event->rect().top() / row_height;
  const int last = std::min(static_cast<int>(m_rows.size()) - 1, event->rect().bottom() / row_height);
  for (int r = first; r <= last; ++r)
    if (event->region().intersects(QRect(0, r * row_height, width(), row_height))) paintRow(painter, r);
}

void SceneTreeList::paintRow(QPainter& painter, int index) const {
  const TreeRow& row = m_rows[static_cast<std::size_t>(index)];
  const QRectF line(0, index * row_height, width(), row_height);
  const bool is_joint = row.vertex >= 0;
  const bool is_selected =
      is_joint && m_selection.kind == SelectionKind::Joints && m_selection.has(row.vertex);
  if (is_selected)
    painter.fillRect(line, mixed(m_palette.accent, m_palette.panel, 0.45));
  else if (index == m_hovered)
    painter.fillRect(line, mixed(m_palette.raised, m_palette.panel, 0.6));
  if (index == m_current && hasFocus()) {
    painter.setPen(QPen(m_palette.accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(line.adjusted(0.5, 0.5, -0.5, -0.5));
  }
  const double x = first_x + indent * row.depth, y = line.center().y();
  const bool on = is_joint || is_on(row, m_visibility);
  painter.setPen(QPen(m_palette.secondary, 1.2));
  painter.setBrush(on && !is_joint ? QBrush(m_palette.secondary) : QBrush(Qt::NoBrush));
  if (!is_joint) painter.drawEllipse(QPointF(x, y), 3.2, 3.2);
  QColor ink = on ? m_palette.text : m_palette.secondary;
  if (on && row.character == 0) ink = m_palette.dark ? m_palette.active.lighter(118) : m_palette.active;
  if (on && row.character == 1) ink = m_palette.passive;
  painter.setPen(ink);
  painter.drawText(line.adjusted(x + 13, 0, -60, 0), Qt::AlignVCenter | Qt::AlignLeft, text(row.name));
  painter.setPen(m_palette.secondary);
  const double right = row.character >= 0 && m_filter.isEmpty() ? arrow_room : first_x;
  draw_tabular(painter, line.adjusted(0, 0, -right, 0), Qt::AlignRight, note(row));
  if (row.character < 0 || !m_filter.isEmpty()) return;
  painter.setPen(QPen(m_palette.secondary, 1.4));
  const QPointF tip(width() - 15, y);
  const bool open = m_open[static_cast<std::size_t>(row.character)];
  painter.drawPolyline(open ? QPolygonF({tip + QPointF(-4, -2), tip + QPointF(0, 2), tip + QPointF(4, -2)})
                            : QPolygonF({tip + QPointF(-2, -4), tip + QPointF(2, 0), tip + QPointF(-2, 4)}));
}

int SceneTreeList::rowAt(int y) const {
  const int row = y / row_height;
  return y >= 0 && row < static_cast<int>(m_rows.size()) ? row : -1;
}

/// A part is shown or hidden, a joint selected.
void SceneTreeList::act(int index, SelectionChange how) {
  if (index < 0 || index >= static_cast<int>(m_rows.size())) return;
  const TreeRow& row = m_rows[static_cast<std::size_t>(index)];
  if (row.vertex < 0) return emit visibilityRequested(toggled(row, m_visibility));
  emit selectionRequested(changed(m_selection, Selection::joint(row.vertex), how));
}

void SceneTreeList::setCurrent(int row) {
  m_current = row;
  describe();
  update();
  emit currentChanged(row);
}

/// Screen reader text of the current row.
void SceneTreeList::describe() {
  if (m_current < 0 || m_current >= static_cast<int>(m_rows.size())) return setAccessibleDescription({});
  const TreeRow& row = m_rows[static_cast<std::size_t>(m_current)];
  if (row.vertex >= 0) return setAccessibleDescription("Joint " + text(vertex_name(row.vertex)));
  setAccessibleDescription(text(row.name) + (is_on(row, m_visibility) ? ", shown" : ", hidden"));
}

void SceneTreeList::mousePressEvent(QMouseEvent* event) {
  const int row = rowAt(event->y());
  if (row < 0 || event->button() != Qt::LeftButton) return;
  setCurrent(row);
  const int character = m_rows[static_cast<std::size_t>(row)].character;
  if (character >= 0 && m_filter.isEmpty() && event->x() > width() - arrow_room)
    return setOpen(character, !m_open[static_cast<std::size_t>(character)]);
  act(row, selection_change(event->modifiers()));
}

void SceneTreeList::mouseMoveEvent(QMouseEvent* event) {
  m_hovered = rowAt(event->y());
  update();
}

void SceneTreeList::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(m_rows.size()) - 1;
  const int character =
      m_current >= 0 && m_current <= last ? m_rows[static_cast<std::size_t>(m_current)].character : -1;
  switch (event->key()) {
    case Qt::Key_Up:
      return setCurrent(std::max(0, m_current - 1));
    case Qt::Key_Down:
      return setCurrent(std::min(last, m_current + 1));
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return act(m_current, selection_change(event->modifiers()));
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      if (character >= 0) setOpen(character, event->key() == Qt::Key_Plus);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void SceneTreeList::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  const bool by_key = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  if (by_key && m_current < 0) setCurrent(0);
  update();
}

void SceneTreeList::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

bool SceneTreeList::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int row = rowAt(help->y());
  const QString tip = row < 0 ? QString() : text(m_rows[static_cast<std::size_t>(row)].tip);
  tip.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), plain_tip(tip), this);
  return true;
}

void SceneTreeList::leaveEvent(QEvent*) {
  m_hovered = -1;
  update();
}

}  // namespace abrazo::widgets
