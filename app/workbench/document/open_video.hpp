#pragma once

#include <QObject>
#include <QString>
#include <atomic>

#include "core/video/video_decoder.hpp"

namespace abrazo::app {

/// A video that is open, with what its decoder has to say brought to this thread.
class OpenVideo : public QObject {
  Q_OBJECT
 public:
  explicit OpenVideo(const QString& file);

  const QString& file() const { return m_file; }
  VideoDecoder::State state() const { return m_decoder->state(); }
  double opened() const { return m_decoder->opened(); }
  /// Why it cannot be shown, in words for the window; empty while it can.
  QString trouble() const;
  /// Null until the file is open.
  std::shared_ptr<const VideoFacts> facts() const { return m_decoder->facts(); }

  /// @return whether this was not what was asked for last
  bool request(int index);
  VideoFramePtr newest() const { return m_decoder->newest(); }
  int requested() const { return m_decoder->requested().value_or(-1); }

 signals:
  /// State, facts or picture are new.
  void news();

 private:
  void tell();

  QString m_file;
  std::atomic<bool> m_isTold = false;
  std::unique_ptr<VideoDecoder> m_decoder;  // last: its thread calls this
};

/// Whether the name is that of a video.
bool is_video_file(const QString& file);
/// For a file dialog.
QString video_filter();

}  // namespace abrazo::app
