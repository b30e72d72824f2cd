#include "widgets/stream/figure_grid.hpp"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int row_height = 18;
constexpr double margin = 12, between = 18;

}  // namespace

FigureGrid::FigureGrid(const QString& name, QWidget* parent)
    : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(name);
}

void FigureGrid::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void FigureGrid::show(std::vector<StreamFigure> figures) {
  const bool resized = figures.size() != m_figures.size();
  m_figures = std::move(figures);
  QString words;
  for (const StreamFigure& figure : m_figures)
    words += QString::fromStdString(figure.name + " " + figure.value + ", ");
  words.chop(2);
  setAccessibleDescription(words);
  if (resized) updateGeometry();
  update();
}

QSize FigureGrid::sizeHint() const {
  return {240, row_height * static_cast<int>((m_figures.size() + 1) / 2)};
}

QRectF FigureGrid::cell(std::size_t which) const {
  const double wide = (width() - 2 * margin - between) / 2;
  const auto column = static_cast<double>(which % 2), row = static_cast<double>(which / 2);
  return {margin + column * (wide + between), row * row_height, wide, row_height};
}

void FigureGrid::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QFont plain = interface_font(12), strong = interface_font(12, QFont::DemiBold);
  for (std::size_t i = 0; i < m_figures.size(); ++i) {
    const StreamFigure& figure = m_figures[i];
    const QString name = QString::fromStdString(figure.name), value = QString::fromStdString(figure.value);
    const QRectF place = cell(i);
    painter.setFont(figure.is_odd ? strong : plain);
    painter.setPen(figure.is_odd ? m_palette.warning : m_palette.text);
    draw_tabular(painter, place, Qt::AlignRight, value);
    const double room = place.width() - tabular_width(painter.font(), value) - 6;
    painter.setFont(plain);
    painter.setPen(m_palette.secondary);
    painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                     QFontMetricsF(plain).elidedText(name, Qt::ElideRight, room));
  }
}

bool FigureGrid::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (std::size_t i = 0; i < m_figures.size(); ++i)
    if (cell(i).contains(help->pos())) {
      QToolTip::showText(help->globalPos(), QString::fromStdString(m_figures[i].help), this);
      return true;
    }
  QToolTip::hideText();
  return true;
}

}  // namespace abrazo::widgets
