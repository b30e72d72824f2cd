#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.hpp"
#include "core/video/camera_model.hpp"

namespace abrazo {

/// A camera with its lens and place as JSON: the entries of an OpenCV calibration, and beside them `rotation`
/// (nine numbers, row by row) and `translation` (metres) of x_camera = rotation * x_world + translation.
Status write_camera(const CameraModel& camera, const std::filesystem::path& file);
Result<CameraModel> read_camera(const std::filesystem::path& file);

/// Whether pictures can be drawn over with it: a size, focal lengths above 0, a rotation, a place within 100
/// km.
Status check_camera(const CameraModel& camera, const std::string& where);

}  // namespace abrazo
