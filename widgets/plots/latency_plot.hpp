#pragma once

#include <QWidget>
#include <span>
#include <vector>

#include "widgets/common/latency_sample.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/value_range.hpp"

class QCPGraph;
class QCPItemLine;
class QCustomPlot;

namespace abrazo::widgets {

/// Latency over time: stacked stages, with the line of in to out. Each column of a few pixels shows its
/// slowest frame, so that no spike is lost.
class LatencyPlot : public QWidget {
  Q_OBJECT
 public:
  explicit LatencyPlot(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param samples   ascending in time
  /// @param cursor_s  of the shown frame
  void show(std::span<const LatencySample> samples, double from_s, double to_s, double cursor_s);
  /// The drawn samples: the slowest of each column.
  const std::vector<LatencySample>& columns() const { return m_columns; }
  double upperEnd() const;

 signals:
  void seekRequested(double time_s);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void setUp();
  void fill();

  Palette m_palette;
  std::vector<LatencySample> m_columns;
  SteadyRange m_upper;
  QCustomPlot* m_plot;
  std::vector<QCPGraph*> m_stages;  ///< areas up to the end of each stage, drawn from the last stage
  QCPGraph* m_total;
  QCPItemLine* m_cursor;
};

/// The sample with the largest latency from in to out in each of `columns` equal spans of [from, to].
std::vector<LatencySample> slowest_of_each(std::span<const LatencySample> samples, double from_s, double to_s,
                                           int columns);

}  // namespace abrazo::widgets
