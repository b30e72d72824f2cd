#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "core/video/camera_model.hpp"
#include "core/video/lens.hpp"

namespace abrazo {
namespace {

constexpr std::size_t least_points = 6, least_points_for_focal = 8;
constexpr int ransac_rounds = 2000;
constexpr double ransac_confidence = 0.999;
constexpr double behind_px = 1e6;  ///< error of a point behind the camera

/// Farther than this from where it is projected, a point was picked wrongly [pixels].
double outlier_px(const CameraIntrinsics& intrinsics) {
  return std::max(4.0, 0.006 * std::hypot(intrinsics.width, intrinsics.height));
}

std::vector<double> errors_of(const CameraModel& camera, std::span<const PickedPoint> points) {
  std::vector<double> errors;
  const Lens lens(camera.intrinsics);
  for (const PickedPoint& point : points) {
    const auto pixel = lens.project(camera.pose.rotation * point.world + camera.pose.translation);
    errors.push_back(pixel ? (*pixel - point.pixel).norm() : behind_px);
  }
  return errors;
}

std::vector<bool> within(const std::vector<double>& errors, double limit_px) {
  std::vector<bool> used;
  for (const double error : errors) used.push_back(error <= limit_px);
  return used;
}

std::size_t count(const std::vector<bool>& used) {
  return static_cast<std::size_t>(std::ranges::count(used, true));
}

/// Squared error, limited for outliers.
double robust_cost(const std::vector<double>& errors, double limit_px) {
  double cost = 0;
  for (const double error : errors) cost += std::min(error * error, limit_px * limit_px);
  return cost;
}

// ---- refinement: Levenberg and Marquardt on turn, shift and (where it is free) the focal length

using Step = Eigen::VectorXd;

CameraModel moved(const CameraModel& camera, const Step& by) {
  CameraModel result = camera;
  const Vec3 turn = by.head<3>();
  if (const double angle = turn.norm(); angle > 0)
    result.pose.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * camera.pose.rotation;
  result.pose.translation += by.segment<3>(3);
  if (by.size() > 6) {
    result.intrinsics.fx *= std::exp(by(6));
    result.intrinsics.fy *= std::exp(by(6));
  }
  return result;
}

/// Differences in x and y of the used points, one after the other.
Eigen::VectorXd differences(const CameraModel& camera, std::span<const PickedPoint> points,
                            const std::vector<bool>& used) {
  std::vector<double> values;
  const Lens lens(camera.intrinsics);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!used[i]) continue;
    const auto pixel = lens.project(camera.pose.rotation * points[i].world + camera.pose.translation);
    const Pixel difference = pixel ? Pixel(*pixel - points[i].pixel) : Pixel(behind_px, behind_px);
    values.insert(values.end(), {difference.x(), difference.y()});
  }
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::MatrixXd slopes(const CameraModel& camera, std::span<const PickedPoint> points,
                       const std::vector<bool>& used, Eigen::Index freedoms) {
  constexpr double nudge = 1e-6;
  Eigen::MatrixXd result(2 * static_cast<Eigen::Index>(count(used)), freedoms);
  for (Eigen::Index f = 0; f < freedoms; ++f) {
    Step by = Step::Zero(freedoms);
    by(f) = nudge;
    const Eigen::VectorXd ahead = differences(moved(camera, by), points, used);
    by(f) = -nudge;
    result.col(f) = (ahead - differences(moved(camera, by), points, used)) / (2 * nudge);
  }
  return result;
}

CameraModel refined(CameraModel camera, std::span<const PickedPoint> points, const std::vector<bool>& used,
                    bool free_focal_length) {
  constexpr int rounds = 60;
  const Eigen::Index freedoms = free_focal_length ? 7 : 6;
  double damping = 1e-3;
  Eigen::VectorXd off = differences(camera, points, used);
  for (int round = 0; round < rounds && damping < 1e12; ++round) {
    const Eigen::MatrixXd by_step = slopes(camera, points, used, freedoms);
    Eigen::MatrixXd normal = by_step.transpose() * by_step;
    normal.diagonal() *= 1 + damping;
    const Step step = -normal.ldlt().solve(by_step.transpose() * off);
    if (!step.allFinite()) break;
    const CameraModel next = moved(camera, step);
    const Eigen::VectorXd next_off = differences(next, points, used);
    if (!(next_off.squaredNorm() < off.squaredNorm())) {
      damping *= 10;
      continue;
    }
    const bool is_settled = off.squaredNorm() - next_off.squaredNorm() < 1e-12 * off.squaredNorm();
    camera = next;
    off = next_off;
    damping /= 10;
    if (is_settled) break;
  }
  return camera;
}

/// Which points are used changes with the camera: a few rounds settle it.
CameraModel settled(CameraModel camera, std::span<const PickedPoint> points, bool free_focal_length) {
  const double limit_px = outlier_px(camera.intrinsics);
  const std::size_t least = free_focal_length ? least_points_for_focal : least_points;
  for (int round = 0; round < 5; ++round) {
    const std::vector<bool> used = within(errors_of(camera, points), limit_px);
    if (count(used) < least) return camera;
    camera = refined(camera, points, used, free_focal_length);
    if (within(errors_of(camera, points), limit_px) == used) break;
  }
  return camera;
}

// ---- a first pose

std::optional<CameraModel> posed(const CameraIntrinsics& intrinsics, std::span<const PickedPoint> points,
                                 double limit_px) {
  std::vector<cv::Point3d> world;
  std::vector<cv::Point2d> pixels;
  for (const PickedPoint& point : points) {
    world.emplace_back(point.world.x(), point.world.y(), point.world.z());
    pixels.emplace_back(point.pixel.x(), point.pixel.y());
  }
  const cv::Matx33d matrix(intrinsics.fx, 0, intrinsics.cx, 0, intrinsics.fy, intrinsics.cy, 0, 0, 1);
  const cv::Mat distortion(1, 8, CV_64F, const_cast<double*>(intrinsics.distortion.data()));
  try {
    cv::Vec3d turn, shift;
    if (!cv::solvePnPRansac(world, pixels, matrix, distortion, turn, shift, false, ransac_rounds,
                            static_cast<float>(limit_px), ransac_confidence, cv::noArray(),
                            cv::SOLVEPNP_SQPNP))
      return {};
    cv::Matx33d rotation;
    cv::Rodrigues(turn, rotation);
    CameraModel camera{intrinsics, {}};
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) camera.pose.rotation(r, c) = rotation(r, c);
    camera.pose.translation = Vec3(shift[0], shift[1], shift[2]);
    if (!camera.pose.rotation.allFinite() || !camera.pose.translation.allFinite()) return {};
    return camera;
  } catch (const cv::Exception&) {
    return {};
  }
}

/// The best of those to start from: one, or with a free focal length one for each of some fields of view.
std::optional<CameraModel> best_start(const CameraIntrinsics& intrinsics, std::span<const PickedPoint> points,
                                      bool free_focal_length) {
  std::vector<double> focals = {intrinsics.fx};
  if (free_focal_length)
    for (double deg = 20; deg <= 110; deg += 10)
      focals.push_back(0.5 * intrinsics.width / std::tan(deg * std::numbers::pi / 360));
  const double limit_px = outlier_px(intrinsics);
  std::optional<CameraModel> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double focal : focals) {
    CameraIntrinsics tried = intrinsics;
    tried.fy *= focal / tried.fx;
    tried.fx = focal;
    // A wrong focal length alone makes all points miss; wide at first, the refinement then sorts them.
    auto camera = posed(tried, points, free_focal_length ? 2.5 * limit_px : limit_px);
    if (!camera) continue;
    *camera = settled(*camera, points, free_focal_length);
    const double cost = robust_cost(errors_of(*camera, points), limit_px);
    if (cost < least) {
      least = cost;
      best = camera;
    }
  }
  return best;
}

// ---- what to be careful with

std::vector<PickedPoint> those_used(std::span<const PickedPoint> points, const std::vector<bool>& used) {
  std::vector<PickedPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (used[i]) result.push_back(points[i]);
  return result;
}

/// Lengths of the point cloud along its principal axes, the longest first.
Vec3 extents(const std::vector<PickedPoint>& points) {
  Positions cloud(static_cast<Eigen::Index>(points.size()), 3);
  for (Eigen::Index i = 0; i < cloud.rows(); ++i) cloud.row(i) = points[static_cast<std::size_t>(i)].world;
  cloud.rowwise() -= cloud.colwise().mean().eval();
  const Eigen::Matrix3d spread = cloud.transpose() * cloud / static_cast<double>(points.size());
  const Vec3 ascending =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues().cwiseMax(0).cwiseSqrt();
  return ascending.reverse();
}

void warn_of_points(SolvedCamera& solved, const std::vector<PickedPoint>& points) {
  const Vec3 lengths = extents(points);
  if (lengths.y() < 0.05 * lengths.x())
    solved.warnings.push_back("the points are nearly on a line; pick some to the side of it");
  else if (lengths.z() < 0.05 * lengths.x())
    solved.warnings.push_back(
        "the points are nearly in a plane; pick some nearer to the camera or farther from it");
  Eigen::AlignedBox2d box;
  for (const PickedPoint& point : points) box.extend(point.pixel);
  const CameraIntrinsics& in = solved.camera.intrinsics;
  if (box.sizes().x() < 0.25 * in.width && box.sizes().y() < 0.25 * in.height)
    solved.warnings.push_back(
        "the points are all in one part of the picture; pick some elsewhere, also at other times");
}

/// How far the camera may be off where points are picked no better than they fit, or than a hand does (1
/// pixel), by linear propagation.
void warn_of_doubt(SolvedCamera& solved, const std::vector<PickedPoint>& points, bool free_focal_length) {
  const Eigen::Index freedoms = free_focal_length ? 7 : 6;
  const std::vector<bool> all(points.size(), true);
  const Eigen::MatrixXd by_step = slopes(solved.camera, points, all, freedoms);
  const double spare = static_cast<double>(by_step.rows() - freedoms);
  const double pixel =
      std::max(1.0, solved.rms_px * std::sqrt(0.5 * static_cast<double>(by_step.rows()) / spare));
  const Eigen::MatrixXd covariance =
      (by_step.transpose() * by_step).ldlt().solve(Eigen::MatrixXd::Identity(freedoms, freedoms));
  // The place is -R' t: turning swings it about the points.
  Eigen::Matrix<double, 3, 6> of_place;
  const Vec3& t = solved.camera.pose.translation;
  of_place << 0, -t.z(), t.y(), 1, 0, 0, t.z(), 0, -t.x(), 0, 1, 0, -t.y(), t.x(), 0, 0, 0, 1;
  const double shift_m =
      pixel * std::sqrt((of_place * covariance.topLeftCorner<6, 6>() * of_place.transpose()).trace());
  const double distance_m = std::max(0.1, solved.camera.pose.translation.norm());
  if (!(shift_m < 0.1 * distance_m))
    solved.warnings.push_back(fmt::format(
        "the camera's place is uncertain by about {:.2g} m; pick more points, far apart", shift_m));
  if (free_focal_length && !(pixel * std::sqrt(covariance(6, 6)) < 0.1))
    solved.warnings.push_back(
        fmt::format("the focal length is uncertain by about {:.0f} %; pick points at other distances",
                    100 * pixel * std::sqrt(covariance(6, 6))));
}

void warn(SolvedCamera& solved, std::span<const PickedPoint> points, bool free_focal_length) {
  const std::vector<PickedPoint> used = those_used(points, solved.used);
  if (const std::size_t left = points.size() - used.size(); left > 0)
    solved.warnings.push_back(
        fmt::format("{} of {} points do not fit and were left out; pick them again", left, points.size()));
  warn_of_points(solved, used);
  warn_of_doubt(solved, used, free_focal_length);
  if (const double height_m = solved.camera.pose.position().y(); height_m < 0)
    solved.warnings.push_back(fmt::format(
        "the camera comes out {:.2f} m below the floor; left and right may be mixed up", -height_m));
}

Status check(const CameraIntrinsics& intrinsics, std::span<const PickedPoint> points,
             bool free_focal_length) {
  if (!(intrinsics.fx > 0) || !(intrinsics.fy > 0) || intrinsics.width <= 0 || intrinsics.height <= 0)
    return Error{"the camera's intrinsics are incomplete: size and focal lengths have to be above 0", ""};
  const std::size_t least = free_focal_length ? least_points_for_focal : least_points;
  if (points.size() < least)
    return Error{fmt::format("the camera needs at least {} picked points{}; there are {}", least,
                             free_focal_length ? " to find the focal length too" : "", points.size()),
                 ""};
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].world.allFinite() || !points[i].pixel.allFinite())
      return Error{fmt::format("picked point {} is not finite", i + 1), ""};
  return Done{};
}

}  // namespace

Result<SolvedCamera> solve_camera(const CameraIntrinsics& intrinsics, std::span<const PickedPoint> points,
                                  bool free_focal_length) {
  if (const Status usable = check(intrinsics, points, free_focal_length); !usable) return usable.error();
  const auto camera = best_start(intrinsics, points, free_focal_length);
  if (!camera)
    return Error{
        "no camera sees the points as they were picked; check which joint each of them is, and that "
        "the video is in step with the recording",
        ""};
  SolvedCamera solved;
  solved.camera = *camera;
  solved.errors_px = errors_of(*camera, points);
  const double limit_px = outlier_px(intrinsics);
  solved.used = within(solved.errors_px, limit_px);
  const std::size_t least = free_focal_length ? least_points_for_focal : least_points;
  if (count(solved.used) < least || 2 * count(solved.used) < points.size())
    return Error{fmt::format("only {} of {} points agree with one camera to {:.0f} pixels; check which joint "
                             "each of them is, and that the video is in step with the recording",
                             count(solved.used), points.size(), limit_px),
                 ""};
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (solved.used[i]) sum += solved.errors_px[i] * solved.errors_px[i];
  solved.rms_px = std::sqrt(sum / static_cast<double>(count(solved.used)));
  warn(solved, points, free_focal_length);
  return solved;
}

}  // namespace abrazo
