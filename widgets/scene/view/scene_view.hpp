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
#include "widgets/scene/values/scene_memory.hpp"
#include "widgets/scene/values/scene_options.hpp"
#include "widgets/scene/values/scene_parts.hpp"
#include "widgets/scene/values/worn_pair.hpp"

namespace abrazo::widgets {

class ScalarLegend;

/// Both characters, the user, the selected pair and the mesh between the bodies. Renders once per shown
/// frame; requests nothing of the solver. Requests selections and shows the given one.
class SceneView : public QWidget {
  Q_OBJECT
 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Provides radii of the bodies and names of sources.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  /// The same takes with other labels, or with more takes: the view and the ranges stay.
  void extendLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  /// Skins for the characters instead of capsules.
  /// @param stances  of the two performers; absent: measured in the library
  void setCharacters(const WornPair& characters,
                     const std::optional<std::array<Stance, 2>>& stances = std::nullopt);
  const WornPair& characters() const;
  const PartVisibility& visibility() const;
  MeshScalar scalar() const;
  /// Whether the bodies of a comparison are there.
  bool showsComparison() const;
  const OrbitCamera& camera() const;
  const SceneOptions& options() const;
  /// The setup, to be kept as text.
  SceneMemory memory() const;
  void setMemory(const SceneMemory& memory);
  /// The shown selection; it persists in other frames, even if their mesh does not have it.
  const Selection& selection() const;
  /// Hidden items of the mesh, in order of hiding.
  const std::vector<Selection>& hidden() const;
  /// The shown morph step: 0 = selected pair; the last = result.
  int morphStep() const;
  /// Renders once with anti-aliasing regardless of cost; before a screenshot.
  void renderSharp();
  /// A new picture without overlays. @param background absent: from the palette
  QImage picture(const std::optional<QColor>& background = {});
  /// Copies the setup of another view, for pictures of another size, and becomes a picture.
  void showAs(const SceneView& other, bool captions);
  /// No interaction, a camera that has arrived, and that follows the pair by the frames' time: the same
  /// frames give the same pictures.
  void becomePicture(bool captions);
  /// Part of the view where bars may come and go: they cover no control there.
  QRect noticeRoom() const;
  /// Frames that reached the screen since the start.
  std::uint64_t renderedFrames() const;

 public slots:
  void showFrame(abrazo::FrameSnapshotPtr frame);
  /// The candidate hovered in another view, index into the frame's; -1 = none.
  void showCandidate(int candidate);
  /// Results of other runs at the shown frame; absent: as recorded.
  void showComparison(const std::optional<abrazo::PairPose>& a, const std::optional<abrazo::PairPose>& b);
  /// A browsed or played library pair, placed at the user; none shows none.
  void showRecorded(const std::optional<abrazo::PairPose>& pair);
  void showSelection(const abrazo::widgets::Selection& selection);
  void setVisibility(const abrazo::widgets::PartVisibility& visibility);
  void setScalar(abrazo::widgets::MeshScalar scalar);
  void setOptions(const abrazo::widgets::SceneOptions& options);
  /// Opens a field for the range of the legend.
  void askRange();
  /// Fills the trails with poses before the shown frame, after the cursor was moved.
  void showPast(const abrazo::FrameHistory& history);
  void hideSelection();
  /// Shows hidden items again and ends isolation.
  void showHidden();
  /// Moves by `by` morph steps in every frame; at the end returns to the result.
  void stepMorph(int by);
  void setMorphStep(int step);
  /// As set by a person: changes of the cutting plane can be taken back.
  void edit(const abrazo::widgets::SceneOptions& options);
  /// The cutting plane of these options, exactly as it was there.
  void restoreCut(const abrazo::widgets::SceneOptions& options);
  /// A range of the legend, exactly as it was there.
  void restoreRange(const abrazo::widgets::LegendRange& range);
  /// Moves the cutting plane [m], and rotates a plane fixed in the world [rad].
  void moveCut(double by_m, double turn_rad, double tilt_rad);

  void frameAll();
  /// Distance of the camera, or of where it is moving to, over the one from which bodies with these joints
  /// fit into the picture, clear of the controls over it: 1 right after frameAll().
  double roomFor(const PairPose& pair) const;
  /// Fits the selection into the picture; everything without a selection.
  void frameSelection();
  /// The initial view: beside the pair.
  void resetView();
  void lookFrom(double azimuth_rad, double elevation_rad);
  /// Previous and next view; not part of undo.
  void previousView();
  void nextView();
  /// Makes the camera's target follow the pair.
  void setFollowing(bool following);

 signals:
  /// The controls over the picture were placed.
  void arranged();
  void countsChanged(const abrazo::widgets::PartCounts& counts);
  void visibilityChanged(const abrazo::widgets::PartVisibility& visibility);
  void optionsChanged(const abrazo::widgets::SceneOptions& options);
  /// A person moved or turned the cutting plane. @param edit  number of the edit: of one drag, or of changes
  /// that follow each other quickly
  void cutEdited(const abrazo::widgets::SceneOptions& before, const abrazo::widgets::SceneOptions& after,
                 int edit);
  /// A person set a range of the legend, or whether it adapts.
  void rangeEdited(const abrazo::widgets::LegendRange& before, const abrazo::widgets::LegendRange& after);
  void scalarChanged(abrazo::widgets::MeshScalar scalar);
  void selectionRequested(const abrazo::widgets::Selection& selection);
  /// The candidate whose ghost is hovered, index into the frame's; -1 = the pointer left.
  void candidateHovered(int candidate);
  /// A picture of this frame, which may be null, reached the screen `took_ms` after its start. Another frame
  /// may be shown by then.
  void pictureDrawn(abrazo::FrameSnapshotPtr frame, double took_ms);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void wireOverlay();
  LegendRange shownRange(const ScalarLegend* legend) const;
  void editRange(const LegendRange& after);
  void wirePointer();
  void dragged(QPointF delta, PointerMove move);
  void applyOptions(const SceneOptions& wanted);
  void wireCut();
  bool takeCut(QPointF place);
  void pullCut(QPointF place);
  void letGoOfCut();
  bool leaveCutDrag();
  bool pointAtCut(QPointF place);
  void placeCutHandles();
  void handMoves();
  void wheeled(double notches);
  void zoom(double notches);
  void showPart(ScenePart part, bool shown);
  void refresh();
  void dressCharacters();
  void render();
  void arrange();
  void placeCards();
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
