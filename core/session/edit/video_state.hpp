#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/file/project.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo {

/// What a person decided about one open video: what undo goes back to and a project keeps.
struct VideoState {
  int id = 0;  ///< of the project while it is worked on, never used twice
  std::string file;
  std::string subject;  ///< a take of the library, or "" for the session
  VideoSync sync;
  /// Nothing: a field of view is guessed.
  std::optional<CameraIntrinsics> intrinsics;
  double guessed_fov_deg = 60;
  bool free_focal_length = true;      ///< found by the solution
  std::optional<CameraModel> camera;  ///< solved or loaded; nothing draws over the video without
  std::vector<PickedPoint> picked;

  bool operator==(const VideoState&) const = default;
};
using VideoStates = std::vector<VideoState>;

/// Without the reference to its file.
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
  // Estimated if not measured: the middle, square pixels, no distortion.
  state.free_focal_length = had.fx == had.fy && had.distortion == std::array<double, 8>{};
  return state;
}

}  // namespace abrazo
