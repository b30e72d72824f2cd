#include "widgets/candidates/candidate_header.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/candidates/candidate_list.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int head_height = 20;
constexpr int arrow_room = 9;

QString title(CandidateColumn column) {
  const std::string_view words = column_title(column);
  return QString::fromUtf8(words.data(), static_cast<int>(words.size()));
}

}  // namespace

CandidateHeader::CandidateHeader(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFixedHeight(head_height);
  setFont(interface_font(11));
  setAccessibleName("Columns of the candidates");
}

void CandidateHeader::setOrder(const CandidateOrder& order) {
  m_order = order;
  setAccessibleDescription("Sorted by " + title(order.column) + (order.descending ? ", descending" : ""));
  update();
}

void CandidateHeader::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

QString CandidateHeader::name(CandidateColumn column, bool brief) {
  switch (column) {
    case CandidateColumn::Rank:
      return "#";
    case CandidateColumn::Source:
      return "take";
    case CandidateColumn::Label:
      return "move";
    case CandidateColumn::Pose:
      return "pose";
    case CandidateColumn::Active:
      return brief ? "lead." : "leader";
    case CandidateColumn::Passive:
      return brief ? "foll." : "follower";
    case CandidateColumn::Total:
      return "total";
    case CandidateColumn::Distance:
      return "dist.";
  }
  return {};
}

std::vector<CandidateHeader::Head> CandidateHeader::heads() const {
  const CandidateLayout layout{width()};
  const QFontMetricsF metrics(font());
  const auto wide = [&](CandidateColumn column, bool brief) {
    return metrics.horizontalAdvance(name(column, brief)) + arrow_room;
  };
  std::vector<Head> heads;
  const auto put = [&](CandidateColumn column, double left, bool brief) {
    heads.push_back({column, name(column, brief), QRectF(left, 0, wide(column, brief), head_height)});
    return left + wide(column, brief);
  };
  put(CandidateColumn::Rank, CandidateLayout::gutter + 7, false);
  const double after = put(CandidateColumn::Source, CandidateLayout::name_left, false);
  put(CandidateColumn::Label, after + 6, false);
  const double right = width() - CandidateLayout::margin + arrow_room;
  const double total = right - wide(CandidateColumn::Total, false);
  const double distance = total - wide(CandidateColumn::Distance, false);
  constexpr std::array<CandidateColumn, 3> terms = {CandidateColumn::Pose, CandidateColumn::Active,
                                                    CandidateColumn::Passive};
  double needed = 0;
  for (const CandidateColumn term : terms) needed += wide(term, false);
  const bool brief = layout.barsLeft() + needed > distance;
  double left = layout.barsLeft();
  for (const CandidateColumn term : terms) left = put(term, left, brief);
  if (left <= distance) put(CandidateColumn::Distance, distance, false);
  put(CandidateColumn::Total, total, false);
  return heads;
}

QRectF CandidateHeader::area(CandidateColumn column) const {
  for (const Head& head : heads())
    if (head.column == column) return head.area;
  return {};
}

void CandidateHeader::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  for (const Head& head : heads()) {
    const bool sorted = head.column == m_order.column;
    painter.setPen(sorted ? m_palette.text : m_palette.secondary);
    painter.drawText(head.area, Qt::AlignVCenter | Qt::AlignLeft, head.name);
    if (!sorted) continue;
    const double x = head.area.right() - arrow_room + 5, y = head.area.center().y() + 0.5;
    const double up = m_order.descending ? -1 : 1;
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_palette.text);
    painter.drawPolygon(QPolygonF({{x - 3, y + 1.8 * up}, {x + 3, y + 1.8 * up}, {x, y - 2.2 * up}}));
  }
  painter.fillRect(QRectF(0, height() - 1, width(), 1), m_palette.border);
}

void CandidateHeader::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  for (const Head& head : heads())
    if (head.area.contains(event->localPos())) return emit columnClicked(head.column);
}

bool CandidateHeader::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (const Head& head : heads()) {
    if (!head.area.contains(help->pos())) continue;
    QToolTip::showText(help->globalPos(), "Sort by " + title(head.column), this);
    return true;
  }
  QToolTip::hideText();
  return true;
}

}  // namespace abrazo::widgets
