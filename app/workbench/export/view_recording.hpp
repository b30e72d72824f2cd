#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "app/workbench/base/film_plan.hpp"
#include "app/workbench/base/film_writer.hpp"

namespace abrazo::app {

/// Films what is on the screen, in real time, until it is stopped.
class ViewRecording : public QObject {
  Q_OBJECT
 public:
  static constexpr double rate_hz = 25;
  using TakePicture = std::function<QImage()>;

  ViewRecording(TakePicture take, QObject* parent);
  ~ViewRecording() override;
  /// @return what prevents it, or nothing
  QString start(const QString& file);
  /// ended() follows when the file is there.
  void stop();
  /// As stop(), and waits: the program ends.
  void stopNow();
  bool isRunning() const { return m_timer.isActive(); }
  /// Not yet ended, although it may be stopped.
  bool isBusy() const { return m_writer != nullptr; }
  double elapsed_s() const { return static_cast<double>(m_clock.elapsed()) / 1000; }

 signals:
  void progressed(double elapsed_s);
  /// No more pictures are taken; those that wait are still written.
  void stopped();
  /// @param trouble  what went wrong, or nothing  @param words  file, length, what was left out
  void ended(const QString& trouble, const QString& words);

 private:
  void takePicture();
  void onEnded(const QString& trouble);

  TakePicture m_take;
  QString m_file;
  QTimer m_timer;
  QElapsedTimer m_clock;
  FilmClock m_due{rate_hz};
  std::unique_ptr<FilmWriter> m_writer;
};

}  // namespace abrazo::app
