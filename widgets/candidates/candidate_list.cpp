#include "widgets/candidates/candidate_list.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int total_width = 56;
constexpr int name_left = 46;

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

}  // namespace

CandidateList::CandidateList(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setMouseTracking(true);
}

void CandidateList::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void CandidateList::setRows(std::vector<CandidateRow> rows) {
  m_rows = std::move(rows);
  const int wanted = row_height * std::max<int>(static_cast<int>(m_rows.size()), 1);
  if (wanted != minimumHeight()) setFixedHeight(wanted);
  double largest = 0;
  for (const CandidateRow& row : m_rows) largest = std::max(largest, row.total);
  // Grows at once and shrinks slowly: bars that rescale with every frame cannot be read.
  m_fullBar = largest > m_fullBar ? largest : std::max(largest, 0.88 * m_fullBar);
  if (m_hovered >= static_cast<int>(m_rows.size())) hover(-1);
  if (m_hovered >= 0) emit candidateHovered(m_rows[static_cast<std::size_t>(m_hovered)].candidate);
  update();
}

/// Of take and frame; in a narrow list the bars need the room more.
double CandidateList::nameWidth() const {
  return width() < 370 ? 112 : 138;
}

QRectF CandidateList::barArea(int row) const {
  const double left = name_left + nameWidth();
  return {left, row * row_height + 7.0, std::max(20.0, width() - left - total_width - 12), 10};
}

void CandidateList::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (m_rows.empty()) {
    painter.setPen(m_palette.secondary);
    painter.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignVCenter, "Nothing selected yet");
  }
  const int first = event->rect().top() / row_height;
  const int last = std::min(static_cast<int>(m_rows.size()) - 1, event->rect().bottom() / row_height);
  for (int r = first; r <= last; ++r) paintRow(painter, r);
}

void CandidateList::paintRow(QPainter& painter, int index) const {
  const CandidateRow& row = m_rows[static_cast<std::size_t>(index)];
  const QRectF line(0, index * row_height, width(), row_height);
  if (row.selected) {
    painter.fillRect(line, m_palette.raised);
    painter.fillRect(QRectF(line.topLeft(), QSizeF(2, row_height)), m_palette.warning);
  } else if (index == m_hovered) {
    painter.fillRect(line, mixed(m_palette.raised, m_palette.panel, 0.55));
  }
  painter.setFont(interface_font(13));
  painter.setPen(m_palette.secondary);
  draw_tabular(painter, QRectF(0, line.top(), 26, row_height), Qt::AlignRight, QString::number(index + 1));
  painter.setPen(Qt::NoPen);
  painter.setBrush(label_colour(m_palette, row.label));
  painter.drawEllipse(QPointF(36, line.center().y()), 3.6, 3.6);

  // The frame number must not be pushed out by a long take name.
  const QString number = QString::number(row.frame) + (row.swapped ? " ⇄" : "");
  const double number_width = tabular_width(painter.font(), number);
  const QString name = painter.fontMetrics().elidedText(text(row.take), Qt::ElideMiddle,
                                                        static_cast<int>(nameWidth() - number_width - 16));
  painter.setPen(m_palette.text);
  painter.drawText(QRectF(name_left, line.top(), nameWidth(), row_height), Qt::AlignVCenter, name);
  const double after = name_left + painter.fontMetrics().horizontalAdvance(name) + 5;
  painter.setPen(m_palette.secondary);
  draw_tabular(painter, QRectF(after, line.top(), number_width + 2, row_height), Qt::AlignLeft, number);

  const QRectF area = barArea(index);
  const BarEnds ends = bar_ends(row, m_fullBar);
  const auto part = [&](double from, double to, const QColor& colour) {
    painter.fillRect(
        QRectF(area.left() + from * area.width(), area.top(), (to - from) * area.width(), area.height()),
        colour);
  };
  part(0, ends.pose, m_palette.user);
  part(ends.pose, ends.active, m_palette.active);
  part(ends.active, ends.passive, m_palette.passive);
  painter.setPen(m_palette.text);
  draw_tabular(painter, line.adjusted(0, 0, -12, 0), Qt::AlignRight, QString::number(row.total, 'f', 3));
}

QString CandidateList::tip(const CandidateRow& row) const {
  const auto line = [](const char* name, double value) {
    return QString("<tr><td>%1&nbsp;&nbsp;</td><td align=right>%2 m²</td></tr>")
        .arg(name)
        .arg(value, 0, 'f', 4);
  };
  QString tip = QString("<b>%1 · %2</b>%3<br>%4<table>")
                    .arg(text(row.take).toHtmlEscaped())
                    .arg(row.frame)
                    .arg(row.swapped ? " (roles swapped)" : "")
                    .arg(row.label.empty() ? "no label" : text(row.label).toHtmlEscaped());
  tip += line("pose", row.pose) + line("α · temporal leader", row.active) +
         line("α · temporal follower", row.passive) + line("total (Eq. 7)", row.total);
  return tip + "</table>";
}

void CandidateList::hover(int row) {
  if (row == m_hovered) return;
  m_hovered = row;
  emit candidateHovered(row < 0 || row >= static_cast<int>(m_rows.size())
                            ? -1
                            : m_rows[static_cast<std::size_t>(row)].candidate);
  update();
}

void CandidateList::mouseMoveEvent(QMouseEvent* event) {
  const int row = event->y() / row_height;
  hover(row < static_cast<int>(m_rows.size()) ? row : -1);
}

void CandidateList::leaveEvent(QEvent*) {
  hover(-1);
}

bool CandidateList::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto row = static_cast<std::size_t>(std::max(0, help->y() / row_height));
  row < m_rows.size() ? QToolTip::showText(help->globalPos(), tip(m_rows[row]), this) : QToolTip::hideText();
  return true;
}

}  // namespace abrazo::widgets
