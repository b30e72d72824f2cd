#include "app/workbench/start/unattended.hpp"

#include <QApplication>
#include <QDir>
#include <cmath>
#include <cstdio>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/start/responsiveness.hpp"
#include "app/workbench/start/start_times.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/printable.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

constexpr int video_rate_hz = 15;
constexpr int patience_ms = 90'000;  // for the first frame

}  // namespace

Unattended::Unattended(MainWindow& window, const CommandLine& asked, const Responsiveness& responsiveness,
                       const StartTimes& start, QObject* parent)
    : QObject(parent), m_window(window), m_asked(asked), m_responsiveness(responsiveness) {
  connect(&window.ticker(), &FrameTicker::frameReady, this, &Unattended::onFrame);
  connect(&window, &MainWindow::failed, this, [this](const QString& message) { quit(message); });
  connect(&m_pictures, &QTimer::timeout, this, &Unattended::recordPicture);
  connect(&m_patience, &QTimer::timeout, this,
          [this] { quit("no frame was solved within 90 s; try another file"); });
  if (asked.start_times)
    connect(&start, &StartTimes::moved, this, [this, &start] {
      std::printf("%s", start.text().toUtf8().constData());
      quit({});
    });
  m_pictures.setTimerType(Qt::PreciseTimer);
  m_patience.setSingleShot(true);
  m_patience.start(patience_ms);
}

void Unattended::onFrame(const FrameSnapshotPtr& frame) {
  if (m_shown++ == 0) {
    m_patience.stop();
    m_sinceFirst.start();
    m_renderedBefore = m_window.scene().renderedFrames();
    m_solvedBefore = frame->index;
    if (!m_asked.record.empty()) m_pictures.start(1000 / video_rate_hz);
    if (m_asked.smoke_frames == 0 && !m_asked.start_times)
      QTimer::singleShot(static_cast<int>(std::lround(1000 * m_asked.after_s)), this, &Unattended::onTime);
  }
  if (m_asked.smoke_frames == 0 || m_shown < m_asked.smoke_frames || m_done) return;
  if (frame->result.status == StepStatus::Failed)
    return quit(QString::fromStdString(frame->result.status_text()));
  const double seconds = std::max(1e-3, static_cast<double>(m_sinceFirst.nsecsElapsed()) * 1e-9);
  const auto rendered = m_window.scene().renderedFrames() - m_renderedBefore;
  std::printf("%d frames shown in %.2f s, %.1f rendered per second\n", m_shown, seconds,
              static_cast<double>(rendered) / seconds);
  std::printf("%.1f frames solved per second, requested %s, from an input of %.0f Hz\n",
              static_cast<double>(frame->index - m_solvedBefore) / seconds,
              frame->settings.step_rate_hz > 0
                  ? QString("%1 Hz").arg(frame->settings.step_rate_hz).toUtf8().constData()
                  : "the input's own rate",
              m_window.session()->material().input.fps);
  std::printf("%s\n", m_responsiveness.text().toUtf8().constData());
  quit({});
}

void Unattended::onTime() {
  if (!m_asked.record.empty()) return finishRecording();
  quit(save_screenshot(m_window, QString::fromStdString(m_asked.screenshot)));
}

/// The picture that was due by now, as often as was missed: the video keeps real time on a slow machine.
void Unattended::recordPicture() {
  const QImage picture = m_window.grab().toImage().convertToFormat(QImage::Format_RGB888);
  const int width = picture.width() & ~1, height = picture.height() & ~1;
  if (!m_video) {
    const QDir folder(QString::fromStdString(m_asked.record));
    if (!folder.mkpath(".")) return quit(folder.path() + ": cannot be made; choose another folder");
    auto video = VideoWriter::open(folder.filePath("abrazo.mp4").toStdString(), width, height, video_rate_hz);
    if (!video) return quit(words(video.error()));
    m_video.emplace(std::move(video).value());
  }
  const double due = static_cast<double>(m_sinceFirst.elapsed()) * video_rate_hz / 1000;
  do {
    const Status added = m_video->add({picture.constBits(), static_cast<std::size_t>(picture.sizeInBytes())},
                                      static_cast<std::size_t>(picture.bytesPerLine()));
    if (!added) return quit(words(added.error()));
  } while (m_video->frames() < due);
}

void Unattended::finishRecording() {
  m_pictures.stop();
  recordPicture();
  if (!m_video || m_done) return;
  const QDir folder(QString::fromStdString(m_asked.record));
  const Status video = m_video->finish();
  if (!video) return quit(words(video.error()));
  QString failure = save_screenshot(m_window, folder.filePath("abrazo.png"));
  if (failure.isEmpty()) failure = writeMotion(folder.filePath("abrazo.bvh"));
  if (failure.isEmpty())
    std::printf("written to %s: abrazo.png, abrazo.mp4 (%d pictures), abrazo.bvh\n", m_asked.record.c_str(),
                m_video->frames());
  quit(failure);
}

QString Unattended::writeMotion(const QString& file) const {
  const auto frames = m_window.session()->history().since(0);
  if (frames.size() < 2) return file + ": fewer than two frames were solved; wait longer (--after)";
  Clip active{"active", 60, {}}, passive{"passive", 60, {}};
  for (const FrameSnapshotPtr& frame : frames) {
    active.poses.emplace_back(frame->result.active());
    passive.poses.emplace_back(frame->result.passive());
  }
  const double lasted = frames.back()->time_s - frames.front()->time_s;
  active.fps = passive.fps = lasted > 0 ? static_cast<double>(frames.size() - 1) / lasted : 60;
  const std::array<Clip, 2> both = {std::move(active), std::move(passive)};
  const auto text = write_bvh(both);
  if (!text) return words(text.error());
  const Status written = write_whole_file(file.toStdString(), *text);
  return written ? QString() : words(written.error());
}

void Unattended::quit(const QString& failure) {
  if (m_done) return;
  m_done = true;
  m_pictures.stop();
  if (!failure.isEmpty())
    std::fprintf(stderr, "abrazo-workbench: %s\n", printable(failure.toStdString()).c_str());
  std::fflush(stdout);
  // What fails immediately does so before the event loop runs, which nothing ends then.
  QTimer::singleShot(0, qApp, [code = failure.isEmpty() ? 0 : 1] { QApplication::exit(code); });
}

}  // namespace abrazo::app
