#include "widgets/intended/intended_move_popup.hpp"

#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

#include "widgets/common/parts.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int row_height = 28, width_px = 360, most_rows = 12;
constexpr int choice_role = Qt::UserRole;

/// Key, colour of the move, name, and how far away: as a number and as a bar.
class ChoiceLook : public QStyledItemDelegate {
 public:
  ChoiceLook(const std::vector<IntendedMoveChoice>& shown, QObject* parent)
      : QStyledItemDelegate(parent), choices(shown), palette(palette_of(Theme::Dark)) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, row_height}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& at) const override {
    const auto row = static_cast<std::size_t>(at.row());
    if (row >= choices.size()) return;
    const IntendedMoveChoice& choice = choices[row];
    painter->setRenderHint(QPainter::Antialiasing);
    if (option.state & QStyle::State_Selected) painter->fillRect(option.rect, palette.accent);
    const bool chosen = option.state & QStyle::State_Selected;
    const QColor ink = chosen ? QColor(Qt::white) : palette.text;
    const QColor quiet = chosen ? QColor(Qt::white) : palette.secondary;
    const QRectF area = QRectF(option.rect).adjusted(10, 0, -12, 0);
    painter->setFont(interface_font(12, QFont::DemiBold));
    painter->setPen(quiet);
    if (row < 9)
      painter->drawText(QRectF(area.left(), area.top(), 14, row_height), Qt::AlignVCenter,
                        QString::number(row + 1));
    painter->setPen(Qt::NoPen);
    painter->setBrush(choice.is_take() ? palette.secondary : label_colour(palette, choice.label));
    const QPointF dot(area.left() + 24, area.center().y());
    choice.is_take() ? painter->drawRect(QRectF(dot - QPointF(3.5, 3.5), QSizeF(7, 7)))
                     : painter->drawEllipse(dot, 3.8, 3.8);
    painter->setFont(interface_font(13));
    painter->setPen(ink);
    constexpr double figures = 130;
    const QRectF name(area.left() + 36, area.top(), area.width() - 36 - figures, row_height);
    painter->drawText(name, Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(text(choice_title(choice)), Qt::ElideRight,
                                                        static_cast<int>(name.width())));
    if (choice.distance_m < 0) return;
    constexpr double full_m = 1, bar_px = 60;
    const double share = std::clamp(choice.distance_m / full_m, 0.0, 1.0);
    painter->fillRect(QRectF(area.right() - figures + 4, area.center().y() - 3, bar_px * share, 6),
                      chosen ? QColor(Qt::white) : palette.user);
    painter->setPen(ink);
    draw_tabular(*painter, area, Qt::AlignRight, text(distance_text(choice.distance_m)));
  }

  const std::vector<IntendedMoveChoice>& choices;
  Palette palette;
};

int digit_of(const QKeyEvent& event) {
  if (event.modifiers() & ~Qt::KeypadModifier) return 0;
  return event.key() >= Qt::Key_1 && event.key() <= Qt::Key_9 ? event.key() - Qt::Key_0 : 0;
}

}  // namespace

IntendedMovePopup::IntendedMovePopup(QWidget* window) : QFrame(window), m_palette(palette_of(Theme::Dark)) {
  setObjectName("popup");
  setAccessibleName("Intended move");
  auto* column = column_in(this, {1, 8, 1, 8}, 6);
  auto* head = nested_row({12, 0, 12, 0});
  auto* title = new QLabel("Intended move", this);
  title->setFont(interface_font(13, QFont::DemiBold));
  m_span = new QComboBox(this);
  m_span->addItems({"until I cancel it", "until it is done", "for 5 s", "for 10 s"});
  m_span->setAccessibleName("How long it applies");
  head->addWidget(title);
  head->addStretch(1);
  head->addWidget(m_span);
  m_list = new QListWidget(this);
  m_list->setItemDelegate(new ChoiceLook(m_choices, m_list));
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setObjectName("bare");
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setAccessibleName("Moves and takes, the nearest first");
  m_list->installEventFilter(this);
  m_hint = quiet_label("1–9 chooses, Esc closes; metres to the nearest recorded pair", this, 11);
  m_hint->setContentsMargins(12, 0, 12, 0);
  column->addLayout(head);
  column->addWidget(m_list);
  column->addWidget(m_hint);
  connect(m_list, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { choose(m_list->row(item)); });
  hide();
}

void IntendedMovePopup::setColours(const Palette& palette) {
  m_palette = palette;
  static_cast<ChoiceLook*>(m_list->itemDelegate())->palette = palette;
  m_list->viewport()->update();
}

void IntendedMovePopup::openOver(const QWidget& widget) {
  if (!isVisible()) m_before = window()->focusWidget();
  m_over = &widget;
  show();
  arrange();
  raise();
  m_list->setFocus(Qt::PopupFocusReason);
}

void IntendedMovePopup::leave() {
  if (!isVisible()) return;
  hide();
  if (m_before && m_before->isVisible()) m_before->setFocus(Qt::PopupFocusReason);
}

void IntendedMovePopup::arrange() {
  if (!m_over) return;
  const int rows = std::clamp(m_list->count(), 1, most_rows);
  m_list->setFixedHeight(rows * row_height + 2);
  const QPoint corner = m_over->mapTo(parentWidget(), QPoint(0, 0));
  const int wide = std::min(width_px, std::max(200, m_over->width() - 24));
  const int high = sizeHint().height();
  const int y = std::max(0, std::min(corner.y() + 56, parentWidget()->height() - high));
  setGeometry(corner.x() + (m_over->width() - wide) / 2, y, wide, high);
}

void IntendedMovePopup::setChoices(std::vector<IntendedMoveChoice> choices) {
  const int marked = m_list->currentRow();
  const std::string before = marked >= 0 && marked < static_cast<int>(m_choices.size())
                                 ? choice_title(m_choices[static_cast<std::size_t>(marked)])
                                 : std::string();
  const bool resized = choices.size() != m_choices.size();
  m_choices = std::move(choices);
  while (m_list->count() > static_cast<int>(m_choices.size())) delete m_list->takeItem(m_list->count() - 1);
  while (m_list->count() < static_cast<int>(m_choices.size())) m_list->addItem(new QListWidgetItem);
  int row = 0, keep = 0;
  for (const IntendedMoveChoice& choice : m_choices) {
    const std::string title = choice_title(choice);
    if (title == before) keep = row;
    const QString words =
        text(title) + (choice.distance_m < 0 ? "" : ", " + text(distance_text(choice.distance_m)));
    m_list->item(row)->setData(Qt::AccessibleTextRole, words);
    m_list->item(row)->setToolTip(QString("%1 recorded pairs").arg(choice.pairs));
    ++row;
  }
  if (m_list->count() > 0) m_list->setCurrentRow(keep);
  m_list->viewport()->update();
  if (resized && isVisible()) arrange();
}

IntendedMoveSpan IntendedMovePopup::span() const {
  return static_cast<IntendedMoveSpan>(m_span->currentIndex());
}

void IntendedMovePopup::setSpan(IntendedMoveSpan span) {
  m_span->setCurrentIndex(static_cast<int>(span));
}

void IntendedMovePopup::choose(int row) {
  if (row < 0 || row >= static_cast<int>(m_choices.size())) return;
  const IntendedMoveChoice choice = m_choices[static_cast<std::size_t>(row)];
  leave();
  emit chosen(choice, span());
}

bool IntendedMovePopup::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return QFrame::eventFilter(watched, event);
  const auto& key = *static_cast<QKeyEvent*>(event);
  const int digit = digit_of(key);
  const bool takes = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
  const bool leaves = key.key() == Qt::Key_Escape;
  const bool moves = key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
  if (digit == 0 && !takes && !leaves && !moves) return QFrame::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  if (moves) return QFrame::eventFilter(watched, event);
  if (leaves) leave();
  if (takes) choose(m_list->currentRow());
  if (const auto row = choice_of_digit(digit, m_choices.size())) choose(static_cast<int>(*row));
  return true;
}

}  // namespace abrazo::widgets
