#include "app/workbench/base/job.hpp"

#include <gtest/gtest.h>

#include <QStringList>
#include <atomic>
#include <memory>
#include <new>
#include <stdexcept>

#include "tests/workbench/until.hpp"

namespace abrazo::app::job_test {
namespace {

/// What is told of a job whose work throws this; "(finished)" once it is over.
template <typename Thrown>
QStringList told_of(const Thrown& thrown) {
  QStringList told;
  Job::tellFailures([&](const QString& failure) { told << failure; });
  Job job([&](const Progress&) -> Job::Finish { throw thrown; });
  QObject::connect(&job, &Job::finished, [&] { told << "(finished)"; });
  until([&] { return told.contains("(finished)"); });
  Job::tellFailures({});
  return told;
}

TEST(Job, ThatLacksMemorySaysSoAndTheProgramGoesOn) {
  const QStringList told = told_of(std::bad_alloc());
  ASSERT_EQ(told.size(), 2);
  EXPECT_TRUE(told[0].contains("not enough memory")) << told[0].toStdString();
  EXPECT_EQ(told[1], "(finished)");
}

TEST(Job, ThatFailsUnexpectedlySaysHow) {
  const QStringList told = told_of(std::runtime_error("the table has no rows"));
  ASSERT_EQ(told.size(), 2);
  EXPECT_EQ(told[0], "the table has no rows");
}

TEST(Job, ThatIsDoneBeforeItSeesThatItIsCancelledTellsItsOutcome) {
  bool is_told = false, is_over = false;
  Job job([&](const Progress&) -> Job::Finish { return [&] { is_told = true; }; });
  job.cancel();
  QObject::connect(&job, &Job::finished, [&] { is_over = true; });
  EXPECT_TRUE(until([&] { return is_over; }));
  EXPECT_TRUE(is_told);
  EXPECT_TRUE(job.wasCancelled());
}

TEST(Job, ThatWasRetiredTellsNobody) {
  bool is_told = false;
  std::atomic<bool> is_done = false;
  QObject owner;
  Job::retire(std::make_unique<Job>([&](const Progress&) -> Job::Finish {
                is_done = true;
                return [&] { is_told = true; };
              }),
              &owner);
  EXPECT_TRUE(until([&] { return is_done && owner.children().isEmpty(); }));
  EXPECT_FALSE(is_told);
}

TEST(Job, ThatFailedAfterItWasCancelledSaysNothing) {
  QStringList told;
  Job::tellFailures([&](const QString& failure) { told << failure; });
  bool is_over = false;
  Job job([&](const Progress&) -> Job::Finish { throw std::runtime_error("too late"); });
  job.cancel();
  QObject::connect(&job, &Job::finished, [&] { is_over = true; });
  EXPECT_TRUE(until([&] { return is_over; }));
  EXPECT_TRUE(told.empty());
  Job::tellFailures({});
}

}  // namespace
}  // namespace abrazo::app::job_test
