// The workbench is killed while it saves, at random moments: the project on disk is the old or the new one,
// whole, and what was not saved is offered. ABRAZO_KILLS says how often (3 of each kind by default),
// ABRAZO_SEED where the random moments begin.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QTemporaryDir>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <thread>

#include "app/workbench/project/autosave.hpp"
#include "core/opening/opened_session.hpp"
#include "tests/workbench/process.hpp"

namespace abrazo::app::save_killed_test {
namespace {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of the session and of its takes.
std::size_t markers_in(const OpenedSession& session) {
  const Project& project = session.project->project();
  std::size_t count = project.markers.all().size();
  for (const auto& [take, markers] : project.take_markers) count += markers.all().size();
  return count;
}

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

/// What the victim said until it was killed.
struct Said {
  std::size_t saved = 0, saving = 0;  ///< markers that were saved, and that may be
  std::size_t settled = 0;            ///< markers that were there long before the end
  int refused = 0, saves = 0;
};

class SaveKilled : public testing::Test {
 protected:
  SaveKilled()
      : display_(become_display), random_(static_cast<unsigned>(number_from("ABRAZO_SEED", 20261123))) {}
  void SetUp() override {
    number_ = display_.line();
    if (number_.empty()) GTEST_SKIP() << "needs Xvfb";
  }

  /// @param full  called when it has saved once
  Said killed_while_saving(const std::string& file, const std::function<void()>& full = {}) {
    const QTemporaryDir home;
    qputenv("ABRAZO_HOME", home.path().toUtf8());
    Process victim([&] {
      use_display(number_);
      execl(ABRAZO_SAVING_VICTIM, ABRAZO_SAVING_VICTIM, file.c_str(), nullptr);
    });
    Said said;
    std::vector<std::pair<std::size_t, double>> marked;
    const auto take = [&](const std::string& line) {
      std::istringstream words(line);
      std::string what;
      std::size_t markers = 0;
      double at_s = 0;
      words >> what >> markers >> at_s;
      if (what == "marked") marked.emplace_back(markers, at_s);
      if (what == "saving") said.saving = markers;
      if (what == "refused") ++said.refused;
      if (what == "saved") said.saved = markers, ++said.saves;
    };
    const auto listen_until = [&](const auto& reached) {
      while (!reached()) {
        const std::string line = victim.line();
        if (line.empty()) return false;
        take(line);
      }
      return true;
    };
    if (!listen_until([&] { return said.saves > 0; })) {
      ADD_FAILURE() << "it ended by itself";
      return said;
    }
    if (full) full();
    // Anywhere, or while it saves for the third time or so.
    const bool amid = std::bernoulli_distribution(0.5)(random_);
    const std::size_t before = said.saving;
    if (amid && !listen_until([&] { return said.saving > before + 1; }))
      ADD_FAILURE() << "it ended by itself";
    std::uniform_real_distribution<double> moments(amid ? 0.0 : 0.2, amid ? 0.06 : 5.0);
    std::this_thread::sleep_for(std::chrono::duration<double>(moments(random_)));
    const double killed_s = now_s();
    victim.end(SIGKILL);
    for (std::string line = victim.line(); !line.empty(); line = victim.line()) take(line);
    constexpr double on_disk_within_s = 2;
    for (const auto& [markers, at_s] : marked)
      if (at_s < killed_s - on_disk_within_s) said.settled = markers;
    ++runs_;
    saves_ += said.saves + said.refused;
    judge(file, (home.path() + "/autosave").toStdString(), said, static_cast<bool>(full));
    return said;
  }

  static void judge(const std::string& file, const std::string& autosaves, const Said& said, bool is_full) {
    const auto alone = open_session(file);
    ASSERT_TRUE(alone) << alone.error().text();
    EXPECT_TRUE(alone->damage().empty()) << alone->damage().front();
    ASSERT_TRUE(alone->project);
    const std::size_t found = markers_in(*alone);
    EXPECT_TRUE(found == said.saved || found == said.saving)
        << found << " markers, saved were " << said.saved << ", being saved " << said.saving;
    const QStringList left = Autosave::leftBehind(QString::fromStdString(autosaves));
    std::size_t offered = found;
    for (const QString& autosave : left) {
      const auto kept = open_session(autosave.toStdString(), autosaves);
      ASSERT_TRUE(kept) << kept.error().text();
      offered = std::max(offered, markers_in(*kept));
      EXPECT_EQ(session_of_autosave(autosave).toStdString(), file);
    }
    EXPECT_GE(offered, said.settled) << "saved " << said.saved << ", " << left.size() << " offered";
    std::printf("saved %zu (%d times, %d refused)%s, found %zu, offered %zu of %zu\n", said.saved, said.saves,
                said.refused, is_full ? ", then the disk was full" : "", found, offered, said.settled);
  }

  /// That it did save again and again, and was not killed before it came to that.
  void TearDown() override {
    if (!number_.empty() && !HasFailure() && !IsSkipped()) {
      EXPECT_GT(saves_, runs_);
    }
  }

  int saves_ = 0, runs_ = 0;
  const int kills_ = number_from("ABRAZO_KILLS", 3);
  Process display_;
  std::string number_;
  std::mt19937 random_;
};

TEST_F(SaveKilled, TheProjectIsTheOldOrTheNewOneAndTheRestIsOffered) {
  for (int kill = 0; kill < kills_; ++kill) {
    const QTemporaryDir folder;
    killed_while_saving((folder.path() + "/waltz.abrazo").toStdString());
  }
}

TEST_F(SaveKilled, AlsoOnAnotherFileSystem) {
  for (int kill = 0; kill < (kills_ + 2) / 3; ++kill) {
    const QTemporaryDir folder("/dev/shm/abrazo-XXXXXX");
    if (!folder.isValid()) GTEST_SKIP() << "needs /dev/shm";
    killed_while_saving((folder.path() + "/waltz.abrazo").toStdString());
  }
}

/// A small file system of its own; gone afterwards.
class SmallDisk {
 public:
  SmallDisk() : is_there_(mount("none", folder().c_str(), "tmpfs", 0, "size=4m") == 0) {}
  ~SmallDisk() {
    if (is_there_) umount2(folder().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool is_there() const { return is_there_; }
  std::string folder() const { return folder_.path().toStdString(); }
  void fill() const {
    std::ofstream filler(folder() + "/filler", std::ios::binary);
    const std::string piece(4096, 'x');
    while (filler.write(piece.data(), 4096) && filler.flush()) {
    }
  }

 private:
  QTemporaryDir folder_;
  bool is_there_;
};

TEST_F(SaveKilled, AlsoOnADiskThatIsFull) {
  for (int kill = 0; kill < (kills_ + 2) / 3; ++kill) {
    const SmallDisk disk;
    if (!disk.is_there()) GTEST_SKIP() << "needs the right to mount a file system";
    killed_while_saving(disk.folder() + "/waltz.abrazo", [&disk] { disk.fill(); });
  }
}

QStringList complaints;

TEST(Autosave, ThatIsNotNeededAnyMoreGoesWithItsLockAndWithoutAComplaint) {
  int count = 1;
  char name[] = "test";
  char* words[] = {name, nullptr};
  const QCoreApplication application(count, words);
  const QTemporaryDir folder;
  const auto before = qInstallMessageHandler(
      [](QtMsgType, const QMessageLogContext&, const QString& text) { complaints << text; });
  {
    Autosave autosave(folder.path());
    QEventLoop kept;
    QObject::connect(&autosave, &Autosave::kept, &kept, &QEventLoop::quit);
    autosave.keep({}, {});
    kept.exec();
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 2) << "the file and its lock";
    autosave.drop();
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList());
  }
  qInstallMessageHandler(before);
  EXPECT_TRUE(complaints.isEmpty()) << complaints.join("\n").toStdString();
}

}  // namespace
}  // namespace abrazo::app::save_killed_test
