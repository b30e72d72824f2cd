#pragma once

#include <QSplitter>
#include <optional>

namespace abrazo::widgets {
class TimelineView;
}

namespace abrazo::app {

class PanelArea;

/// Panels and scene above, transport and timeline below. Until a person moves the border, the timeline has
/// all its lanes as far as the panels keep the height that they need, and three where the panels lack it
/// anyway; no lane is cut, the other lanes scroll. A chosen height is kept in every size of the window.
class WorkSplit : public QSplitter {
  Q_OBJECT
 public:
  /// @param timeline  the lower part, with `lanes` in it
  WorkSplit(PanelArea* panels, QWidget* timeline, const widgets::TimelineView* lanes, QWidget* parent);

  /// Height of the lower part [px] as a person chose it; none = as described above.
  std::optional<int> chosenHeight() const { return m_chosen; }
  void choose(std::optional<int> height_px);
  /// For all lanes, up to half of the height, as long as there are lanes of labels. The chosen height comes
  /// back.
  void makeRoomForLanes();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  int heightFor(double lanes_px) const;
  int withWholeLanes(int below) const;

  PanelArea* m_panels;
  QWidget* m_timeline;
  const widgets::TimelineView* m_lanes;
  std::optional<int> m_chosen;
  bool m_labels = false;  ///< room for the lanes of labels was asked for
};

}  // namespace abrazo::app
