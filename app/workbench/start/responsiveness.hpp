#pragma once

#include <QObject>
#include <QString>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "app/workbench/start/answer_times.hpp"

class QMainWindow;

namespace abrazo::app {

class Document;

/// Measures the response time of the GUI thread. A separate thread pings it every few milliseconds and waits
/// for the answer, so a gap is measured to within that interval; time used by other programs counts too.
class Responsiveness : public QObject {
  Q_OBJECT
 public:
  static constexpr int interval_ms = 8;

  explicit Responsiveness(QObject* parent = nullptr);
  ~Responsiveness() override;

  /// Resets the measurement for an activity.
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
  double m_slowest_s = 0;  ///< monotonic clock
  std::mutex m_mutex;
  std::condition_variable_any m_answered;
  bool m_isOpen = false;  ///< a ping is unanswered
  std::jthread m_asking;  // last: joined first
};

/// Shows the text as the status bar's tooltip, and sets the activity from the window's state.
void watch(QMainWindow& window, Document& document, Responsiveness& responsiveness);

}  // namespace abrazo::app
