#pragma once

// Implementation parts of SceneView; for its sources only.

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/motion/body/joint_set.hpp"
#include "widgets/common/value_range.hpp"
#include "widgets/scene/actors/gl_surface.hpp"
#include "widgets/scene/actors/scene_stage.hpp"
#include "widgets/scene/panel/morph_strip.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/panel/scene_overlay.hpp"
#include "widgets/scene/pick/scene_picker.hpp"
#include "widgets/scene/values/camera_move.hpp"
#include "widgets/scene/values/pair_camera.hpp"
#include "widgets/scene/values/smoothing_budget.hpp"
#include "widgets/scene/view/cut_handle_layer.hpp"
#include "widgets/scene/view/depth_tags.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets {

/// Hands of both bodies, with trails while no joint is selected.
inline constexpr std::array<int, 4> hands = {
    joints::left_hand, joints::right_hand, joint_count + joints::left_hand, joint_count + joints::right_hand};

/// The cutting plane in the hand.
struct CutDrag {
  CutGrip grip;
  SceneOptions before;
  QPointF from, offset;  ///< the pointer at first, and the knob from there
};

struct SceneView::Parts {
  explicit Parts(SceneView* view)
      : surface(new GlSurface(view)), stage(*surface), picker(view, stage), tags(view) {}

  GlSurface* surface;
  SceneStage stage;
  ScenePicker picker;
  DepthTags tags;
  SceneActors& actors = stage.actors;
  OrbitCamera& camera = stage.camera;
  PairCamera pair_camera;
  ScalarChips* chips = nullptr;
  ScalarLegend *legend = nullptr, *cell_legend = nullptr;
  FrameFacts* facts = nullptr;
  MorphStrip* morph = nullptr;
  Palette palette = palette_of(Theme::Dark);
  PartVisibility visibility = default_visibility;
  PartCounts counts{};
  SceneOptions options;
  CutHandleLayer* cut_layer = nullptr;
  std::optional<CutDrag> cut_drag;
  CutGrip cut_hovered = CutGrip::None;
  int cut_edit = 0;  ///< number of the last edit of the plane
  QElapsedTimer since_cut;
  std::vector<Selection> hidden;
  MeshScalar scalar = MeshScalar::Residual;
  std::array<SteadyRange, mesh_scalar_count> ranges;
  SteadyRange cell_range, width_range;
  WornPair characters;
  std::optional<std::array<Stance, 2>> stances;  ///< absent: those of the library
  FrameSnapshotPtr frame;                        ///< as solved
  FrameSnapshotPtr shown;                        ///< at the shown morph step
  std::optional<int> step;
  std::shared_ptr<const MotionLibrary> library;
  std::optional<PairPose> recorded;           ///< of the library, browsed or played
  int candidate = -1;                         ///< hovered in another view
  int told_candidate = -1;                    ///< hovered ghost in this view
  std::uint64_t past_of = ~std::uint64_t{0};  ///< frame for which trails were last filled from the past
  double past_length_s = 0;
  bool following = true;
  bool by_frame_time = false;        ///< follow by the frames' time, not by the clock
  std::optional<double> followed_s;  ///< time of the last followed frame
  bool framed = false;
  std::optional<CameraMove> move;
  CameraHistory views;
  QElapsedTimer since_move, since_hand;
  QTimer move_timer;
  Vec3 reference_offset = Vec3::Zero();
  std::uint64_t rendered = 0;
  SmoothingBudget budget;
  QElapsedTimer since_render, since_follow;
  QTimer standstill;  ///< expires if no picture follows one without anti-aliasing

  void makeRoom(bool narrow);
  MeshLook look();
  void applyCut();
  std::optional<CutHandles> cutHandles() const;
  SteadyRange& range() { return ranges[static_cast<std::size_t>(scalar)]; }
  bool shows(ScenePart part) const { return visibility[static_cast<std::size_t>(part)]; }
  /// Of the picture without the controls over it: all of its width in a narrow one, see `arrange`.
  PictureShape shape() const {
    constexpr double overlays_px = 72;  // the chips above; the facts are beside the pair
    const double height = std::max(1, surface->height()),
                 covered_px = narrow_overlays_px.value_or(overlays_px);
    return {surface->width() / height, std::clamp(1 - covered_px / height, 0.4, 0.84)};
  }
  std::optional<int>
      narrow_overlays_px;  ///< height of the controls above and below the pair of a narrow view
};

}  // namespace abrazo::widgets
