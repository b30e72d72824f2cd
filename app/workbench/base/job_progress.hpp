#pragma once

#include "app/workbench/base/job.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {

/// Shows the progress of a job in the message bar until it is done.
inline void show_progress(const Job& job, widgets::MessageBar& messages) {
  QObject::connect(&job, &Job::progressed, &messages, [&messages](double fraction, const QString& doing) {
    messages.showProgress(doing, fraction);
  });
  QObject::connect(&job, &Job::finished, &messages, &widgets::MessageBar::endProgress);
}

}  // namespace abrazo::app
