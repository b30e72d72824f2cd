#include "widgets/common/message_log.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QListWidget>
#include <QPushButton>
#include <QTime>
#include <QTimer>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int most_messages = 500;
constexpr int kind_role = Qt::UserRole;

QString level_name(MessageKind kind) {
  return kind == MessageKind::Error ? "error" : kind == MessageKind::Warning ? "warning" : "information";
}

}  // namespace

MessageLog::MessageLog(QWidget* parent)
    : QWidget(parent), m_palette(palette_of(Theme::Dark)), m_list(new QListWidget(this)) {
  m_list->setAccessibleName("Messages since the start");
  m_list->setWordWrap(true);
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  auto* copy = new QPushButton("Copy all", this);
  auto* clear = new QPushButton("Clear", this);
  auto* column = column_in(this, {}, 0);
  column->addWidget(m_list, 1);
  auto* row = nested_row({12, 4, 12, 8});
  row->addStretch(1);
  row->addWidget(copy);
  row->addWidget(clear);
  column->addLayout(row);
  setFocusProxy(m_list);
  connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
  connect(clear, &QPushButton::clicked, m_list, &QListWidget::clear);
}

void MessageLog::setColours(const Palette& palette) {
  m_palette = palette;
  for (int row = 0; row < m_list->count(); ++row) paint(row);
}

void MessageLog::paint(int row) {
  const auto kind = static_cast<MessageKind>(m_list->item(row)->data(kind_role).toInt());
  const bool is_bad = kind == MessageKind::Error || kind == MessageKind::Warning;
  const QColor colour = kind == MessageKind::Error     ? m_palette.live.lighter(m_palette.dark ? 135 : 100)
                        : kind == MessageKind::Warning ? m_palette.warning
                                                       : m_palette.secondary;
  m_list->item(row)->setIcon(icon(is_bad ? Icon::Warning : Icon::Information, colour));
}

void MessageLog::add(MessageKind kind, const QString& text) {
  auto* item = new QListWidgetItem(
      QString("%1  %2  %3").arg(QTime::currentTime().toString("hh:mm:ss"), level_name(kind), text), m_list);
  item->setData(kind_role, static_cast<int>(kind));
  paint(m_list->count() - 1);
  if (m_list->count() > most_messages) delete m_list->takeItem(0);
  m_list->scrollToBottom();
}

/// Lines that were added while it was hidden have their heights only with the next layout.
void MessageLog::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  QTimer::singleShot(0, m_list, &QListWidget::scrollToBottom);
}

QString MessageLog::text() const {
  QStringList lines;
  for (int row = 0; row < m_list->count(); ++row) lines << m_list->item(row)->text();
  return lines.join("\n");
}

}  // namespace abrazo::widgets
