#pragma once

#include <QString>
#include <functional>

#include "core/base/positions.hpp"
#include "core/base/result.hpp"
#include "core/video/camera_model.hpp"
#include "core/video/video_frame.hpp"

namespace abrazo::app {

/// A camera at a place that looks at another, with a lens that bends lines. Made by hand, not by the code
/// that is tested with it.
CameraModel looking_camera(int width, int height, double focal_px, const Vec3& from, const Vec3& at,
                           double k1 = 0);

/// Where the pinhole and its first distortion term have a point, by the textbook's formula.
Pixel seen_by(const CameraModel& camera, const Vec3& world);

struct CalibratedVideo {
  CameraModel camera;
  std::function<PairPose(double subject_s)> pose;
  double from_s = 0;  ///< of the subject: what the first picture shows
  int pictures = 50;
  double fps = 25;
};
/// Two people of sticks with white joints on a floor, and the number of each picture in its upper left
/// corner.
Status write_calibrated_video(const CalibratedVideo& video, const QString& file);

/// The number that is drawn in a picture.
int number_in(const VideoFrame& picture);

}  // namespace abrazo::app
