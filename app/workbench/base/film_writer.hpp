#pragma once

#include <QImage>
#include <QObject>
#include <atomic>
#include <memory>
#include <thread>

#include "app/workbench/base/bounded_queue.hpp"
#include "core/video/video_writer.hpp"

namespace abrazo::app {

/// Writes a film: pictures are passed from the drawing thread and encoded on another, which also loads the
/// encoder; that takes a second the first time. The file appears when it is complete; without finish() it is
/// discarded.
class FilmWriter : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t most_waiting = 6;

  /// @param size  of the film [pixels], even
  FilmWriter(const QString& file, QSize size, double rate_hz);
  ~FilmWriter() override;

  bool isFull() const { return m_queue.is_full(); }
  /// @param times number of film frames for the picture
  /// @return false if the queue is full; the picture is then dropped
  bool offer(const QImage& picture, int times = 1);
  /// Ends the film; ended() follows when all pictures are written.
  void finish();
  /// As finish(), but waits. @return the error, or empty
  QString finishNow();
  int written() const { return m_written; }

 signals:
  /// The encoder takes pictures; if it cannot, ended() says why instead.
  void opened();
  void hasRoom();
  void ended(const QString& trouble);

 private:
  struct Picture {
    QImage image;
    int times = 1;
  };
  void run();
  Status writeAll();
  Status write(VideoWriter& video, const Picture& picture);

  QString m_file;
  QSize m_size;
  double m_rate_hz;
  BoundedQueue<Picture> m_queue{most_waiting};
  std::atomic<bool> m_isGivenUp = false;
  std::atomic<int> m_written = 0;
  QString m_trouble;  ///< the worker's until it is joined
  std::thread m_worker;
};

}  // namespace abrazo::app
