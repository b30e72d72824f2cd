#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <string>

#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/playback.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/plots/pane_arrangement.hpp"
#include "widgets/plots/plot_window.hpp"

namespace abrazo::widgets {

class PlotPane;
struct PlotView;

enum class PlotExport { Csv, Png, Svg };

/// Figures of the frames over time in user-arranged panes with a common time cursor. A click requests a seek.
/// A selection has a separate pane, the last. Creates the content of exported files and requests that they be
/// written.
class PlotPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PlotPanel(QWidget* parent = nullptr);
  ~PlotPanel() override;
  void setColours(const Palette& palette);
  void clear();

  /// Without the pane of the selection.
  PaneArrangement arrangement() const;
  void setArrangement(const PaneArrangement& panes);
  void addPane(const PaneSeries& series);
  void removePane(int pane);  ///< except the last remaining one
  void movePane(int pane, int by);
  /// @return false if refused: a pane has one axis, and at least one series
  bool setShown(int pane, Series series, bool on);
  void restoreUsual();

  /// The samples in the window as text, the panes as a picture of `scale` pixels per point, or as SVG.
  std::string csv() const;
  QImage picture(double scale);
  QByteArray svg();

  const PlotWindow& window() const;
  int paneCount() const;
  /// The pane of the selection; -1 if it has none.
  int selectionPane() const;
  const Selection& selection() const;
  void askFor(const Selection& selection) { emit selectionRequested(selection); }
  void askFor(PlotExport what) { emit exportRequested(what); }
  PlotPane& pane(int which) const;
  /// Position of the cursor in the first pane, in pixels of this widget; for tests.
  double cursorX() const;
  /// Time and values of all drawn series, as rich text; empty without a sample.
  QString readout(double time_s) const;
  QSize minimumSizeHint() const override { return {200, 34}; }
  QSize sizeHint() const override { return {900, 150}; }

 public slots:
  /// Reads new frames of the history, moves window and cursor, and draws.
  void refresh(const abrazo::FrameHistory& history, const abrazo::Playback& playback,
               const abrazo::FrameSnapshotPtr& shown);
  /// Makes the window follow the live end or the cursor again.
  void attach();
  void zoom(double factor);
  void showSelection(const abrazo::widgets::Selection& selection);

 signals:
  void selectionRequested(const abrazo::widgets::Selection& selection);
  void seekRequested(double time_s);
  void followRequested();
  void arrangementChanged();
  /// Values of the selection are not read as far back as the rows go: to be refreshed again soon.
  void unfinished();
  void exportRequested(abrazo::widgets::PlotExport what);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  PlotPane* makePane();
  void arrangePanes();
  void draw();
  void readSelection(const FrameHistory& history);
  PlotView viewWithoutPointer() const;
  void change(PaneArrangement panes);
  void showReadout(double time_s, const QPoint& global, QWidget* pane);

  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
