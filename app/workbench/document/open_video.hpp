#pragma once

#include <QObject>
#include <QString>
#include <atomic>

#include "core/video/video_decoder.hpp"

namespace abrazo::app {

/// An open video; brings the results of its decoder to this thread.
class OpenVideo : public QObject {
  Q_OBJECT
 public:
  explicit OpenVideo(const QString& file);

  const QString& file() const { return m_file; }
  VideoDecoder::State state() const { return m_decoder->state(); }
  double opened() const { return m_decoder->opened(); }
  /// Why it cannot be shown, for the window; empty = no problem.
  QString trouble() const;
  /// Null until the file is open.
  std::shared_ptr<const VideoFacts> facts() const { return m_decoder->facts(); }

  /// @return whether it differs from the last request
  bool request(int index);
  VideoFramePtr newest() const { return m_decoder->newest(); }
  int requested() const { return m_decoder->requested().value_or(-1); }

 signals:
  /// State, facts or picture changed.
  void news();

 private:
  void tell();

  QString m_file;
  std::atomic<bool> m_isTold = false;
  std::unique_ptr<VideoDecoder> m_decoder;  // declared last: its thread calls this object
};

/// Whether a file name is that of a video.
bool is_video_file(const QString& file);
/// For a file dialog.
QString video_filter();

}  // namespace abrazo::app
