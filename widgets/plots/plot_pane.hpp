#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/common/palette.hpp"
#include "widgets/plots/pane_arrangement.hpp"
#include "widgets/plots/plot_head.hpp"
#include "widgets/plots/sample_table.hpp"
#include "widgets/plots/value_axis.hpp"

class QCPItemLine;
class QCPPainter;
class QCustomPlot;
class QMouseEvent;
class QToolButton;
class QWheelEvent;

namespace abrazo::widgets {

/// View state shared by all panes.
struct PlotView {
  double from_s = 0, to_s = 1;
  double cursor_s = 0;
  std::optional<double> pointer_s;  ///< time of the pointer, drawn as a thin line
};

/// One plot over time: title, legend and values in the header, curves and cursor below. Outliers far above
/// the rest are cut, with a mark at the upper edge. Emits requests; moves nothing itself.
class PlotPane : public QWidget {
  Q_OBJECT
 public:
  explicit PlotPane(QWidget* parent);
  void setSeries(PaneSeries series);
  const PaneSeries& series() const { return m_series; }
  /// Overrides the title of the series; empty = no override.
  void setTitle(const std::string& title);
  void setColours(const Palette& palette);
  /// Whether the window follows the live end; shown in the header.
  void setMark(PlotMark mark);
  /// Shows only the header, for small heights.
  void setCollapsed(bool collapsed);
  bool isCollapsed() const { return m_collapsed; }

  /// Values in the header; null shows none.
  void showValues(const SeriesValues* values);
  const std::optional<SeriesValues>& shownValues() const { return m_values; }
  /// One for all panes of a quantity; other series begin with a new one.
  void setAxis(std::shared_ptr<ValueAxis> axis) { m_axis = std::move(axis); }
  const std::shared_ptr<ValueAxis>& axis() const { return m_axis; }
  /// Reads the curves and tells the axis what they need. Panes that share an axis are all read before one is
  /// drawn.
  void read(const SampleTable& table, const PlotView& view);
  /// Draws what was read.
  void draw();
  double xOf(double time_s) const;
  double upperEnd() const;
  /// As `read`, for a pane of this size in a picture or file, even if it has no room on the screen.
  void readFor(QSize place, const SampleTable& table, const PlotView& view);
  /// Paints what was read into a rectangle of the picture or file. Curves end at the border even if the
  /// painter cannot clip. `read` and `draw` restore the screen's state.
  void paintInto(QCPPainter& painter, const QRect& place);

 signals:
  void seekRequested(double time_s);
  void panRequested(double by_s);
  void zoomRequested(double factor, double fixed_s);
  void followRequested();
  void menuRequested(const QPoint& global);
  void pointerMoved(double time_s, const QPoint& global);
  void pointerLeft();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Drag { None, Undecided, Pan, Scrub };
  void setUpPlot();
  void setUpMouse();
  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void wheel(const QWheelEvent& event);
  void read(const SampleTable& table, const PlotView& view, QSize curves);
  void fillGraphs(bool within_border);
  void lay(QSize curves, bool within_border);
  void showTimes(QSize curves);
  double timeAt(int x) const;
  bool isAtCursor(int x) const;
  int seriesCount() const { return static_cast<int>(m_series.size()); }

  PaneSeries m_series;
  std::string m_title;
  std::vector<std::vector<SampleTable::Point>> m_lines;  ///< one per series
  std::optional<SeriesValues> m_values;
  PlotView m_view;
  Palette m_palette;
  QCustomPlot* m_plot;
  QCPItemLine *m_cursor, *m_pointer;
  QToolButton* m_menu;
  std::shared_ptr<ValueAxis> m_axis = std::make_shared<ValueAxis>();
  PlotMark m_mark = PlotMark::None;
  bool m_collapsed = false;
  Drag m_drag = Drag::None;
  int m_pressX = 0, m_lastX = 0;
};

}  // namespace abrazo::widgets
