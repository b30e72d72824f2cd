#include "widgets/plots/plot_picture.hpp"

#include <qcustomplot.h>

#include <QBuffer>
#include <QSvgGenerator>
#include <algorithm>

#include "widgets/plots/plot_pane.hpp"

namespace abrazo::widgets {
namespace {

constexpr QSize least_pane(300, 150);

int pane_count(const PlotSheet& sheet) {
  return static_cast<int>(sheet.panes.size());
}

int columns_of(const PlotSheet& sheet) {
  return std::clamp(sheet.size.width() / least_pane.width(), 1, pane_count(sheet));
}

int rows_of(const PlotSheet& sheet) {
  return (pane_count(sheet) + columns_of(sheet) - 1) / columns_of(sheet);
}

QSize points_of(const PlotSheet& sheet) {
  return sheet.size.expandedTo({least_pane.width(), rows_of(sheet) * least_pane.height()});
}

void paint_all(QCPPainter& painter, const PlotSheet& sheet) {
  const int columns = columns_of(sheet), rows = rows_of(sheet);
  const QSize size = points_of(sheet);
  const auto corner = [&](int column, int row) {
    return QPoint(size.width() * column / columns, size.height() * row / rows);
  };
  const auto place = [&](int pane) {
    const int column = pane % columns, row = pane / columns;
    return QRect(corner(column, row), corner(column + 1, row + 1) - QPoint(1, 1));
  };
  painter.fillRect(QRect(QPoint(0, 0), size), sheet.ground);
  for (int p = 0; p < pane_count(sheet); ++p)
    sheet.panes[static_cast<std::size_t>(p)]->readFor(place(p).size(), sheet.table, sheet.view);
  for (int p = 0; p < pane_count(sheet); ++p)
    sheet.panes[static_cast<std::size_t>(p)]->paintInto(painter, place(p));
}

}  // namespace

QImage plot_picture(const PlotSheet& sheet, double scale) {
  QImage picture(points_of(sheet) * scale, QImage::Format_RGB32);
  picture.setDevicePixelRatio(scale);
  QCPPainter painter(&picture);
  painter.setMode(QCPPainter::pmNoCaching);
  paint_all(painter, sheet);
  return picture;
}

QByteArray plot_svg(const PlotSheet& sheet) {
  QByteArray content;
  QBuffer buffer(&content);
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setSize(points_of(sheet));
  svg.setViewBox(QRect(QPoint(0, 0), points_of(sheet)));
  svg.setTitle("Abrazo plots");
  QCPPainter painter(&svg);
  painter.setMode(QCPPainter::pmVectorized);
  paint_all(painter, sheet);
  painter.end();
  return content;
}

}  // namespace abrazo::widgets
