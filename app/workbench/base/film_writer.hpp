#pragma once

#include <QImage>
#include <QObject>
#include <atomic>
#include <memory>
#include <thread>

#include "app/workbench/base/bounded_queue.hpp"
#include "core/video/video_writer.hpp"

namespace abrazo::app {

/// A film on its way to the disk: pictures are given on the thread that draws and encoded on another. The
/// file is there when it is whole, or not at all; without finish() it is given up.
class FilmWriter : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t most_waiting = 6;

  /// @param size  of the film [pixels], even
  static Result<std::unique_ptr<FilmWriter>> open(const QString& file, QSize size, double rate_hz);
  ~FilmWriter() override;

  bool isFull() const { return m_queue.is_full(); }
  /// @param times  how often it stands in the film
  /// @return false when too many are waiting; then it was not taken
  bool offer(const QImage& picture, int times = 1);
  /// No more come; ended() follows when all are written.
  void finish();
  /// As finish(), and waits for it. @return what went wrong, or nothing
  QString finishNow();
  int written() const { return m_written; }

 signals:
  void hasRoom();
  void ended(const QString& trouble);

 private:
  struct Picture {
    QImage image;
    int times = 1;
  };
  FilmWriter(VideoWriter video, QSize size);
  void run();
  Status write(const Picture& picture);

  VideoWriter m_video;
  QSize m_size;
  BoundedQueue<Picture> m_queue{most_waiting};
  std::atomic<bool> m_isGivenUp = false;
  std::atomic<int> m_written = 0;
  QString m_trouble;  ///< the worker's until it is joined
  std::thread m_worker;
};

}  // namespace abrazo::app
