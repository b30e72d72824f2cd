#include "tests/workbench/calibrated_video.hpp"

#include <algorithm>

#include <Eigen/Geometry>
#include <QImage>
#include <QPainter>

#include "core/motion/body/joint_set.hpp"
#include "core/video/video_writer.hpp"

namespace abrazo::app {
namespace {

constexpr int bits = 12, bit_px = 16;
constexpr double limb_m = 0.055;
constexpr int pieces_of_limb = 12;

struct Limb {
  double depth_m = 0;
  std::vector<QPointF> line;
  double width_px = 1;
  QColor colour;
};

QPointF point_of(const Pixel& pixel) {
  return {pixel.x() + 0.5, pixel.y() + 0.5};
}

double depth_of(const CameraModel& camera, const Vec3& world) {
  return (camera.pose.rotation * world + camera.pose.translation).z();
}

std::vector<Limb> limbs_of(const CameraModel& camera, const PairPose& pose) {
  std::vector<Limb> limbs;
  for (const int body : {0, joint_count})
    for (int b = 0; b < bone_count; ++b) {
      const Vec3 from = pose.row(body + bone(b).first).transpose(),
                 to = pose.row(body + bone(b).second).transpose();
      Limb limb;
      limb.depth_m = depth_of(camera, 0.5 * (from + to));
      limb.width_px = std::max(1.5, limb_m * camera.intrinsics.fx / limb.depth_m);
      limb.colour = body == 0 ? QColor(96, 84, 70) : QColor(150, 128, 112);
      for (int i = 0; i <= pieces_of_limb; ++i)
        limb.line.push_back(point_of(seen_by(camera, from + (to - from) * i / pieces_of_limb)));
      limbs.push_back(limb);
    }
  std::sort(limbs.begin(), limbs.end(), [](const Limb& a, const Limb& b) { return a.depth_m > b.depth_m; });
  return limbs;
}

void draw_floor(QPainter& painter, const CameraModel& camera) {
  painter.setPen(QPen(QColor(178, 172, 160), 1.5));
  for (int i = -8; i <= 8; ++i)
    for (const bool across : {true, false}) {
      QPolygonF line;
      for (int k = -40; k <= 40; ++k) {
        const Vec3 at = across ? Vec3(0.1 * k, 0, 0.5 * i) : Vec3(0.5 * i, 0, 0.1 * k);
        if (depth_of(camera, at) > 0.3) line << point_of(seen_by(camera, at));
      }
      painter.drawPolyline(line);
    }
}

void draw_number(QPainter& painter, int number) {
  for (int bit = 0; bit < bits; ++bit)
    painter.fillRect(QRect(bit * bit_px, 0, bit_px, bit_px), (number >> bit) & 1 ? Qt::white : Qt::black);
}

QImage drawn(const CalibratedVideo& video, int number) {
  QImage image(video.camera.intrinsics.width, video.camera.intrinsics.height, QImage::Format_RGB888);
  image.fill(QColor(206, 201, 190));
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  draw_floor(painter, video.camera);
  const PairPose pose = video.pose(video.from_s + number / video.fps);
  for (const Limb& limb : limbs_of(video.camera, pose)) {
    painter.setPen(QPen(limb.colour, limb.width_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF(QVector<QPointF>(limb.line.begin(), limb.line.end())));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::white);
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex)
    painter.drawEllipse(point_of(seen_by(video.camera, pose.row(vertex).transpose())), 2.5, 2.5);
  draw_number(painter, number);
  return image;
}

}  // namespace

CameraModel looking_camera(int width, int height, double focal_px, const Vec3& from, const Vec3& at,
                           double k1) {
  CameraModel camera;
  camera.intrinsics = {width, height, focal_px, focal_px, 0.5 * (width - 1), 0.5 * (height - 1), {k1}};
  const Vec3 ahead = (at - from).normalized();
  const Vec3 right = ahead.cross(Vec3::UnitY()).normalized();
  camera.pose.rotation << right.transpose(), -right.cross(ahead).transpose(), ahead.transpose();
  camera.pose.translation = -camera.pose.rotation * from;
  return camera;
}

Pixel seen_by(const CameraModel& camera, const Vec3& world) {
  const Vec3 at = camera.pose.rotation * world + camera.pose.translation;
  const double x = at.x() / at.z(), y = at.y() / at.z();
  const double bent = 1 + camera.intrinsics.distortion[0] * (x * x + y * y);
  return {camera.intrinsics.cx + camera.intrinsics.fx * x * bent,
          camera.intrinsics.cy + camera.intrinsics.fy * y * bent};
}

Status write_calibrated_video(const CalibratedVideo& video, const QString& file) {
  auto writer = VideoWriter::open(file.toStdString(), video.camera.intrinsics.width,
                                  video.camera.intrinsics.height, video.fps);
  if (!writer) return writer.error();
  for (int number = 0; number < video.pictures; ++number) {
    const QImage image = drawn(video, number);
    const Status added = writer->add({image.constBits(), static_cast<std::size_t>(image.sizeInBytes())},
                                     static_cast<std::size_t>(image.bytesPerLine()));
    if (!added) return added;
  }
  return writer->finish();
}

int number_in(const VideoFrame& picture) {
  int number = 0;
  for (int bit = 0; bit < bits; ++bit) {
    const auto at = static_cast<std::size_t>(3 * (bit_px / 2 * picture.width + bit * bit_px + bit_px / 2));
    if (picture.rgb[at] > 128) number |= 1 << bit;
  }
  return number;
}

}  // namespace abrazo::app
