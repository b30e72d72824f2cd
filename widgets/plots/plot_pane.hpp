#pragma once

#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/common/value_range.hpp"

class QCPItemLine;
class QCustomPlot;

namespace abrazo::widgets {

/// One plot over time: title and current values above, curves and cursor below. Single values far above the
/// rest are cut, with a mark at the upper edge.
class PlotPane : public QWidget {
  Q_OBJECT
 public:
  struct Curve {
    QString name;
    QString unit;
    int decimals;
  };
  PlotPane(const QString& title, std::vector<Curve> curves, QWidget* parent);
  void setColours(const Palette& palette, const std::vector<QColor>& curves);
  /// The axis reaches at least this high: what is far below it must not look large.
  void setLeastHeight(double value) { m_least = value; }

  void append(double time_s, const std::vector<double>& values);
  void dropBefore(double time_s);
  void clear();
  /// Current values, in the order of the curves; empty shows none.
  void showValues(std::vector<double> values);
  void draw(double from_s, double to_s, double cursor_s);
  double xOf(double time_s) const;

 signals:
  void seekRequested(double time_s);
  void zoomRequested(double factor);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void fitHeight(double from_s, double to_s);
  void markCuts(double from_s, double to_s);
  double headWidth(bool with_values) const;
  int curveCount() const { return static_cast<int>(m_curves.size()); }

  QString m_title;
  std::vector<Curve> m_curves;
  std::vector<QColor> m_colours;
  std::vector<double> m_values;
  Palette m_palette;
  QCustomPlot* m_plot;
  QCPItemLine* m_cursor;
  SteadyRange m_range;
  double m_least = 1e-6;
};

}  // namespace abrazo::widgets
