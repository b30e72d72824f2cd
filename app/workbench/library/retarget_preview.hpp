#pragma once

#include <QWidget>

#include "app/workbench/library/retargeted_frames.hpp"
#include "app/workbench/shell/frame_ticker.hpp"
#include "widgets/common/palette.hpp"

class QButtonGroup;
class QLabel;

namespace abrazo::widgets {
class SceneView;
class TimelineView;
class TransportBar;
}  // namespace abrazo::widgets

namespace abrazo::app {

/// A recorded pair beside the same pair on other bodies: scene, A/B, transport and ruler. Shows what it is
/// given.
class RetargetPreview : public QWidget {
  Q_OBJECT
 public:
  /// A = the recording, B = on the other bodies; Both = B with A as dashed lines.
  enum class Side { Recording, Both, Retargeted };

  explicit RetargetPreview(QWidget* parent);
  ~RetargetPreview() override;
  void setColours(const widgets::Palette& palette);

  /// Another recording begins to play at its beginning, with these radii and names; null = nothing is shown.
  void showRecording(const PreviewedPair& pair, std::shared_ptr<const MotionLibrary> library);
  /// The same recording with other pieces, at the same place.
  void showPieces(const PreviewedPair& pair);
  void showNothing();
  /// One line below: figures, progress or an error.
  void showState(const QString& text);

  Side side() const { return m_side; }
  void setSide(Side side);
  FrameTicker& ticker() { return m_ticker; }
  widgets::SceneView& scene() { return *m_scene; }

 private:
  QWidget* makeSides();
  void wire();
  void addKeys();
  void lookAt();
  void showFrame(const FrameSnapshotPtr& frame);

  widgets::SceneView* m_scene;
  widgets::TransportBar* m_transport;
  widgets::TimelineView* m_ruler;
  QLabel* m_state;
  QButtonGroup* m_sides;
  Side m_side = Side::Both;
  PreviewedPair m_pair;
  FrameSnapshotPtr m_inScene;
  FrameHistory m_history;
  LatestSlot<FrameSnapshot> m_latest;  ///< stays empty: a take has no live end
  FrameTicker m_ticker;                // last: reads the others
};

}  // namespace abrazo::app
