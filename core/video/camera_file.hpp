#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.hpp"
#include "core/video/camera_model.hpp"

namespace abrazo {

/// A camera with lens and pose as JSON: the entries of an OpenCV calibration, and `rotation` (nine numbers,
/// row by row) and `translation` (metres) of x_camera = rotation * x_world + translation.
Status write_camera(const CameraModel& camera, const std::filesystem::path& file);
Result<CameraModel> read_camera(const std::filesystem::path& file);

/// Checks that a camera is usable for overlays: a size, focal lengths above 0, a rotation, a position within
/// 100 km.
Status check_camera(const CameraModel& camera, const std::string& where);

}  // namespace abrazo
