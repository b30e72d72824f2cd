#pragma once

#include <QImage>
#include <QSize>
#include <array>
#include <memory>
#include <optional>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/scene/values/scene_parts.hpp"
#include "widgets/scene/values/worn_pair.hpp"

namespace abrazo::widgets {

class SceneView;

/// Off-screen pictures of recorded frames. The camera follows the pair by the frames' time: the same frames
/// in the same order give the same pictures. Keeps one picture at a time.
class ScenePictures {
 public:
  /// Setup of an off-screen scene.
  struct Look {
    std::shared_ptr<const MotionLibrary> library;  ///< radii and names of sources; may be null
    Theme theme = Theme::Dark;
    PartVisibility visibility = default_visibility;
    bool captions = false;
    WornPair characters;
    std::optional<std::array<Stance, 2>> stances;  ///< of the performers; absent: measured in the library
    /// Azimuth and elevation [rad]; absent: beside the pair, turning with it.
    std::optional<std::array<double, 2>> direction;
  };
  /// @param size  of the pictures, device pixels
  ScenePictures(QSize size, const Look& look);
  /// With the present setup of a view.
  ScenePictures(QSize size, const SceneView& like, bool captions);
  ~ScenePictures();

  /// An RGB picture of exactly the size. A null frame repeats the previous one.
  QImage picture(const FrameSnapshotPtr& frame);

 private:
  void open(QSize size);
  void begin(const FrameSnapshotPtr& frame);

  QSize m_size;
  bool m_captions;
  std::optional<Look> m_look;  ///< until the first frame
  std::unique_ptr<SceneView> m_scene;
};

/// The RGB picture scaled to fit `size`, on black.
QImage fitted(const QImage& picture, QSize size);

}  // namespace abrazo::widgets
