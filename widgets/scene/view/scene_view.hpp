#pragma once

#include <QColor>
#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/orbit_camera.hpp"
#include "widgets/scene/values/scene_options.hpp"
#include "widgets/scene/values/scene_parts.hpp"

namespace abrazo::widgets {

/// Both characters, the user, the selected pair and the mesh between the bodies. Renders once for each frame
/// it is shown; asks nothing of the solver. It asks for a selection and is given it.
class SceneView : public QWidget {
  Q_OBJECT
 public:
  /// What the graphics need to know before the QApplication is made.
  static void prepareApplication();

  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Radii of the bodies and the names of sources come from it.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  const PartVisibility& visibility() const;
  MeshScalar scalar() const;
  const OrbitCamera& camera() const;
  const SceneOptions& options() const;
  /// As it is shown; stays so in other frames, also where the mesh does not have it.
  const Selection& selection() const;
  /// What a person took out of the mesh, in the order it was hidden.
  const std::vector<Selection>& hidden() const;
  /// Which pose of the frame's way is shown, 0 the selected pair; the last is the result.
  int morphStep() const;
  /// Renders once with smooth edges whatever it costs; before a picture of the window is taken.
  void renderSharp();
  /// Drawn now, without what lies over the scene. @param background  absent: that of the colours
  QImage picture(const std::optional<QColor>& background = {});
  /// As another view shows it now, for pictures of another size: nothing to click, and the camera follows the
  /// pair by the frames' time, so that the same frames give the same pictures.
  void showAs(const SceneView& other, bool captions);
  /// Frames that reached the screen since the start.
  std::uint64_t renderedFrames() const;

 public slots:
  void showFrame(abrazo::FrameSnapshotPtr frame);
  /// Index into the frame's candidates that is pointed at elsewhere; -1 shows none.
  void showCandidate(int candidate);
  /// What other runs came to at the frame that is shown; absent: as it was recorded.
  void showComparison(const std::optional<abrazo::PairPose>& a, const std::optional<abrazo::PairPose>& b);
  /// A pair of the library that is looked at or played, where the user is; nothing shows none.
  void showRecorded(const std::optional<abrazo::PairPose>& pair);
  void showSelection(const abrazo::widgets::Selection& selection);
  void setVisibility(const abrazo::widgets::PartVisibility& visibility);
  void setScalar(abrazo::widgets::MeshScalar scalar);
  void setOptions(const abrazo::widgets::SceneOptions& options);
  /// The poses before the shown frame that trails lack, after the cursor was moved.
  void showPast(const abrazo::FrameHistory& history);
  void hideSelection();
  /// Lifts what was hidden and isolated.
  void showHidden();
  /// Goes `by` steps along the way of every frame; back to the result at its end.
  void stepMorph(int by);
  void setMorphStep(int step);
  /// Moves the cutting plane [m], and turns it where it stays in the world [rad].
  void moveCut(double by_m, double turn_rad, double tilt_rad);

  void frameAll();
  /// What is selected fills the picture; everything while nothing is.
  void frameSelection();
  /// As at the start: beside the pair.
  void resetView();
  void lookFrom(double azimuth_rad, double elevation_rad);
  /// Back to the view before, and forth again; not part of the undo of edits.
  void previousView();
  void nextView();
  /// The camera's target keeps to the pair where it walks away.
  void setFollowing(bool following);

 signals:
  void countsChanged(const abrazo::widgets::PartCounts& counts);
  void visibilityChanged(const abrazo::widgets::PartVisibility& visibility);
  void optionsChanged(const abrazo::widgets::SceneOptions& options);
  void scalarChanged(abrazo::widgets::MeshScalar scalar);
  void selectionRequested(const abrazo::widgets::Selection& selection);
  /// Index into the frame's candidates whose ghost the pointer is on; -1 when it left.
  void candidateHovered(int candidate);
  /// One more picture reached the screen, so long after it was begun.
  void pictureDrawn(double took_ms);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void wireOverlay();
  void wirePointer();
  void dragged(QPointF delta, PointerMove move);
  void handMoves();
  void wheeled(double notches);
  void zoom(double notches);
  void showPart(ScenePart part, bool shown);
  void refresh();
  void render();
  void arrange();
  void updateFacts();
  void followPair();
  void moveCamera(const OrbitCamera& to);
  void goTo(const OrbitCamera& view);
  void showGhost();
  void placeReference();
  void showAhead();
  void placeTags();

  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
