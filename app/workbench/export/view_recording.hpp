#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "app/workbench/base/film_clock.hpp"
#include "app/workbench/base/film_writer.hpp"

namespace abrazo::app {

/// Records the screen as a film in real time until stopped.
class ViewRecording : public QObject {
  Q_OBJECT
 public:
  static constexpr double rate_hz = 25;
  using TakePicture = std::function<QImage()>;

  ViewRecording(TakePicture take, QObject* parent);
  ~ViewRecording() override;
  /// Begins as soon as the encoder takes pictures; if it cannot, ended() says why.
  void start(const QString& file);
  /// ended() follows when the file is complete.
  void stop();
  /// As stop(), but waits; for the end of the program.
  void stopNow();
  bool isRunning() const { return m_timer.isActive(); }
  /// The encoder is being loaded, or writes, even if stopped.
  bool isBusy() const { return m_writer != nullptr; }
  double elapsed_s() const { return static_cast<double>(m_clock.elapsed()) / 1000; }

 signals:
  void progressed(double elapsed_s);
  /// Recording stopped; queued pictures are still being written.
  void stopped();
  /// @param trouble the error, or empty @param words file, length, dropped pictures
  void ended(const QString& trouble, const QString& words);

 private:
  void begin();
  void takePicture();
  void onEnded(const QString& trouble);

  TakePicture m_take;
  QString m_file;
  QTimer m_timer;
  QElapsedTimer m_clock;
  FilmClock m_due{rate_hz};
  bool m_hasBegun = false;
  std::unique_ptr<FilmWriter> m_writer;
};

}  // namespace abrazo::app
