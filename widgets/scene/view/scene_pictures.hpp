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

namespace abrazo::widgets {

class SceneView;

/// Pictures of recorded frames, drawn off the screen in a scene of their own size. The camera follows the
/// pair by the frames' time: the same frames in the same order give the same pictures. One picture at a time
/// is kept.
class ScenePictures {
 public:
  /// How a scene is set up that no window shows.
  struct Look {
    std::shared_ptr<const MotionLibrary> library;  ///< radii and names of sources; may be null
    Theme theme = Theme::Dark;
    PartVisibility visibility = default_visibility;
    bool captions = false;
    /// Azimuth and elevation [rad]; absent: beside the pair, turning with it.
    std::optional<std::array<double, 2>> direction;
  };
  /// @param size  of the pictures, device pixels
  ScenePictures(QSize size, const Look& look);
  /// As a view shows its scene now.
  ScenePictures(QSize size, const SceneView& like, bool captions);
  ~ScenePictures();

  /// Of exactly the size: red, green, blue. Null shows the frame before once more.
  QImage picture(const FrameSnapshotPtr& frame);

 private:
  void open(QSize size);
  void begin(const FrameSnapshotPtr& frame);

  QSize m_size;
  bool m_captions;
  std::optional<Look> m_look;  ///< until the first frame is there to look at
  std::unique_ptr<SceneView> m_scene;
};

/// The picture within `size`, whole, as large as it fits, on black: red, green, blue.
QImage fitted(const QImage& picture, QSize size);

}  // namespace abrazo::widgets
