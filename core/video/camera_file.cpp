#include "core/video/camera_file.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/base/json_text.hpp"

namespace abrazo {
namespace {

using nlohmann::json;

constexpr std::uintmax_t most_bytes = 1 << 20;
constexpr int largest_px = 65536;
constexpr double square_to = 1e-6;  // rows of a rotation, from being at right angles
constexpr double farthest_m = 1e5;

void add(JsonText& text, const char* name, std::span<const double> numbers) {
  text.key(name).begin_array();
  for (const double number : numbers) text.value(number);
  text.end_array();
}

/// This number of finite numbers, or an error that names the entry.
Result<std::vector<double>> numbers(const json& object, const char* name, std::size_t count,
                                    const std::string& where) {
  const Error wrong{std::string("\"") + name + "\" is not " + std::to_string(count) +
                        " numbers; expected a camera as Save camera… writes it",
                    where};
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array() || found->size() != count) return wrong;
  std::vector<double> values;
  for (const json& value : *found) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) return wrong;
    values.push_back(value.get<double>());
  }
  return values;
}

Result<int> pixels(const json& object, const char* name, const std::string& where) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_number_integer() || *found < 1 || *found > largest_px)
    return Error{std::string("\"") + name + "\" is not a number of pixels", where};
  return found->get<int>();
}

Result<CameraIntrinsics> intrinsics_of(const json& object, const std::string& where) {
  CameraIntrinsics lens;
  const auto width = pixels(object, "image_width", where), height = pixels(object, "image_height", where);
  if (!width) return width.error();
  if (!height) return height.error();
  const auto matrix = numbers(object, "camera_matrix", 9, where);
  if (!matrix) return matrix.error();
  const auto distortion = numbers(object, "distortion_coefficients", lens.distortion.size(), where);
  if (!distortion) return distortion.error();
  lens.width = *width;
  lens.height = *height;
  lens.fx = (*matrix)[0];
  lens.cx = (*matrix)[2];
  lens.fy = (*matrix)[4];
  lens.cy = (*matrix)[5];
  std::copy(distortion->begin(), distortion->end(), lens.distortion.begin());
  return lens;
}

Result<CameraPose> pose_of(const json& object, const std::string& where) {
  const auto rotation = numbers(object, "rotation", 9, where);
  if (!rotation) return rotation.error();
  const auto translation = numbers(object, "translation", 3, where);
  if (!translation) return translation.error();
  CameraPose pose;
  for (int i = 0; i < 9; ++i) pose.rotation(i / 3, i % 3) = (*rotation)[static_cast<std::size_t>(i)];
  for (int i = 0; i < 3; ++i) pose.translation(i) = (*translation)[static_cast<std::size_t>(i)];
  return pose;
}

}  // namespace

Status write_camera(const CameraModel& camera, const std::filesystem::path& file) {
  const CameraIntrinsics& lens = camera.intrinsics;
  JsonText text;
  text.begin_object().key("abrazo_camera").value(1);
  text.key("image_width").value(lens.width).key("image_height").value(lens.height);
  add(text, "camera_matrix",
      std::initializer_list<double>{lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1});
  add(text, "distortion_coefficients", lens.distortion);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = camera.pose.rotation;
  add(text, "rotation", std::span(rotation.data(), 9));
  add(text, "translation", std::span(camera.pose.translation.data(), 3));
  text.end_object();
  return write_whole_file(file, text.take() + "\n");
}

Result<CameraModel> read_camera(const std::filesystem::path& file) {
  std::error_code failure;
  if (std::filesystem::file_size(file, failure) > most_bytes && !failure)
    return Error{"is larger than 1 MB; a camera has less", file.string()};
  const auto content = read_whole_file(file);
  if (!content) return content.error();
  if (const char* beyond = json_beyond_bounds(*content)) return Error{beyond, file.string()};
  const json object = json::parse(*content, nullptr, false);
  if (!object.is_object())
    return Error{"is not JSON; expected a camera as Save camera… writes it", file.string()};
  const auto lens = intrinsics_of(object, file.string());
  if (!lens) return lens.error();
  const auto pose = pose_of(object, file.string());
  if (!pose) return pose.error();
  const CameraModel camera{*lens, *pose};
  if (const Status good = check_camera(camera, file.string()); !good) return good.error();
  return camera;
}

Status check_camera(const CameraModel& camera, const std::string& where) {
  const CameraIntrinsics& lens = camera.intrinsics;
  for (const int side : {lens.width, lens.height})
    if (side < 1 || side > largest_px)
      return Error{"the camera's pictures have " + std::to_string(side) +
                       " pixels on a side; expected 1 to " + std::to_string(largest_px),
                   where};
  if (!(lens.fx > 0) || !(lens.fy > 0))
    return Error{"\"camera_matrix\" has no focal lengths above 0 at its first and fifth place", where};
  const CameraPose& pose = camera.pose;
  const Eigen::Matrix3d square = pose.rotation * pose.rotation.transpose() - Eigen::Matrix3d::Identity();
  if (!(square.cwiseAbs().maxCoeff() <= square_to) || pose.rotation.determinant() < 0)
    return Error{"\"rotation\" is not a rotation: its rows are not unit vectors at right angles", where};
  if (!(pose.translation.cwiseAbs().maxCoeff() <= farthest_m))
    return Error{"\"translation\" is more than 100 km; it is in metres", where};
  return Done{};
}

}  // namespace abrazo
