#pragma once

#include <QWidget>
#include <memory>

#include "core/library/motion_library.hpp"
#include "core/session/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/scene/mesh_scalar.hpp"
#include "widgets/scene/orbit_camera.hpp"
#include "widgets/scene/scene_options.hpp"
#include "widgets/scene/scene_parts.hpp"
#include "widgets/scene/scene_pick.hpp"

namespace abrazo::widgets {

/// Both characters, the user, the selected pair and the mesh between the bodies. Renders once for each frame
/// it is shown; asks nothing of the solver.
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
  /// What is selected; stays so in other frames, also where the mesh does not have it.
  const PickedItem& picked() const;
  /// Renders once with smooth edges whatever it costs; before a picture of the window is taken.
  void renderSharp();
  /// Frames that reached the screen since the start.
  std::uint64_t renderedFrames() const;

 public slots:
  void showFrame(abrazo::FrameSnapshotPtr frame);
  /// Index into the frame's candidates; -1 shows none.
  void showCandidate(int candidate);
  void setVisibility(const abrazo::widgets::PartVisibility& visibility);
  void setScalar(abrazo::widgets::MeshScalar scalar);
  void setOptions(const abrazo::widgets::SceneOptions& options);
  /// An empty item selects nothing.
  void select(const abrazo::widgets::PickedItem& item);
  void frameAll();
  void lookFrom(double azimuth_rad, double elevation_rad);
  /// The camera's target keeps to the pair where it walks away.
  void setFollowing(bool following);

 signals:
  void countsChanged(const abrazo::widgets::PartCounts& counts);
  void visibilityChanged(const abrazo::widgets::PartVisibility& visibility);
  void optionsChanged(const abrazo::widgets::SceneOptions& options);
  void pickedChanged(const abrazo::widgets::PickedItem& item);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void wireOverlay();
  void wirePointer();
  void zoom(double notches);
  void showPart(ScenePart part, bool shown);
  void refresh();
  void render();
  void updateFacts();
  void followPair();

  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets

Q_DECLARE_METATYPE(abrazo::widgets::PickedItem)
