#include "app/workbench/export/view_recording.hpp"

namespace abrazo::app {

ViewRecording::ViewRecording(TakePicture take, QObject* parent) : QObject(parent), m_take(std::move(take)) {
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(static_cast<int>(1000 / rate_hz));
  connect(&m_timer, &QTimer::timeout, this, &ViewRecording::takePicture);
}

ViewRecording::~ViewRecording() {
  if (m_writer && m_hasBegun) m_writer->finishNow();
}

void ViewRecording::start(const QString& file) {
  const QSize now = m_take().size();
  m_file = file;
  m_hasBegun = false;
  m_due = FilmClock(rate_hz);
  m_writer = std::make_unique<FilmWriter>(file, QSize(now.width() & ~1, now.height() & ~1), rate_hz);
  m_running.emplace([this] { stopForGood(); });
  connect(m_writer.get(), &FilmWriter::opened, this, &ViewRecording::begin);
  connect(m_writer.get(), &FilmWriter::ended, this, &ViewRecording::onEnded);
}

void ViewRecording::begin() {
  m_hasBegun = true;
  m_clock.start();
  m_timer.start();
  takePicture();
}

void ViewRecording::takePicture() {
  const int times = m_due.due(elapsed_s());
  if (times == 0) return;
  if (m_writer->isFull() || !m_writer->offer(m_take(), times))
    m_due.dropped();
  else
    m_due.given(times);
  emit progressed(elapsed_s());
}

void ViewRecording::stop() {
  if (!isRunning()) return;
  m_timer.stop();
  emit stopped();
  m_writer->finish();
}

void ViewRecording::stopForGood() {
  if (m_hasBegun) return stop();
  m_writer.reset();  // there is nothing to write
  m_running.reset();
}

void ViewRecording::onEnded(const QString& trouble) {
  const int pictures = m_writer->written();
  m_timer.stop();
  emit stopped();
  m_writer.release()->deleteLater();  // it is what speaks
  m_running.reset();
  QString words = QString("Recording written to %1: %2 s, %3 pictures")
                      .arg(m_file)
                      .arg(pictures / rate_hz, 0, 'f', 1)
                      .arg(pictures);
  if (m_due.left_out() > 0)
    words += QString("; %1 left out because encoding was slower").arg(m_due.left_out());
  emit ended(trouble, words);
}

}  // namespace abrazo::app
