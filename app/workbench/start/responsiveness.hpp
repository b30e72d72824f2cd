#pragma once

#include <QObject>
#include <QString>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/workbench/start/answer_times.hpp"

namespace abrazo::app {

class MainWindow;

/// How long the thread of the windows goes without answering. A thread of its own asks it every few
/// milliseconds and waits for the answer before it asks again, so a gap is measured to within that interval;
/// time the machine gave to other programs counts as well.
class Responsiveness : public QObject {
  Q_OBJECT
 public:
  static constexpr int interval_ms = 8;

  explicit Responsiveness(QObject* parent = nullptr);
  ~Responsiveness() override;

  /// Starts again; what is measured from now on is this.
  void begin(const QString& activity);
  /// Of the present activity.
  const AnswerTimes& times() const { return m_times; }
  /// Since the program began.
  const AnswerTimes& overall() const { return m_overall; }
  /// "answers within 6 ms (99 %), longest 31 ms, 12 s ago, while opening"
  QString text() const;

 protected:
  void customEvent(QEvent* event) override;

 private:
  void ask(const std::stop_token& stop);

  AnswerTimes m_times, m_overall;
  QString m_activity = "starting", m_slowestActivity = "starting";
  double m_slowest_s = 0;  ///< on the machine's own clock
  std::mutex m_mutex;
  std::condition_variable_any m_answered;
  bool m_isOpen = false;  ///< asked and not answered
  std::jthread m_asking;  // last: joined first
};

/// Shows the text as the status bar's tooltip, and names what is measured by what the window does.
void watch(MainWindow& window, Responsiveness& responsiveness);

}  // namespace abrazo::app
