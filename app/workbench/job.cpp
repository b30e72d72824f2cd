#include "app/workbench/job.hpp"

#include <QMetaObject>

namespace abrazo::app {

Job::Job(Work work, QObject* parent) : QObject(parent) {
  m_thread = std::jthread([this, work = std::move(work)] {
    const Progress progress = [this](double fraction, std::string_view doing) {
      const QString text = QString::fromUtf8(doing.data(), static_cast<int>(doing.size()));
      QMetaObject::invokeMethod(this, [this, fraction, text] { emit progressed(fraction, text); });
      return !m_cancelled;
    };
    Finish finish = work(progress);
    QMetaObject::invokeMethod(
        this,
        [this, finish = std::move(finish)] {
          if (!m_cancelled && finish) finish();
          m_finished = true;
          emit finished();
        },
        Qt::QueuedConnection);
  });
}

void Job::retire(std::unique_ptr<Job> job, QObject* owner) {
  if (!job || job->m_finished) return;
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
