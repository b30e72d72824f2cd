#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/file/project.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo {

/// The editable state of one open video: undo restores it and a project keeps it.
struct VideoState {
  int id = 0;  ///< unique in the open project, never reused
  std::string file;
  std::string subject;  ///< a take of the library, or "" for the session
  VideoSync sync;
  /// None: a field of view is guessed.
  std::optional<CameraIntrinsics> intrinsics;
  double guessed_fov_deg = 60;
  bool free_focal_length = true;      ///< estimated by the camera solution
  std::optional<CameraModel> camera;  ///< solved or loaded; without it nothing is drawn over the video
  std::vector<PickedPoint> picked;

  bool operator==(const VideoState&) const = default;
};
using VideoStates = std::vector<VideoState>;

/// The video as a project keeps it, without the reference to its file.
inline ProjectVideo project_video(const VideoState& state) {
  return {-1, state.subject, state.sync, state.camera, state.picked};
}

inline VideoState video_state(const ProjectVideo& video, const std::string& file) {
  VideoState state;
  state.file = file;
  state.subject = video.subject;
  state.sync = video.sync;
  state.camera = video.camera;
  state.picked = video.picked;
  if (!video.camera) return state;
  const CameraIntrinsics& had = video.camera->intrinsics;
  state.intrinsics = had;
  // Estimated, not measured: centred principal point, square pixels, no distortion.
  state.free_focal_length = had.fx == had.fy && had.distortion == std::array<double, 8>{};
  return state;
}

}  // namespace abrazo
