// A thread that has no processor is made: it runs at idle priority on one processor with another that is
// always busy. Counts of the kernel are compared, not times.
#include "tests/soak/answer_watch.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>

#include <atomic>
#include <fstream>

#include "tests/soak/fake_driver.hpp"

namespace abrazo::soak::answer_watch_test {
namespace {

const Driver fake_driver{{"libabrazo_fake_driver"}, "drawing"};

/// Of the calling thread; below 0 where the kernel does not count.
double starved_s() {
  std::ifstream file("/proc/thread-self/schedstat");
  double ran_ns = 0, starved_ns = -1;
  file >> ran_ns >> starved_ns;
  return starved_ns / 1e9;
}

/// Both threads on the first processor that this program may use.
void stay_on_one_processor() {
  cpu_set_t may{}, one{};
  ::sched_getaffinity(0, sizeof may, &may);
  int first = 0;
  while (!CPU_ISSET(first, &may)) ++first;
  CPU_SET(first, &one);
  ::sched_setaffinity(0, sizeof one, &one);
}

/// Raises `drawn` when it has been without a processor for a second since begin().
class StarvingThread {
 public:
  explicit StarvingThread(const char* name)
      : busy_([this] {
          stay_on_one_processor();
          while (!is_done_) {
          }
        }),
        starving_([this, name] {
          ::pthread_setname_np(::pthread_self(), name);
          stay_on_one_processor();
          const sched_param none{};
          ::sched_setscheduler(0, SCHED_IDLE, &none);
          while (!is_begun_) {
          }
          const double before_s = starved_s();
          while (starved_s() - before_s < 1.0) {
          }
          ::sem_post(&drawn);
          while (!is_done_) {
          }
        }) {}
  ~StarvingThread() {
    is_done_ = true;
    starving_.join();
    busy_.join();
  }
  StarvingThread(const StarvingThread&) = delete;
  StarvingThread& operator=(const StarvingThread&) = delete;

  void begin() { is_begun_ = true; }

  sem_t drawn = [] {
    sem_t semaphore{};
    ::sem_init(&semaphore, 0, 0);
    return semaphore;
  }();

 private:
  std::atomic<bool> is_begun_{false}, is_done_{false};
  std::thread busy_, starving_;
};

void wait_elsewhere(sem_t* drawn) {
  while (::sem_wait(drawn) != 0) {
  }
}

/// The gap while WAIT waits for a thread of this name, and the wait of the waiting thread for a processor.
struct Waited {
  AnswerWatch::Gap gap;
  double own_starved_s = 0;
};
Waited waited_for(const char* thread, void (*wait)(sem_t*)) {
  AnswerWatch watch(60, fake_driver);
  StarvingThread starving(thread);
  const double before_s = starved_s();
  watch.forget();
  starving.begin();  // all of the second is in the gap, however long the threads took to start
  wait(&starving.drawn);
  const AnswerWatch::Gap gap = watch.beat();
  return {gap, starved_s() - before_s};
}

class AnswerWatchTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (starved_s() < 0) GTEST_SKIP() << "the kernel does not count waits for a processor";
  }
};

TEST_F(AnswerWatchTest, AWaitForAThreadThatDrawsButHasNoProcessorIsExcused) {
  const Waited waited = waited_for("drawing-0", wait_in_driver);
  EXPECT_GT(waited.gap.starved_s, waited.own_starved_s + 0.5);
}

TEST_F(AnswerWatchTest, AWaitForAnyOtherThreadIsNot) {
  const Waited waited = waited_for("solver", wait_in_driver);
  EXPECT_LE(waited.gap.starved_s, waited.own_starved_s);
}

TEST_F(AnswerWatchTest, AWaitOutsideTheDriverIsNotWhileAThreadThatDrawsHasNoProcessor) {
  const Waited waited = waited_for("drawing-0", wait_elsewhere);
  EXPECT_LE(waited.gap.starved_s, waited.own_starved_s);
}

}  // namespace
}  // namespace abrazo::soak::answer_watch_test
