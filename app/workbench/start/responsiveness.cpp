#include "app/workbench/start/responsiveness.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QMainWindow>
#include <QStatusBar>
#include <QTimer>
#include <chrono>
#include <cmath>
#include <stop_token>

#include "app/workbench/document/document.hpp"

namespace abrazo::app {
namespace {

constexpr auto question = static_cast<QEvent::Type>(QEvent::User + 71);
constexpr int tooltip_ms = 1000;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Question : public QEvent {
 public:
  Question() : QEvent(question) {}
  const double asked_s = now_s();
};

QString whole(double value) {
  return QString::number(std::lround(value));
}

}  // namespace

Responsiveness::Responsiveness(QObject* parent)
    : QObject(parent), m_asking([this](const std::stop_token& stop) { ask(stop); }) {}

Responsiveness::~Responsiveness() = default;

void Responsiveness::ask(const std::stop_token& stop) {
  std::unique_lock lock(m_mutex);
  while (!stop.stop_requested()) {
    m_isOpen = true;
    QCoreApplication::postEvent(this, new Question);
    m_answered.wait(lock, stop, [this] { return !m_isOpen; });
    m_answered.wait_for(lock, stop, std::chrono::milliseconds(interval_ms), [] { return false; });
  }
}

void Responsiveness::customEvent(QEvent* event) {
  if (event->type() != question) return;
  const double now = now_s(), waited_ms = 1000 * (now - static_cast<Question*>(event)->asked_s);
  if (waited_ms > m_overall.longest_ms()) {
    m_slowestActivity = m_activity;
    m_slowest_s = now;
  }
  m_times.add(waited_ms);
  m_overall.add(waited_ms);
  {
    const std::lock_guard lock(m_mutex);
    m_isOpen = false;
  }
  m_answered.notify_one();
}

void Responsiveness::begin(const QString& activity) {
  m_activity = activity;
  m_times = {};
}

QString Responsiveness::text() const {
  return QString("The window answers within %1 ms (99 % of the time); longest %2 ms, %3 s ago, while %4")
      .arg(whole(m_overall.within_ms(0.99)), whole(m_overall.longest_ms()), whole(now_s() - m_slowest_s),
           m_slowestActivity);
}

void watch(QMainWindow& window, Document& document, Responsiveness& responsiveness) {
  QObject::connect(&document, &Document::began, &responsiveness,
                   [&responsiveness] { responsiveness.begin("running"); });
  QObject::connect(&document, &Document::ending, &responsiveness,
                   [&responsiveness] { responsiveness.begin("opening"); });
  auto* refresh = new QTimer(&window);
  QObject::connect(refresh, &QTimer::timeout, &window,
                   [&window, &responsiveness] { window.statusBar()->setToolTip(responsiveness.text()); });
  refresh->start(tooltip_ms);
}

}  // namespace abrazo::app
