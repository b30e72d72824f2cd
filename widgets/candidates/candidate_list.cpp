#include "widgets/candidates/candidate_list.hpp"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/candidates/pin_mark.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/typeset.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr double vetoed_opacity = 0.4;
constexpr double least_part = 2;  ///< width of the smallest part of a bar [px]

QString figure(const CandidateRow& row, CandidateColumn column) {
  return QString::number(shown_figure(row, column), 'f', 3) + text(figure_unit(row, column));
}

}  // namespace

CandidateList::CandidateList(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName("Candidates");
}

void CandidateList::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void CandidateList::setRows(std::vector<CandidateRow> rows, CandidateColumn figure) {
  const bool other_unit = !rows.empty() && (m_rows.empty() || rows.front().method != m_rows.front().method);
  const bool was_empty = m_rows.empty();
  m_rows = std::move(rows);
  m_figure = figure;
  fit();
  if (m_rows.empty() != was_empty) describe();
  double largest = 0;
  for (const CandidateRow& row : m_rows) largest = std::max(largest, row.total);
  // Grows immediately and shrinks slowly: bars that rescale with every frame cannot be read.
  m_fullBar = other_unit || largest > m_fullBar ? largest : std::max(largest, 0.88 * m_fullBar);
  if (m_hovered >= static_cast<int>(m_rows.size())) m_hovered = -1;
  if (m_currentPair >= 0) {
    m_current = rowOf(m_currentPair);
    if (m_current >= 0) m_lastRow = m_current;
    describe();
  }
  point();
  update();
}

void CandidateList::setNotice(const QString& notice) {
  if (notice == m_notice) return;
  m_notice = notice;
  fit();
  describe();
  update();
}

/// As high as the rows, or as the notice in their place.
void CandidateList::fit() {
  constexpr int margins = 2 * CandidateLayout::margin, above_and_below = 8;
  const QRect room(0, 0, std::max(1, width() - margins), QWIDGETSIZE_MAX);
  const int wanted =
      m_rows.empty()
          ? std::max(row_height,
                     fontMetrics().boundingRect(room, Qt::TextWordWrap, m_notice).height() + above_and_below)
          : row_height * static_cast<int>(m_rows.size());
  if (wanted != minimumHeight()) setFixedHeight(wanted);
}

void CandidateList::resizeEvent(QResizeEvent*) {
  fit();
}

const CandidateRow* CandidateList::row(int index) const {
  return index >= 0 && index < static_cast<int>(m_rows.size()) ? &m_rows[static_cast<std::size_t>(index)]
                                                               : nullptr;
}

const CandidateRow* CandidateList::current() const {
  return row(m_current);
}

void CandidateList::setCurrent(int index) {
  const CandidateRow* chosen = row(index);
  m_current = chosen ? index : -1;
  m_currentPair = chosen ? chosen->pair : -1;
  m_lastRow = m_current;
  describe();
  point();
  update();
  emit currentChanged(m_current);
}

int CandidateList::rowOf(int pair) const {
  const auto same = std::find_if(m_rows.begin(), m_rows.end(),
                                 [pair](const CandidateRow& row) { return row.pair == pair; });
  return pair >= 0 && same != m_rows.end() ? static_cast<int>(same - m_rows.begin()) : -1;
}

void CandidateList::setCurrentPair(int pair) {
  if (pair == m_currentPair) return;
  m_currentPair = pair;
  m_current = m_lastRow = rowOf(pair);
  describe();
  point();
  update();
  emit currentChanged(m_current);
}

/// By the user: the row becomes current and emits the signal.
void CandidateList::choose(int index) {
  const int before = m_currentPair;
  setCurrent(index);
  if (m_currentPair != before) emit pairChosen(m_currentPair);
}

void CandidateList::moveBy(int rows) {
  const int from = m_current >= 0 ? m_current : m_lastRow;
  choose(std::clamp(from + rows, 0, static_cast<int>(m_rows.size()) - 1));
}

void CandidateList::setLinked(int candidate) {
  if (candidate == m_linked) return;
  m_linked = candidate;
  update();
}

/// Screen reader text of the current row.
void CandidateList::describe() {
  const CandidateRow* row = current();
  if (!row) return setAccessibleDescription(m_rows.empty() ? m_notice : "No row is selected");
  QString words = QString("Rank %1 of %2, %3 frame %4, %5, total cost %6")
                      .arg(row->rank)
                      .arg(m_rows.size())
                      .arg(text(row->take))
                      .arg(row->frame)
                      .arg(row->label.empty() ? "no label" : text(row->label))
                      .arg(figure(*row, CandidateColumn::Total));
  if (row->selected) words += ", selected";
  if (row->continues_source) words += ", continues";
  if (row->pinned) words += ", pinned";
  if (row->vetoed) words += ", vetoed";
  if (row->not_meant) words += ", not the intended move";
  if (words != accessibleDescription()) setAccessibleDescription(words);
}

QRectF CandidateList::barArea(int row) const {
  const CandidateLayout layout{width()};
  return QRectF(layout.barsLeft(), row * row_height + 7.0, layout.barsWidth(), 10);
}

void CandidateList::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (m_rows.empty()) {
    painter.setPen(m_palette.secondary);
    constexpr int margin = CandidateLayout::margin;
    painter.drawText(rect().adjusted(margin, 0, -margin, 0), Qt::AlignVCenter | Qt::TextWordWrap, m_notice);
  }
  const int first = event->rect().top() / row_height;
  const int last = std::min(static_cast<int>(m_rows.size()) - 1, event->rect().bottom() / row_height);
  for (int r = first; r <= last; ++r) paintRow(painter, r);
}

void CandidateList::paintRow(QPainter& painter, int index) const {
  const CandidateRow& row = m_rows[static_cast<std::size_t>(index)];
  const QRectF line(0, index * row_height, width(), row_height);
  paintBackground(painter, index, line);
  painter.setFont(interface_font(13));
  paintMarks(painter, index, line);
  painter.setOpacity(row.is_out() ? vetoed_opacity : 1);
  paintName(painter, row, line);
  paintBar(painter, index);
  painter.setPen(m_palette.text);
  draw_tabular(painter, line.adjusted(0, 0, -CandidateLayout::margin, 0), Qt::AlignRight,
               figure(row, m_figure));
  painter.setOpacity(1);
}

void CandidateList::paintBackground(QPainter& painter, int index, const QRectF& line) const {
  const CandidateRow& row = m_rows[static_cast<std::size_t>(index)];
  if (row.selected) {
    painter.fillRect(line, m_palette.raised);
    painter.fillRect(QRectF(line.topLeft(), QSizeF(2, row_height)), m_palette.warning);
  } else if (index == m_hovered || (m_linked >= 0 && row.candidate == m_linked)) {
    painter.fillRect(line, mixed(m_palette.raised, m_palette.panel, 0.55));
  }
  if (index != m_current) return;
  painter.setPen(QPen(hasFocus() ? m_palette.accent : m_palette.border, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(line.adjusted(3.5, 0.5, -3.5, -0.5), 4, 4);
}

/// Pin, rank and the dot of the move.
void CandidateList::paintMarks(QPainter& painter, int index, const QRectF& line) const {
  const CandidateRow& row = m_rows[static_cast<std::size_t>(index)];
  const QPointF gutter(3.0 + CandidateLayout::gutter / 2.0, line.center().y());
  if (row.pinned)
    draw_pin(painter, gutter, m_palette.warning, true);
  else if (row.vetoed)
    draw_veto(painter, gutter, m_palette.secondary);
  else if (row.not_meant)
    draw_meant(painter, gutter, m_palette.secondary, true);
  else if (index == m_hovered)
    draw_pin(painter, gutter, m_palette.secondary, false);
  painter.setPen(m_palette.secondary);
  draw_tabular(painter, QRectF(0, line.top(), CandidateLayout::number_right, row_height), Qt::AlignRight,
               QString::number(row.rank));
  painter.setPen(Qt::NoPen);
  painter.setBrush(label_colour(m_palette, row.label));
  painter.drawEllipse(QPointF(CandidateLayout::number_right + 10, line.center().y()), 3.6, 3.6);
}

void CandidateList::paintName(QPainter& painter, const CandidateRow& row, const QRectF& line) const {
  QFont font = interface_font(13);
  font.setStrikeOut(row.vetoed);
  painter.setFont(font);
  // The frame number must not be pushed out by a long take name.
  const double room = CandidateLayout{width()}.nameWidth();
  const QString number = QString::number(row.frame) + (row.swapped ? " ⇄" : "");
  const double number_width = tabular_width(painter.font(), number);
  const QString name = painter.fontMetrics().elidedText(text(row.take), Qt::ElideMiddle,
                                                        static_cast<int>(room - number_width - 16));
  painter.setPen(m_palette.text);
  painter.drawText(QRectF(CandidateLayout::name_left, line.top(), room, row_height), Qt::AlignVCenter, name);
  const double after = CandidateLayout::name_left + painter.fontMetrics().horizontalAdvance(name) + 5;
  painter.setPen(m_palette.secondary);
  draw_tabular(painter, QRectF(after, line.top(), number_width + 2, row_height), Qt::AlignLeft, number);
  if (row.continues_source)
    draw_continuation(painter, QPointF(after + number_width + 8, line.center().y()), m_palette.text);
  painter.setFont(interface_font(13));
}

void CandidateList::paintBar(QPainter& painter, int index) const {
  const QRectF area = barArea(index);
  const CandidateRow& row = m_rows[static_cast<std::size_t>(index)];
  const auto terms = cost_terms(row.method).terms;
  const auto ends = bar_ends(row, m_fullBar, std::min(least_part / area.width(), 1.0 / most_cost_terms));
  double from = 0;
  for (std::size_t i = 0; i < terms.size(); from = ends[i++])
    painter.fillRect(
        QRectF(area.left() + from * area.width(), area.top(), (ends[i] - from) * area.width(), area.height()),
        colour_of(terms[i].term, m_palette));
}

QString CandidateList::tip(const CandidateRow& row) const {
  const auto line = [](std::string_view name, double value, std::string_view unit) {
    return QString("<tr><td>%1&nbsp;&nbsp;</td><td align=right>%2 %3</td></tr>")
        .arg(text(typeset(name)))
        .arg(value, 0, 'f', 4)
        .arg(text(unit));
  };
  QString tip = QString("<b>%1 · %2</b>%3<br>%4%5%6%7<table>")
                    .arg(text(row.take).toHtmlEscaped())
                    .arg(row.frame)
                    .arg(row.swapped ? " (roles swapped)" : "")
                    .arg(row.label.empty() ? "no label" : text(row.label).replace('_', ' ').toHtmlEscaped())
                    .arg(row.continues_source ? " · continues the source" : "")
                    .arg(row.pinned ? " · pinned" : "")
                    .arg(row.vetoed       ? " · vetoed"
                         : !row.not_meant ? ""
                         : row.is_out()   ? " · excluded: another move is intended"
                                          : " · another move is intended");
  const CostTerms& decides = cost_terms(row.method);
  for (const CostTermInfo& info : decides.terms)
    tip += line(info.weighed, value_of(row, info.term), decides.unit);
  tip += line(decides.total, row.total, decides.unit);
  if (row.method == SelectionMethod::Intent)
    tip += line("Eq. 7, which does not decide", row.equation_7, "m²");
  tip += line("feature distance", row.feature_distance, "m");
  return tip + "</table>";
}

int CandidateList::rowAt(const QPoint& position) const {
  const int index = position.y() < 0 ? -1 : position.y() / row_height;
  return row(index) ? index : -1;
}

void CandidateList::hover(int row) {
  if (row == m_hovered) return;
  m_hovered = row;
  point();
  update();
}

/// Announces the pair under the pointer or, with the keyboard here, the current one.
void CandidateList::point() {
  const CandidateRow* at = row(m_hovered >= 0 ? m_hovered : hasFocus() ? m_current : -1);
  const int candidate = at ? at->candidate : -1;
  if (candidate == m_told) return;
  m_told = candidate;
  emit candidateHovered(candidate);
}

void CandidateList::mouseMoveEvent(QMouseEvent* event) {
  hover(rowAt(event->pos()));
}

void CandidateList::mousePressEvent(QMouseEvent* event) {
  const int index = rowAt(event->pos());
  if (index < 0) return;
  if (event->button() == Qt::LeftButton && event->x() < CandidateLayout::gutter + 3) {
    // Copies: the answer may come as new rows.
    const CandidateRow chosen = m_rows[static_cast<std::size_t>(index)];
    emit pinClicked(chosen);
  } else {
    choose(index);
  }
}

void CandidateList::mouseDoubleClickEvent(QMouseEvent* event) {
  const CandidateRow* at = row(rowAt(event->pos()));
  if (!at || event->button() != Qt::LeftButton) return;
  const CandidateRow chosen = *at;
  if (event->x() < CandidateLayout::gutter + 3)
    emit pinClicked(chosen);
  else
    emit jumpAsked(chosen);
}

void CandidateList::contextMenuEvent(QContextMenuEvent* event) {
  const bool by_key = event->reason() == QContextMenuEvent::Keyboard;
  const int index = by_key ? m_current : rowAt(event->pos());
  if (!row(index)) return;
  const CandidateRow chosen = *row(index);
  const QPoint below(CandidateLayout::name_left, (index + 1) * row_height);
  emit menuAsked(chosen, by_key ? mapToGlobal(below) : event->globalPos());
}

void CandidateList::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(m_rows.size()) - 1;
  switch (event->key()) {
    case Qt::Key_Up:
      return moveBy(-1);
    case Qt::Key_Down:
      return moveBy(1);
    case Qt::Key_PageUp:
      return choose(0);
    case Qt::Key_PageDown:
      return choose(last);
    case Qt::Key_Escape:
      return choose(-1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return emit jumpToChosenAsked();
    default:
      QWidget::keyPressEvent(event);
  }
}

void CandidateList::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  const bool by_key = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  if (by_key && m_currentPair < 0 && !m_rows.empty()) return choose(0);
  point();
  update();
}

void CandidateList::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  point();
  update();
}

void CandidateList::leaveEvent(QEvent*) {
  hover(-1);
}

bool CandidateList::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const CandidateRow* at = row(rowAt(help->pos()));
  at ? QToolTip::showText(help->globalPos(), tip(*at), this) : QToolTip::hideText();
  return true;
}

}  // namespace abrazo::widgets
