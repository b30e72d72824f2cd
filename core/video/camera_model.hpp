#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/positions.hpp"
#include "core/base/result.hpp"

namespace abrazo {

using Pixel =
    Eigen::Vector2d;  ///< x to the right, y down, of the upright picture; the middle of the first is (0, 0)

/// Pinhole with Brown's distortion, as in OpenCV: k1 k2 p1 p2 k3 k4 k5 k6 (unused ones are 0).
struct CameraIntrinsics {
  int width = 0, height = 0;  ///< of the pictures
  double fx = 0, fy = 0, cx = 0, cy = 0;
  std::array<double, 8> distortion{};

  bool operator==(const CameraIntrinsics&) const = default;
};

/// Pose of a camera: x_camera = rotation * x_world + translation; camera axes x right, y down, z ahead; world
/// metres, Y up.
struct CameraPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();

  Vec3 position() const { return -rotation.transpose() * translation; }
  bool operator==(const CameraPose& other) const {
    return rotation == other.rotation && translation == other.translation;
  }
};

struct CameraModel {
  CameraIntrinsics intrinsics;
  CameraPose pose;

  /// None for points behind the camera, or so far outside that the distortion folds back.
  std::optional<Pixel> project(const Vec3& world) const;
  /// A straight bone in the world is a curve in a distorted picture: its pixels, subdivided so that the
  /// polyline deviates by at most half a pixel; in several pieces if it passes behind the camera.
  std::vector<std::vector<Pixel>> project_segment(const Vec3& from, const Vec3& to) const;

  bool operator==(const CameraModel&) const = default;
};

/// OpenCV's calibration files (YAML, XML, JSON with camera_matrix, distortion_coefficients, image_width,
/// image_height). The error names the file, the entry and what was expected.
Result<CameraIntrinsics> read_intrinsics(const std::filesystem::path& file);
Status write_intrinsics(const CameraIntrinsics& intrinsics, const std::filesystem::path& file);
/// Intrinsics for pictures of another size of the same camera; an Error if the aspect ratios differ by more
/// than 1 %.
Result<CameraIntrinsics> scaled(const CameraIntrinsics& intrinsics, int width, int height);
/// Intrinsics without a calibration: central principal point, square pixels, this horizontal field of view.
CameraIntrinsics guessed_intrinsics(int width, int height, double horizontal_deg = 60);

/// A joint picked in a picture.
struct PickedPoint {
  Vec3 world;
  Pixel pixel;
  int vertex = -1;       ///< joint of the pair, 0..49; -1 = unknown
  double subject_s = 0;  ///< time of the joint

  bool operator==(const PickedPoint& other) const {
    return world == other.world && pixel == other.pixel && vertex == other.vertex &&
           subject_s == other.subject_s;
  }
};

struct SolvedCamera {
  CameraModel camera;
  std::vector<double> errors_px;      ///< per point: distance of the picked and the projected position
  std::vector<bool> used;             ///< true for inliers
  double rms_px = 0;                  ///< over the used ones
  std::vector<std::string> warnings;  ///< nearly coplanar points, all points in one corner, camera below the
                                      ///< floor
};

/// The camera's pose from at least 6 picked points (robust against a few wrong ones; refined).
/// @param free_focal_length estimates fx = fy too, with at least 8 points; for guessed intrinsics
Result<SolvedCamera> solve_camera(const CameraIntrinsics& intrinsics, std::span<const PickedPoint> points,
                                  bool free_focal_length);

}  // namespace abrazo
