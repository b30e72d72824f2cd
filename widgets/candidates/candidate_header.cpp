#include "widgets/candidates/candidate_header.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/candidates/candidate_list.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int head_height = 20;  ///< of a line
constexpr int arrow_room = 9;
constexpr int swatch = 8;  ///< px
constexpr int swatch_gap = 2, term_gap = 5;

QString title(CandidateColumn column) {
  return text(column_title(column));
}

QString name(CandidateColumn column) {
  if (const auto term = term_of(column)) return text(info_of(*term).name);
  switch (column) {
    case CandidateColumn::Rank:
      return "#";
    case CandidateColumn::Source:
      return "take";
    case CandidateColumn::Label:
      return "move";
    case CandidateColumn::Distance:
      return "distance";
    default:
      return "total";
  }
}

}  // namespace

CandidateHeader::CandidateHeader(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFixedHeight(head_height);
  setFont(interface_font(11));
  setAccessibleName("Columns of the candidates");
  setAccessibleDescription("Sorted by rank");
}

void CandidateHeader::setOrder(const CandidateOrder& order) {
  if (order == m_order) return;
  m_order = order;
  setAccessibleDescription("Sorted by " + title(order.column) + (order.descending ? ", descending" : ""));
  arrange();
}

void CandidateHeader::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void CandidateHeader::setMethod(SelectionMethod method) {
  m_method = method;
  arrange();
}

double CandidateHeader::widthOf(CandidateColumn column) const {
  const double words = QFontMetricsF(font()).horizontalAdvance(name(column));
  if (!term_of(column)) return words + arrow_room;
  return swatch + swatch_gap + words + (column == m_order.column ? arrow_room : term_gap);
}

double CandidateHeader::widthOfTerms() const {
  double wide = 0;
  for (const CostTermInfo& info : cost_terms(m_method).terms) wide += widthOf(column_of(info.term));
  return wide;
}

bool CandidateHeader::termsStandAlone() const {
  const double others = widthOf(CandidateColumn::Distance) + widthOf(CandidateColumn::Total);
  return CandidateLayout{width()}.barsLeft() + widthOfTerms() >
         width() - CandidateLayout::margin + arrow_room - others;
}

void CandidateHeader::arrange() {
  double bottom = head_height;
  for (const Head& head : heads()) bottom = std::max(bottom, head.area.bottom());
  setFixedHeight(static_cast<int>(bottom));
  update();
}

void CandidateHeader::resizeEvent(QResizeEvent*) {
  arrange();
}

std::vector<CandidateHeader::Head> CandidateHeader::heads() const {
  std::vector<Head> heads;
  const bool alone = termsStandAlone();
  const auto put = [&](CandidateColumn column, double left, double top = 0) {
    const QRectF area(left, top, widthOf(column), head_height);
    heads.push_back({column, name(column), area});
    return area.right();
  };
  put(CandidateColumn::Rank, CandidateLayout::gutter + 7);
  const double after = put(CandidateColumn::Source, CandidateLayout::name_left);
  put(CandidateColumn::Label, after + 6);
  const double right = width() - CandidateLayout::margin + arrow_room;
  const double total = right - widthOf(CandidateColumn::Total);
  put(CandidateColumn::Distance, total - widthOf(CandidateColumn::Distance));
  put(CandidateColumn::Total, total);
  double left = alone ? CandidateLayout::margin : CandidateLayout{width()}.barsLeft(),
         top = alone ? head_height : 0;
  for (const CostTermInfo& info : cost_terms(m_method).terms) {
    const CandidateColumn column = column_of(info.term);
    if (alone && left > CandidateLayout::margin && left + widthOf(column) > right) {
      left = CandidateLayout::margin;
      top += head_height;
    }
    left = put(column, left, top);
  }
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
    QRectF words = head.area;
    if (const auto term = term_of(head.column)) {
      painter.fillRect(QRectF(words.left(), words.center().y() - 0.5 * swatch, swatch, swatch),
                       colour_of(*term, m_palette));
      words.setLeft(words.left() + swatch + swatch_gap);
    }
    painter.setPen(sorted ? m_palette.text : m_palette.secondary);
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, head.name);
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
