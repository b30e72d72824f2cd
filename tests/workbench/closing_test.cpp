// A window that is closed while something runs: it answers until that has stopped, and then goes.
#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "app/workbench/base/job.hpp"
#include "app/workbench/base/range_rendering.hpp"
#include "app/workbench/base/running_work.hpp"
#include "app/workbench/export/view_recording.hpp"
#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app::closing_test {
namespace {

class Closing : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showWindow({900, 600}); }
  void SetUp() override {
    window().show();
    turn();
  }
};

/// The longest time between two turns of the event loop [ms].
class LongestGap {
 public:
  LongestGap() {
    QObject::connect(&m_timer, &QTimer::timeout, [this] { note(); });
    m_timer.start(1);
    m_since.start();
  }
  int ms() { return note(), static_cast<int>(m_longest_ms); }

 private:
  void note() { m_longest_ms = std::max(m_longest_ms, m_since.restart()); }
  QTimer m_timer;
  QElapsedTimer m_since;
  qint64 m_longest_ms = 0;
};

/// A job that notices late that it is cancelled.
struct LateJob {
  std::atomic<bool> goes_on = true;
  bool has_told = false;
  Job job{[this](const Progress&) -> Job::Finish {
    while (goes_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return [this] { has_told = true; };
  }};
};

TEST_F(Closing, AWindowWithoutWorkGoesAtOnce) {
  ASSERT_TRUE(until([] { return !RunningWork::any(); }));
  EXPECT_TRUE(window().close());
  EXPECT_FALSE(window().isVisible());
}

TEST_F(Closing, TheWindowAnswersUntilItsWorkHasStoppedAndThenGoes) {
  LateJob late;
  window().close();
  EXPECT_TRUE(late.job.wasCancelled());
  EXPECT_TRUE(window().messages().text().startsWith("Stopping")) << window().messages().text().toStdString();
  int answers = 0;
  QTimer clock;
  QObject::connect(&clock, &QTimer::timeout, [&] { ++answers; });
  clock.start(1);
  EXPECT_TRUE(until([&] { return answers >= 20; })) << "nothing waits for the job on this thread";
  EXPECT_TRUE(window().isVisible());
  window().close();
  EXPECT_TRUE(window().isVisible()) << "asked for again";
  late.goes_on = false;
  EXPECT_TRUE(until([] { return !window().isVisible(); }));
  EXPECT_FALSE(late.has_told) << "nobody is there for its result";
}

TEST_F(Closing, WorkThatBeginsMeanwhileIsStoppedAsWell) {
  LateJob first;
  std::unique_ptr<LateJob> second;
  QObject::connect(&first.job, &Job::finished, [&] { second = std::make_unique<LateJob>(); });
  window().close();
  first.goes_on = false;
  ASSERT_TRUE(until([&] { return second && second->job.wasCancelled(); }));
  EXPECT_TRUE(window().isVisible());
  second->goes_on = false;
  EXPECT_TRUE(until([] { return !window().isVisible(); }));
}

TEST_F(Closing, ARefusedCloseStopsNothing) {
  LateJob late;
  const auto refusal =
      QObject::connect(&window(), &MainWindow::leaving, [](bool& allowed) { allowed = false; });
  window().close();
  EXPECT_TRUE(window().isVisible());
  EXPECT_FALSE(late.job.wasCancelled());
  QObject::disconnect(refusal);
  late.goes_on = false;
  EXPECT_TRUE(until([&] { return late.has_told; }));
}

TEST_F(Closing, AFilmThatIsBeingRecordedIsWrittenToItsEndBefore) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("evening.mp4");
  ViewRecording film(
      [] {
        QImage picture(64, 48, QImage::Format_RGB32);
        picture.fill(Qt::red);
        return picture;
      },
      nullptr);
  QString words;
  QObject::connect(&film, &ViewRecording::ended,
                   [&](const QString& trouble, const QString& told) { words = trouble + told; });
  film.start(file);
  ASSERT_TRUE(until([&] { return film.isRunning(); }));
  window().close();
  EXPECT_FALSE(film.isRunning());
  EXPECT_TRUE(until([] { return !window().isVisible(); }));
  EXPECT_TRUE(words.startsWith("Recording written to " + file)) << words.toStdString();
  EXPECT_TRUE(QFile::exists(file));
}

/// The window went, and the film was rendered to its end unseen.
TEST_F(Closing, AFilmThatIsRenderedIsCancelled) {
  window().openDemo();
  ASSERT_TRUE(until([] { return window().session() && window().session()->history().span().last_s > 1; }));
  const QTemporaryDir folder;
  render_range(window(), {{0, 1, 600}, {480, 320}, true, folder.filePath("range.mp4")});
  ASSERT_TRUE(until([] { return window().messages().text().contains("Rendering picture"); }));
  window().close();
  EXPECT_TRUE(RunningWork::any());
  ASSERT_TRUE(until([] { return !window().isVisible(); }));
  EXPECT_FALSE(RunningWork::any());
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(Closing, ASessionThatIsRecordedEndsWithoutTheWindowWaitingForIt) {
  window().openDemo();
  ASSERT_TRUE(until([] { return window().session() && window().session()->latest().newest(); }));
  auto& takes = *window().findChild<TakeDesk*>();
  auto& history = *window().findChild<HistoryDesk*>();
  takes.toggle();
  ASSERT_TRUE(until([&] {
    const auto recorder = window().session()->engine().recorder();
    return recorder && recorder->state().frames > 10;
  }));
  const QString file = takes.file(), folder = history.folder();
  const std::weak_ptr<Recorder> recorder = window().session()->engine().recorder();
  LongestGap gap;
  window().close();
  EXPECT_FALSE(window().session());
  EXPECT_TRUE(RunningWork::any()) << "it ends on other threads";
  EXPECT_TRUE(window().isVisible());
  ASSERT_TRUE(until([] { return !window().isVisible(); }));
  RecordProperty("longest_gap_ms", gap.ms());  // depends on the machine: a figure to read, not to assert
  EXPECT_TRUE(recorder.expired());
  EXPECT_FALSE(QDir(folder).exists()) << "a short history goes";
  const auto recorded = SessionFile::open(file.toStdString());
  ASSERT_TRUE(recorded) << recorded.error().text();
  EXPECT_TRUE((*recorded)->recovery().empty()) << "it was completed";
  ASSERT_EQ((*recorded)->contents().takes.size(), 1U);
  EXPECT_FALSE((*recorded)->contents().takes[0].interrupted);
}

}  // namespace
}  // namespace abrazo::app::closing_test
