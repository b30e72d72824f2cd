#include "app/workbench/document/open_video.hpp"

#include <QMetaObject>
#include <QStringList>

#include "app/workbench/base/error_words.hpp"
#include "core/opening/file_kinds.hpp"

namespace abrazo::app {

OpenVideo::OpenVideo(const QString& file)
    : m_file(file), m_decoder(std::make_unique<VideoDecoder>(file.toStdString(), [this] { tell(); })) {}

/// On the decoder's thread. Several reports before the receiver runs count as one.
void OpenVideo::tell() {
  if (m_isTold.exchange(true)) return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        m_isTold = false;
        emit news();
      },
      Qt::QueuedConnection);
}

QString OpenVideo::trouble() const {
  const Status status = m_decoder->trouble();
  return status ? QString() : words(status.error());
}

bool OpenVideo::request(int index) {
  if (m_decoder->requested() == index) return false;
  m_decoder->request(index);
  return true;
}

bool is_video_file(const QString& file) {
  return kind_of_file(file.toStdString()) == FileKind::Video;
}

QString video_filter() {
  QStringList patterns;
  for (const std::string& extension : video_extensions())
    patterns << "*." + QString::fromStdString(extension);
  return "Videos (" + patterns.join(" ") + ")";
}

}  // namespace abrazo::app
