#include "widgets/common/message_bar.hpp"

#include <QLabel>
#include <QPainter>
#include <QTimer>
#include <QToolButton>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr int information_ms = 6000, warnings_ms = 15000;
constexpr int most_in_tip = 20;
constexpr std::size_t most_errors = 20;
constexpr int longest_text = 320;  // more would cover the scene; the tool tip has the rest

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent),
      m_palette(palette_of(Theme::Dark)),
      m_sign(new QLabel(this)),
      m_text(new QLabel(this)),
      m_count(new QLabel(this)),
      m_close(new QToolButton(this)),
      m_leave(new QTimer(this)) {
  auto* row = row_in(this, {12, 6, 8, 6}, 8);
  row->addWidget(m_sign);
  row->addWidget(m_text, 1);
  row->addWidget(m_count);
  row->addWidget(m_close);
  m_count->setObjectName("secondary");
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  m_close->setObjectName("flat");
  describe(*m_close, "Close the message, or cancel the job that runs", "Close (a running job is cancelled)");
  m_leave->setSingleShot(true);
  connect(m_leave, &QTimer::timeout, this, &MessageBar::leave);
  connect(m_close, &QToolButton::clicked, this, &MessageBar::close);
  hide();
}

void MessageBar::setColours(const Palette& palette) {
  m_palette = palette;
  m_close->setIcon(icon(Icon::Close, palette.secondary));
  update();
}

QString MessageBar::text() const {
  return m_text->text();
}

QStringList MessageBar::openErrors() const {
  QStringList texts;
  for (const OpenError& error : m_errors) texts << error.text;
  return texts;
}

void MessageBar::showError(const QString& text) {
  showErrorOf({}, text);
}

void MessageBar::showErrorOf(const QString& job, const QString& text) {
  std::erase_if(m_errors, [&](const OpenError& error) { return error.text == text; });
  m_errors.push_back({job, text});
  if (m_errors.size() > most_errors) m_errors.erase(m_errors.begin());
  present(MessageKind::Error, text);
  emit told(MessageKind::Error, text);
}

void MessageBar::succeed(const QString& job, const QString& text, bool is_shown_elsewhere) {
  std::erase_if(m_errors, [&](const OpenError& error) { return error.job == job; });
  if (!is_shown_elsewhere) return showInformation(text);
  if (m_kind == MessageKind::Error) leave();
  emit told(MessageKind::Information, text);
}

void MessageBar::withdrawErrorsOf(const QString& job) {
  const auto gone = std::erase_if(m_errors, [&](const OpenError& error) { return error.job == job; });
  if (gone > 0 && m_kind == MessageKind::Error) leave();
}

void MessageBar::showInformation(const QString& text) {
  present(MessageKind::Information, text);
  m_leave->start(information_ms);
  emit told(MessageKind::Information, text);
}

void MessageBar::showWarnings(const QStringList& warnings) {
  if (warnings.isEmpty()) return;
  const bool one = warnings.size() == 1;
  present(
      MessageKind::Information,
      one ? warnings.front() : QString("%1 warnings: %2 …").arg(warnings.size()).arg(warnings.front()),
      one ? QString()
          : warnings.mid(0, most_in_tip).join("\n") +
                (warnings.size() > most_in_tip ? QString("\nand %1 more").arg(warnings.size() - most_in_tip)
                                               : QString()));
  m_leave->start(warnings_ms);
  for (const QString& warning : warnings) emit told(MessageKind::Warning, warning);
}

void MessageBar::showProgress(const QString& doing, double fraction) {
  m_fraction = fraction;
  present(MessageKind::Progress, doing);
}

void MessageBar::endProgress() {
  if (m_kind == MessageKind::Progress) leave();
}

/// What leaves by itself makes room for the last error that was not closed.
void MessageBar::leave() {
  m_leave->stop();
  m_errors.empty() ? hide() : present(MessageKind::Error, m_errors.back().text);
}

void MessageBar::close() {
  if (m_kind == MessageKind::Progress) emit cancelRequested();
  if (m_kind == MessageKind::Error && !m_errors.empty()) m_errors.pop_back();
  leave();
}

void MessageBar::present(MessageKind kind, const QString& text, const QString& tip) {
  m_leave->stop();
  m_kind = kind;
  m_count->setText(kind == MessageKind::Error && m_errors.size() > 1
                       ? QString("and %1 before").arg(m_errors.size() - 1)
                       : QString());
  m_count->setVisible(!m_count->text().isEmpty());
  const bool whole = text.size() <= longest_text;
  m_text->setText(whole ? text : text.left(longest_text) + " …");
  // As rich text a tool tip wraps its lines.
  const QString more = tip.isEmpty() && !whole ? text : tip;
  m_text->setToolTip(more.isEmpty() ? QString()
                                    : "<p>" + more.toHtmlEscaped().replace("\n", "</p><p>") + "</p>");
  const auto sign = kind == MessageKind::Error ? icon(Icon::Warning, m_palette.live.lighter(135))
                                               : icon(Icon::Information, m_palette.secondary);
  m_sign->setPixmap(sign.pixmap(16, 16));
  m_close->setIcon(icon(Icon::Close, m_palette.secondary));
  show();
  update();
}

void MessageBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(
      rect(), m_kind == MessageKind::Error ? mixed(m_palette.live, m_palette.panel, 0.22) : m_palette.raised);
  painter.setPen(m_palette.border);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  if (m_kind == MessageKind::Progress)
    painter.fillRect(QRectF(0, height() - 2, width() * m_fraction, 2), m_palette.accent.lighter(130));
}

}  // namespace abrazo::widgets
