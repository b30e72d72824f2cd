// One window at a time may change a session file.
#include "app/workbench/takes/session_hold.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace abrazo::app::session_hold_test {
namespace {

class SessionHoldTest : public testing::Test {
 protected:
  void SetUp() override { QFile(session).open(QIODevice::WriteOnly); }

  QTemporaryDir folder;
  const QString session = folder.filePath("s.abrazo"), lock = folder.filePath(".s.abrazo.lock");
  SessionHold hold;
};

TEST_F(SessionHoldTest, IsOfOneWindow) {
  SessionHold other;
  EXPECT_TRUE(hold.take(session));
  EXPECT_TRUE(hold.take(session)) << "it has it already";
  EXPECT_FALSE(other.take(session));
  EXPECT_TRUE(other.isOfAnother());
  EXPECT_TRUE(other.holder().contains(QString("process %1 on ").arg(getpid())))
      << other.holder().toStdString();
  hold.release();
  EXPECT_TRUE(other.take(session)) << "it asks again";
  EXPECT_FALSE(other.isOfAnother());
}

TEST_F(SessionHoldTest, LeavesNothingBesideTheSession) {
  hold.take(session);
  EXPECT_TRUE(QFile::exists(lock));
  hold.take(folder.filePath("other.abrazo"));
  EXPECT_FALSE(QFile::exists(lock)) << "given up for another file";
  hold.release();
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{"s.abrazo"});
}

TEST_F(SessionHoldTest, ALinkToTheSessionIsTheSameSession) {
  SessionHold other;
  ASSERT_TRUE(QFile::link(session, folder.filePath("link.abrazo")));
  hold.take(session);
  EXPECT_FALSE(other.take(folder.filePath("link.abrazo")));
}

TEST_F(SessionHoldTest, EndsWithAProcessThatIsKilled) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    SessionHold of_child;
    const char held = of_child.take(session) ? 'y' : 'n';
    (void)!write(ready[1], &held, 1);
    pause();
    _exit(0);
  }
  char held = 0;
  ASSERT_EQ(read(ready[0], &held, 1), 1);
  EXPECT_EQ(held, 'y');
  EXPECT_FALSE(hold.take(session));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(QFile::exists(lock)) << "it was not tidied";
  EXPECT_TRUE(hold.take(session));
}

TEST_F(SessionHoldTest, WhereNoLockCanBeNobodyIsKeptAway) {
  EXPECT_TRUE(hold.take(""));
  EXPECT_TRUE(hold.take("/proc/s.abrazo"));
  ASSERT_EQ(mkfifo(lock.toUtf8(), 0600), 0);
  EXPECT_TRUE(hold.take(session)) << "a pipe in its place is not read";
}

}  // namespace
}  // namespace abrazo::app::session_hold_test
