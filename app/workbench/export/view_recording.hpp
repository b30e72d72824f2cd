#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "app/workbench/base/film_clock.hpp"
#include "app/workbench/base/film_writer.hpp"
#include "app/workbench/base/running_work.hpp"

namespace abrazo::app {

/// Records the screen as a film in real time until stopped, at the latest by the end of the window.
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
  void stopForGood();
  void takePicture();
  void onEnded(const QString& trouble);

  TakePicture m_take;
  QString m_file;
  QTimer m_timer;
  QElapsedTimer m_clock;
  FilmClock m_due{rate_hz};
  bool m_hasBegun = false;
  std::unique_ptr<FilmWriter> m_writer;
  std::optional<RunningWork> m_running;  ///< while there is a writer
};

}  // namespace abrazo::app
