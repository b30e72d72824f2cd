#include "app/workbench/base/film_writer.hpp"

#include "app/workbench/base/error_words.hpp"
#include "widgets/scene/view/scene_pictures.hpp"

namespace abrazo::app {

Result<std::unique_ptr<FilmWriter>> FilmWriter::open(const QString& file, QSize size, double rate_hz) {
  auto video = VideoWriter::open(file.toStdString(), size.width(), size.height(), rate_hz);
  if (!video) return video.error();
  return std::unique_ptr<FilmWriter>(new FilmWriter(std::move(video).value(), size));
}

FilmWriter::FilmWriter(VideoWriter video, QSize size)
    : m_video(std::move(video)), m_size(size), m_worker([this] { run(); }) {}

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

Status FilmWriter::write(const Picture& picture) {
  const QImage rgb = widgets::fitted(picture.image, m_size);
  for (int i = 0; i < picture.times; ++i) {
    const Status added = m_video.add({rgb.constBits(), static_cast<std::size_t>(rgb.sizeInBytes())},
                                     static_cast<std::size_t>(rgb.bytesPerLine()));
    if (!added) return added;
    ++m_written;
  }
  return Done{};
}

void FilmWriter::run() {
  Status all = Done{};
  while (const auto picture = m_queue.pop()) {
    if (m_isGivenUp) return;
    if (all) all = write(*picture);
    QMetaObject::invokeMethod(this, &FilmWriter::hasRoom, Qt::QueuedConnection);
  }
  if (m_isGivenUp) return;
  if (all) all = m_video.finish();
  if (!all) m_trouble = words(all.error());
  QMetaObject::invokeMethod(
      this, [this] { emit ended(m_trouble); }, Qt::QueuedConnection);
}

}  // namespace abrazo::app
