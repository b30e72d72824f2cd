#include "app/workbench/base/job.hpp"

#include <QMetaObject>
#include <exception>
#include <new>
#include <utility>

#include "core/base/thread_urgency.hpp"

namespace abrazo::app {

namespace {

std::function<void(const QString&)>& told() {
  static std::function<void(const QString&)> to;
  return to;
}

void tell(const QString& failure) {
  if (told()) told()(failure);
}

}  // namespace

void Job::tellFailures(std::function<void(const QString&)> to) {
  told() = std::move(to);
}

Job::Job(Work work, QObject* parent, Pace pace) : QObject(parent) {
  m_running.emplace([this] {
    m_retired = true;
    cancel();
  });
  m_thread = std::jthread([this, pace, work = std::move(work)] {
    if (pace == Pace::Background) let_others_go_first();
    const Progress progress = [this](double fraction, std::string_view doing) {
      const QString text = QString::fromUtf8(doing.data(), static_cast<int>(doing.size()));
      QMetaObject::invokeMethod(this, [this, fraction, text] {
        if (!m_retired) emit progressed(fraction, text);
      });
      return !m_cancelled;
    };
    Finish finish;
    try {
      finish = work(progress);
    } catch (const std::bad_alloc&) {
      finish = [this] {
        if (!m_cancelled)
          tell(
              "There is not enough memory for this; close other programs, or run fewer jobs at the same "
              "time.");
      };
    } catch (const std::exception& failure) {
      finish = [this, text = QString::fromUtf8(failure.what())] {
        if (!m_cancelled) tell(text);
      };
    }
    QMetaObject::invokeMethod(
        this,
        [this, finish = std::move(finish)] {
          if (!m_retired && finish) finish();
          m_finished = true;
          m_running.reset();
          emit finished();
        },
        Qt::QueuedConnection);
  });
}

void Job::retire(std::unique_ptr<Job> job, QObject* owner) {
  if (!job) return;
  if (job->m_finished) return job.release()->deleteLater();  // it may be what calls
  job->m_retired = true;
  job->cancel();
  job->disconnect();
  job->setParent(owner);
  connect(job.get(), &Job::finished, job.get(), &QObject::deleteLater);
  static_cast<void>(job.release());  // its owner is the parent now
}

Job::~Job() {
  m_cancelled = true;
}

}  // namespace abrazo::app
