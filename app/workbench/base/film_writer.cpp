#include "app/workbench/base/film_writer.hpp"

#include "app/workbench/base/error_words.hpp"
#include "core/video/video_codec.hpp"
#include "widgets/scene/view/scene_pictures.hpp"

namespace abrazo::app {

FilmWriter::FilmWriter(const QString& file, QSize size, double rate_hz)
    : m_file(file), m_size(size), m_rate_hz(rate_hz) {
  silence_video_codec();
  m_worker = std::thread([this] { run(); });
}

FilmWriter::~FilmWriter() {
  m_isGivenUp = true;
  m_queue.abandon();
  if (m_worker.joinable()) m_worker.join();
}

bool FilmWriter::offer(const QImage& picture, int times) {
  return m_queue.push({picture, times});
}

void FilmWriter::finish() {
  m_queue.close();
}

QString FilmWriter::finishNow() {
  m_queue.close();
  if (m_worker.joinable()) m_worker.join();
  return m_trouble;
}

Status FilmWriter::write(VideoWriter& video, const Picture& picture) {
  const QImage rgb = widgets::fitted(picture.image, m_size);
  for (int i = 0; i < picture.times; ++i) {
    const Status added = video.add({rgb.constBits(), static_cast<std::size_t>(rgb.sizeInBytes())},
                                   static_cast<std::size_t>(rgb.bytesPerLine()));
    if (!added) return added;
    ++m_written;
  }
  return Done{};
}

Status FilmWriter::writeAll() {
  auto video = VideoWriter::open(m_file.toStdString(), m_size.width(), m_size.height(), m_rate_hz);
  if (!video) {
    m_queue.abandon();
    return video.error();
  }
  QMetaObject::invokeMethod(this, &FilmWriter::opened, Qt::QueuedConnection);
  Status all = Done{};
  while (const auto picture = m_queue.pop()) {
    if (m_isGivenUp) return Done{};
    if (all) all = write(*video, *picture);
    QMetaObject::invokeMethod(this, &FilmWriter::hasRoom, Qt::QueuedConnection);
  }
  return all && !m_isGivenUp ? video->finish() : all;
}

void FilmWriter::run() {
  const Status all = writeAll();
  if (m_isGivenUp) return;
  if (!all) m_trouble = words(all.error());
  QMetaObject::invokeMethod(
      this, [this] { emit ended(m_trouble); }, Qt::QueuedConnection);
}

}  // namespace abrazo::app
