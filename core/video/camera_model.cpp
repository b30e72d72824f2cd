#include "core/video/camera_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/video/lens.hpp"

namespace abrazo {
namespace {

constexpr double nearest_m = 0.01;
constexpr double flat_px = 0.45;  // of the half pixel that is promised; the rest is for what lies between
constexpr int least_depth = 2, most_depth = 10;

/// The pixels of a straight line in the camera's space, piece by piece.
class CurveInPicture {
 public:
  CurveInPicture(const Lens& lens, const Vec3& from, const Vec3& to) : lens_(lens), from_(from), to_(to) {}

  std::vector<std::vector<Pixel>> pieces() {
    add(0, at(0), 1, at(1), 0);
    close();
    return std::move(pieces_);
  }

 private:
  using End = std::optional<Pixel>;
  End at(double t) const { return lens_.project(from_ + t * (to_ - from_)); }

  static double distance_px(const Pixel& point, const Pixel& a, const Pixel& b) {
    const Pixel along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0;
    return (point - a - t * along).norm();
  }

  bool is_flat(double t0, const Pixel& p0, double t1, const Pixel& p1) const {
    for (const double part : {0.25, 0.5, 0.75}) {
      const End between = at(t0 + part * (t1 - t0));
      if (!between || distance_px(*between, p0, p1) > flat_px) return false;
    }
    return true;
  }

  void add(double t0, const End& p0, double t1, const End& p1, int depth) {
    const int least = lens_.is_straight() ? 0 : least_depth;
    if (p0 && p1 && depth >= least && (depth == most_depth || is_flat(t0, *p0, t1, *p1)))
      return append(*p0, *p1);
    if (depth == most_depth) return close();
    if (!p0 && !p1 && depth > least_depth + 2) return close();
    const double middle = 0.5 * (t0 + t1);
    const End between = at(middle);
    add(t0, p0, middle, between, depth + 1);
    add(middle, between, t1, p1, depth + 1);
  }

  void append(const Pixel& from, const Pixel& to) {
    if (open_.empty()) open_.push_back(from);
    open_.push_back(to);
  }

  void close() {
    if (!open_.empty()) pieces_.push_back(std::move(open_));
    open_.clear();
  }

  const Lens& lens_;
  Vec3 from_, to_;
  std::vector<Pixel> open_;
  std::vector<std::vector<Pixel>> pieces_;
};

}  // namespace

// ---- lens

Lens::Lens(const CameraIntrinsics& intrinsics) : intrinsics_(intrinsics) {
  is_straight_ = std::ranges::all_of(intrinsics.distortion, [](double k) { return k == 0; });
  if (is_straight_) return;
  // The first radius at which a ray farther out is not seen farther out any more.
  constexpr double step = 0.02, farthest = 5;  // 79 degrees off the axis
  largest_radius_ = farthest;
  for (double r = step; r <= farthest; r += step) {
    if (outward(r) > 0) continue;
    largest_radius_ = r - step;
    return;
  }
}

Lens::Radial Lens::radial(double r2) const {
  const auto& k = intrinsics_.distortion;
  const double up = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
  const double down = 1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]));
  const double up_slope = k[0] + r2 * (2 * k[1] + r2 * 3 * k[4]);
  const double down_slope = k[5] + r2 * (2 * k[6] + r2 * 3 * k[7]);
  return {up / down, (up_slope * down - up * down_slope) / (down * down), down};
}

double Lens::outward(double r) const {
  const Radial f = radial(r * r);
  return f.down <= 0 ? -1 : f.factor + 2 * r * r * f.slope;
}

Pixel Lens::distorted(double x, double y) const {
  const auto& k = intrinsics_.distortion;
  if (!is_straight_) {
    const double r2 = x * x + y * y, f = radial(r2).factor;
    const double dx = x * f + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x);
    const double dy = y * f + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y;
    x = dx;
    y = dy;
  }
  return {intrinsics_.fx * x + intrinsics_.cx, intrinsics_.fy * y + intrinsics_.cy};
}

std::optional<Pixel> Lens::project(const Vec3& in_camera) const {
  if (in_camera.z() < nearest_m) return {};
  const double x = in_camera.x() / in_camera.z(), y = in_camera.y() / in_camera.z();
  if (x * x + y * y > largest_radius_ * largest_radius_) return {};
  return distorted(x, y);
}

// ---- model

std::optional<Pixel> CameraModel::project(const Vec3& world) const {
  return Lens(intrinsics).project(pose.rotation * world + pose.translation);
}

std::vector<std::vector<Pixel>> CameraModel::project_segment(const Vec3& from, const Vec3& to) const {
  Vec3 a = pose.rotation * from + pose.translation;
  Vec3 b = pose.rotation * to + pose.translation;
  if (a.z() < nearest_m && b.z() < nearest_m) return {};
  const auto cut = [](const Vec3& behind, const Vec3& ahead) {
    Vec3 at = behind + (nearest_m - behind.z()) / (ahead.z() - behind.z()) * (ahead - behind);
    at.z() = nearest_m;
    return at;
  };
  if (a.z() < nearest_m) a = cut(a, b);
  if (b.z() < nearest_m) b = cut(b, a);
  const Lens lens(intrinsics);
  return CurveInPicture(lens, a, b).pieces();
}

// ---- intrinsics

Result<CameraIntrinsics> scaled(const CameraIntrinsics& intrinsics, int width, int height) {
  constexpr double tolerance = 0.01;
  if (width <= 0 || height <= 0 || intrinsics.width <= 0 || intrinsics.height <= 0)
    throw std::invalid_argument("scaled: pictures without a size");
  const double across = static_cast<double>(width) / intrinsics.width;
  const double down = static_cast<double>(height) / intrinsics.height;
  if (std::abs(across / down - 1) > tolerance)
    return Error{fmt::format("the calibration is for {} x {}, the video is {} x {}: other proportions, so it "
                             "was cropped or turned since; calibrate with videos of this shape",
                             intrinsics.width, intrinsics.height, width, height),
                 ""};
  CameraIntrinsics result = intrinsics;
  result.width = width;
  result.height = height;
  result.fx *= across;
  result.fy *= down;
  // The corner of the picture stays its corner; (0, 0) is the middle of a pixel.
  result.cx = (intrinsics.cx + 0.5) * across - 0.5;
  result.cy = (intrinsics.cy + 0.5) * down - 0.5;
  return result;
}

CameraIntrinsics guessed_intrinsics(int width, int height, double horizontal_deg) {
  if (width <= 0 || height <= 0 || !(horizontal_deg > 0) || !(horizontal_deg < 180))
    throw std::invalid_argument("guessed_intrinsics: no such picture");
  const double focal = 0.5 * width / std::tan(horizontal_deg * std::numbers::pi / 360);
  return {width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1), {}};
}

}  // namespace abrazo
