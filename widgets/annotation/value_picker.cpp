#include "widgets/annotation/value_picker.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/value_look.hpp"

namespace abrazo::widgets {
namespace {

constexpr int value_role = Qt::UserRole;
constexpr int row_px = 24, most_rows = 12, width_px = 280;

QPixmap swatch(const QColor& colour, double scale) {
  QPixmap picture(QSize(14, 14) * scale);
  picture.setDevicePixelRatio(scale);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(2, 1, 10, 12), 2, 2);
  return picture;
}

}  // namespace

ValuePicker* ValuePicker::open(QWidget& widget, const QPoint& below, const Question& question,
                               const Palette& palette, Take take) {
  QWidget& window = *widget.window();
  for (auto* other : window.findChildren<ValuePicker*>()) delete other;
  auto* picker = new ValuePicker(window, question, palette, std::move(take));
  picker->m_corner = widget.mapTo(&window, below);
  picker->settle();
  picker->show();
  picker->raise();
  picker->m_field->setFocus(Qt::PopupFocusReason);
  picker->m_field->selectAll();
  return picker;
}

ValuePicker::ValuePicker(QWidget& window, const Question& question, const Palette& palette, Take take)
    : QFrame(&window),
      m_question(question),
      m_palette(palette),
      m_take(std::move(take)),
      m_before(QApplication::focusWidget()) {
  setObjectName("valuePicker");
  setStyleSheet(
      "#valuePicker { background: palette(window); border: 1px solid palette(highlight); border-radius: 6px; "
      "}");
  setAttribute(Qt::WA_StyledBackground);
  setFixedWidth(width_px);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 8);
  column->setSpacing(6);
  auto* title = new QLabel(question.prompt, this);
  title->setObjectName("secondary");
  title->setFont(interface_font(12));
  m_field = new QLineEdit(question.start, this);
  m_field->setAccessibleName(question.prompt);
  m_list = new QListWidget(this);
  m_list->setAccessibleName("Values of " + QString::fromStdString(question.tier.name));
  m_list->setFocusPolicy(Qt::NoFocus);
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_complaint = new QLabel(this);
  m_complaint->setWordWrap(true);
  m_complaint->hide();
  m_hint = new QLabel("A key takes it, Return what is marked, Esc leaves it", this);
  m_hint->setObjectName("secondary");
  m_hint->setFont(interface_font(11));
  for (QWidget* part : std::initializer_list<QWidget*>{title, m_field, m_list, m_complaint, m_hint})
    column->addWidget(part);
  m_field->installEventFilter(this);
  connect(m_field, &QLineEdit::textEdited, this, [this](const QString& typed) {
    m_untouched = false;
    fill(typed);
  });
  connect(m_list, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { this->take(item->data(value_role).toString()); });
  fill({});
}

/// The whole vocabulary while nothing was typed, else what has the typed letters.
void ValuePicker::fill(const QString& typed) {
  m_list->clear();
  for (const VocabularyEntry& entry : m_question.tier.vocabulary) {
    const QString value = QString::fromStdString(entry.value);
    const QString words = value_words(m_question.tier, entry.value);
    if (!typed.isEmpty() && !words.contains(typed, Qt::CaseInsensitive) &&
        !value.contains(typed, Qt::CaseInsensitive))
      continue;
    const QString key = entry.key != 0 ? QString(QChar(entry.key)).toUpper() + "   " : "     ";
    auto* item = new QListWidgetItem(QIcon(swatch(value_colour(m_palette, m_question.tier, entry.value), 2)),
                                     key + words, m_list);
    item->setData(value_role, value);
    item->setToolTip(plain_tip(QString::fromStdString(entry.description)));
    item->setSizeHint({width_px - 30, row_px});
    if (value == m_question.start) m_list->setCurrentItem(item);
  }
  if (!typed.isEmpty() && !m_list->currentItem()) m_list->setCurrentRow(0);
  const int rows = std::min(most_rows, m_list->count());
  m_list->setFixedHeight(rows * row_px + 2);
  m_list->setVisible(rows > 0);
  m_hint->setVisible(!m_question.tier.vocabulary.empty());
  if (isVisible()) settle();
}

QString ValuePicker::value() const {
  const QListWidgetItem* marked = m_list->isHidden() ? nullptr : m_list->currentItem();
  return marked ? marked->data(value_role).toString() : m_field->text().trimmed();
}

QString ValuePicker::complaint() const {
  return m_complaint->text();
}

/// Below its corner, or above where there is no room; inside the window.
void ValuePicker::settle() {
  constexpr int margin = 8;
  layout()->activate();
  resize(width_px, layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width_px)
                                                 : layout()->sizeHint().height());
  const QSize room = parentWidget()->size();
  const int x = std::clamp(m_corner.x(), margin, std::max(margin, room.width() - width() - margin));
  const bool fits = m_corner.y() + height() + margin <= room.height();
  const int y = fits ? m_corner.y() : std::max(margin, m_corner.y() - height() - 6);
  move(x, std::clamp(y, margin, std::max(margin, room.height() - height() - margin)));
}

void ValuePicker::take(const QString& value) {
  const QPointer<ValuePicker> self(this);  // what takes it may open another
  const QString complaint = m_take(value);
  if (!self) return;
  if (complaint.isEmpty()) return leave();
  m_complaint->setText(complaint);
  m_complaint->show();
  m_field->selectAll();
  settle();
}

void ValuePicker::leave() {
  m_field->removeEventFilter(this);
  hide();
  if (m_before && m_before->isVisible()) m_before->setFocus(Qt::PopupFocusReason);
  deleteLater();
}

bool ValuePicker::press(int key, const QString& text) {
  if (key == Qt::Key_Escape) return leave(), true;
  if (key == Qt::Key_Return || key == Qt::Key_Enter) return take(value()), true;
  if (key == Qt::Key_Down || key == Qt::Key_Up) {
    const int count = m_list->count(), step = key == Qt::Key_Down ? 1 : -1;
    if (count > 0) m_list->setCurrentRow((std::max(m_list->currentRow(), 0) + step + count) % count);
    return true;
  }
  if (!m_untouched || text.size() != 1) return false;
  const VocabularyEntry* entry = m_question.tier.entry_of_key(text.at(0).toLatin1());
  if (entry) take(QString::fromStdString(entry->value));
  return entry != nullptr;
}

bool ValuePicker::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();  // what is typed here is no command of the window
    return true;
  }
  if (event->type() == QEvent::KeyPress) {
    const auto* pressed = static_cast<QKeyEvent*>(event);
    if (press(pressed->key(), pressed->text())) return true;
    m_untouched = false;
  }
  if (event->type() == QEvent::FocusOut && isVisible() &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) {
    m_before = nullptr;  // somebody went elsewhere on purpose
    leave();
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace abrazo::widgets
