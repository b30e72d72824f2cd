#pragma once

#include <QSplitter>
#include <optional>

namespace abrazo::app {

class PanelArea;

/// Panels and scene above, transport and timeline below. Until a person moves the border, the timeline has
/// all its lanes as far as the panels keep the height that they need; the other lanes scroll. A chosen height
/// is kept in every size of the window.
class WorkSplit : public QSplitter {
  Q_OBJECT
 public:
  WorkSplit(PanelArea* panels, QWidget* timeline, QWidget* parent);

  /// Height of the lower part [px] as a person chose it; none = as described above.
  std::optional<int> chosenHeight() const { return m_chosen; }
  void choose(std::optional<int> height_px);
  /// For all lanes, up to half of the height.
  void makeRoomForLanes();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  PanelArea* m_panels;
  QWidget* m_timeline;
  std::optional<int> m_chosen;
};

}  // namespace abrazo::app
