#include "widgets/annotation/value_picker.hpp"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/value_look.hpp"

namespace abrazo::widgets {
namespace {

constexpr int value_role = Qt::UserRole;
constexpr int text_goes_on_ms = 500;  ///< a key after which another one comes earlier is text
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
  picker->openAt(widget.mapTo(&window, below));
  return picker;
}

ValuePicker::ValuePicker(QWidget& window, const Question& question, const Palette& palette, Take take)
    : EntryFrame(window, question.prompt, question.start, std::move(take)),
      m_question(question),
      m_palette(palette) {
  setFixedWidth(width_px);
  title().setFont(interface_font(12));
  m_list = new QListWidget(this);
  m_list->setAccessibleName("Values of " + QString::fromStdString(question.tier.name));
  m_list->setFocusPolicy(Qt::NoFocus);
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_hint = quiet_label("A key or Return chooses, Esc cancels", this, 11);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->setContentsMargins(10, 8, 10, 8);
  column->insertWidget(column->indexOf(&field()) + 1, m_list);
  column->addWidget(m_hint);
  connect(&field(), &QLineEdit::textEdited, this, [this](const QString& typed) {
    m_untouched = false;
    if (!m_chosen.isActive()) fill(typed);
  });
  m_chosen.setSingleShot(true);
  m_chosen.setInterval(text_goes_on_ms);
  connect(&m_chosen, &QTimer::timeout, this, [this] { this->take(m_chosenValue); });
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
  return marked ? marked->data(value_role).toString() : field().text().trimmed();
}

/// Below its corner, or above if there is no room; inside the window.
void ValuePicker::settle() {
  constexpr int margin = 8;
  layout()->activate();
  resize(width_px, layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width_px)
                                                 : layout()->sizeHint().height());
  const bool fits = corner().y() + height() + margin <= parentWidget()->height();
  moveInside(fits ? corner() : corner() - QPoint(0, height() + 6));
}

bool ValuePicker::press(const QKeyEvent& key) {
  const bool was_chosen = m_chosen.isActive();
  m_chosen.stop();
  if (was_chosen && (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter))
    return this->take(m_chosenValue), true;
  if (EntryFrame::press(key) || moveOrPick(key)) return true;
  m_untouched = false;
  return false;
}

/// Whoever clicks elsewhere has chosen.
bool ValuePicker::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut && m_chosen.isActive()) {
    m_chosen.stop();
    const QString value = m_chosenValue;
    take(value);
    return false;
  }
  return EntryFrame::eventFilter(watched, event);
}

bool ValuePicker::moveOrPick(const QKeyEvent& key) {
  if (key.key() == Qt::Key_Down || key.key() == Qt::Key_Up) {
    const int count = m_list->count(), step = key.key() == Qt::Key_Down ? 1 : -1;
    if (count > 0) m_list->setCurrentRow((std::max(m_list->currentRow(), 0) + step + count) % count);
    return true;
  }
  if (!m_untouched || key.text().size() != 1) return false;
  const VocabularyEntry* entry = m_question.tier.entry_of_key(key.text().at(0).toLatin1());
  if (!entry) return false;
  m_chosenValue = QString::fromStdString(entry->value);
  for (int row = 0; row < m_list->count(); ++row)
    if (m_list->item(row)->data(value_role) == m_chosenValue) m_list->setCurrentRow(row);
  m_chosen.start();
  return false;  // into the field as well: it may be the first letter of a text
}

}  // namespace abrazo::widgets
