#include "app/workbench/video/overlay_film.hpp"

#include <QPainter>
#include <utility>

#include "core/video/video_reader.hpp"
#include "core/video/video_writer.hpp"

namespace abrazo::app {
namespace {

constexpr double plain_height = 540;  // of a picture whose lines are as thick as in the window
constexpr double longest_film_gap_s = 0.5;
constexpr double opening_share = 0.05;
constexpr double film_edge_s = 1e-3;

/// The pair at ascending times, between the two frames around each.
class Moments {
 public:
  explicit Moments(FrameRange frames) : m_frames(std::move(frames)), m_next(m_frames.next()) {}

  widgets::VideoOverlay overlay(const OverlayFilm& film, double time_s) {
    while (m_next && m_next->time_s <= time_s + 1e-9) m_now = std::exchange(m_next, m_frames.next());
    if (!film.camera || !m_now || (!m_next && time_s > m_now->time_s + longest_film_gap_s)) return {};
    const double gap_s = m_next ? m_next->time_s - m_now->time_s : 0;
    const PairPose pose =
        gap_s > 0 && gap_s < longest_film_gap_s
            ? widgets::between(m_now->result.result, m_next->result.result, (time_s - m_now->time_s) / gap_s)
            : m_now->result.result;
    return widgets::project_overlay(*film.camera, pose, m_now->result.edges, film.parts);
  }

 private:
  FrameRange m_frames;
  FrameSnapshotPtr m_now, m_next;
};

QImage image_of(const VideoFrame& picture) {
  return {picture.rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888};
}

bool shows(const VideoFacts& facts, double video_s) {
  return video_s > -film_edge_s && video_s < facts.duration_s() + film_edge_s;
}

}  // namespace

QImage overlay_picture(const OverlayFilm& film, const VideoFrame* picture,
                       const widgets::VideoOverlay& overlay) {
  QImage image(film.size, QImage::Format_RGB888);
  image.fill(Qt::black);
  QPainter painter(&image);
  const widgets::PictureSize view{double(film.size.width()), double(film.size.height())};
  const CameraIntrinsics lens = film.camera ? film.camera->intrinsics : CameraIntrinsics{};
  const widgets::PictureSize size =
      picture ? widgets::PictureSize{double(picture->width), double(picture->height)}
              : widgets::PictureSize{double(lens.width), double(lens.height)};
  const widgets::PictureFraming frame = widgets::framing(size, view, {});
  if (picture) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF place(frame.left, frame.top, size.width * frame.scale, size.height * frame.scale);
    const QImage source = image_of(*picture);
    painter.drawImage(place, frame.scale < 1 ? source.scaled(place.size().toSize(), Qt::IgnoreAspectRatio,
                                                             Qt::SmoothTransformation)
                                             : source);
  }
  widgets::paint_overlay(painter, overlay, frame, film.palette,
                         {film.opacity, std::max(1.0, film.size.height() / plain_height)});
  return image;
}

Status write_overlay_film(const OverlayFilm& film, FrameRange frames, const Progress& progress) {
  const Error cancelled{"cancelled", film.file.toStdString()};
  auto reader = VideoReader::open(film.video.toStdString(), part(progress, 0, opening_share));
  if (!reader) return reader.error();
  auto writer =
      VideoWriter::open(film.file.toStdString(), film.size.width(), film.size.height(), film.plan.rate_hz);
  if (!writer) return writer.error();
  Moments moments(std::move(frames));
  const int all = film.plan.pictures();
  for (int i = 0; i < all; ++i) {
    const std::string doing = "Rendering picture " + std::to_string(i + 1) + " of " + std::to_string(all);
    if (!report(progress, opening_share + (1 - opening_share) * i / all, doing)) return cancelled;
    const double video_s = film.sync.video_time(film.plan.time_of(i));
    VideoFramePtr picture;
    double shown_s = film.plan.time_of(i);
    if (shows(reader->facts(), video_s)) {
      auto read = reader->frame(reader->facts().index_at(video_s));
      if (!read) return read.error();
      picture = *read;
      shown_s = film.sync.subject_time(picture->time_s);  // the bodies at the time of the picture
    }
    const QImage image = overlay_picture(film, picture.get(), moments.overlay(film, shown_s));
    const Status added = writer->add({image.constBits(), static_cast<std::size_t>(image.sizeInBytes())},
                                     static_cast<std::size_t>(image.bytesPerLine()));
    if (!added) return added;
  }
  return writer->finish();
}

}  // namespace abrazo::app
