#include "widgets/candidates/candidate_header.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/candidates/candidate_list.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int head_height = 20;
constexpr int arrow_room = 9;
constexpr int swatch = 8;  ///< px

QString title(CandidateColumn column) {
  return text(column_title(column));
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
  update();
}

void CandidateHeader::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void CandidateHeader::setMethod(SelectionMethod method) {
  m_method = method;
  update();
}

/// Empty if a swatch represents the term.
QString CandidateHeader::name(CandidateColumn column, Fit fit) {
  if (const auto term = term_of(column)) {
    const CostTermInfo& info = info_of(*term);
    return fit == Fit::Swatches ? QString() : text(fit == Fit::Brief ? info.brief : info.name);
  }
  switch (column) {
    case CandidateColumn::Rank:
      return "#";
    case CandidateColumn::Source:
      return "take";
    case CandidateColumn::Label:
      return "move";
    case CandidateColumn::Distance:
      return "dist.";
    default:
      return "total";
  }
}

double CandidateHeader::widthOf(CandidateColumn column, Fit fit) const {
  const QString words = name(column, fit);
  return arrow_room + (words.isEmpty() ? swatch : QFontMetricsF(font()).horizontalAdvance(words));
}

/// The distance gives way to names that are at least brief.
CandidateHeader::Fit CandidateHeader::fitOfTerms(double until_distance, double until_total) const {
  const auto right = [this](Fit fit) {
    double end = CandidateLayout{width()}.barsLeft();
    for (const CostTermInfo& info : cost_terms(m_method).terms) end += widthOf(column_of(info.term), fit);
    return end;
  };
  if (right(Fit::Names) <= until_distance) return Fit::Names;
  return right(Fit::Brief) <= until_total ? Fit::Brief : Fit::Swatches;
}

std::vector<CandidateHeader::Head> CandidateHeader::heads() const {
  std::vector<Head> heads;
  const auto put = [&](CandidateColumn column, double left, Fit fit = Fit::Names) {
    const QRectF area(left, 0, widthOf(column, fit), head_height);
    heads.push_back({column, name(column, fit), area});
    return area.right();
  };
  put(CandidateColumn::Rank, CandidateLayout::gutter + 7);
  const double after = put(CandidateColumn::Source, CandidateLayout::name_left);
  put(CandidateColumn::Label, after + 6);
  const double right = width() - CandidateLayout::margin + arrow_room;
  const double total = right - widthOf(CandidateColumn::Total, Fit::Names);
  const double distance = total - widthOf(CandidateColumn::Distance, Fit::Names);
  const Fit fit = fitOfTerms(distance, total);
  double left = CandidateLayout{width()}.barsLeft();
  for (const CostTermInfo& info : cost_terms(m_method).terms) left = put(column_of(info.term), left, fit);
  if (left <= distance) put(CandidateColumn::Distance, distance);
  put(CandidateColumn::Total, total);
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
    if (const auto term = term_of(head.column); term && head.name.isEmpty())
      painter.fillRect(QRectF(head.area.left(), head.area.center().y() - 0.5 * swatch, swatch, swatch),
                       colour_of(*term, m_palette));
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
