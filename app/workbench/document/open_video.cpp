#include "app/workbench/document/open_video.hpp"

#include <QFileInfo>
#include <QMetaObject>
#include <QStringList>

namespace abrazo::app {
namespace {

const QStringList& endings() {
  static const QStringList known = {"mp4", "m4v",  "mov", "avi", "mkv", "webm", "mpg", "mpeg",
                                    "mts", "m2ts", "ts",  "wmv", "ogv", "3gp",  "flv", "mjpeg"};
  return known;
}

}  // namespace

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
  return status ? QString() : QString::fromStdString(status.error().text());
}

bool OpenVideo::request(int index) {
  if (m_decoder->requested() == index) return false;
  m_decoder->request(index);
  return true;
}

bool is_video_file(const QString& file) {
  return endings().contains(QFileInfo(file).suffix().toLower());
}

QString video_filter() {
  return "Videos (*." + endings().join(" *.") + ")";
}

}  // namespace abrazo::app
