#include "app/workbench/base/trash.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <string>
#include <vector>

#include "app/workbench/document/session_places.hpp"

namespace abrazo::app::trash_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The environment variable has this value until the end of the test.
class Environment {
 public:
  Environment(const char* name, const QString& value)
      : name_(name), was_set_(qEnvironmentVariableIsSet(name)), was_(qgetenv(name)) {
    value.isNull() ? qunsetenv(name) : qputenv(name, value.toUtf8());
  }
  ~Environment() { was_set_ ? qputenv(name_, was_) : qunsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  bool was_set_;
  QByteArray was_;
};

void write(const QString& path) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(path.toUtf8()) > 0);
}

std::vector<std::string> names_in(const QString& folder) {
  std::vector<std::string> names;
  for (const QString& name : QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot))
    names.push_back(name.toStdString());
  return names;
}

/// A person with an empty home folder, a session elsewhere and the program in a third folder.
class Trash : public testing::Test {
 protected:
  Trash() {
    QDir().mkdir(sessions());
    QDir().mkdir(working());
    QDir().mkdir(home());
    QDir::setCurrent(working());
    for (const char* end : {"", "-wal", "-shm"}) write(session() + end);
  }
  ~Trash() override {
    EXPECT_THAT(names_in(working()), IsEmpty()) << "nothing appears in the working folder";
    QDir::setCurrent(before_);
  }

  QString home() const { return folder_.filePath("home"); }
  QString sessions() const { return folder_.filePath("sessions"); }
  QString working() const { return folder_.filePath("working"); }
  QString session() const { return sessions() + "/evening.abrazo"; }
  static auto isWholeSession() {
    return ElementsAre("evening.abrazo", "evening.abrazo-shm", "evening.abrazo-wal");
  }

 private:
  const QString before_ = QDir::currentPath();
  const QTemporaryDir folder_;
  const Environment home_{"HOME", home()}, data_{"XDG_DATA_HOME", QString()};
};

TEST_F(Trash, IsMadeInAHomeFolderThatHasNone) {
  const Status discarded = discard_session(session());
  ASSERT_TRUE(discarded) << discarded.error().text();
  EXPECT_THAT(names_in(sessions()), IsEmpty());
  EXPECT_THAT(names_in(home() + "/.local/share/Trash/files"), isWholeSession());
  EXPECT_THAT(names_in(home() + "/.local/share/Trash/info"), SizeIs(3));
}

TEST_F(Trash, IsWhereTheDesktopKeepsItsData) {
  const Environment data("XDG_DATA_HOME", home() + "/data");
  ASSERT_TRUE(discard_session(session()));
  EXPECT_THAT(names_in(home() + "/data/Trash/files"), isWholeSession());
}

TEST_F(Trash, GivesAnotherNameToWhatIsThereAlready) {
  ASSERT_TRUE(discard_session(session()));
  write(session());
  ASSERT_TRUE(discard_session(session()));
  EXPECT_THAT(names_in(home() + "/.local/share/Trash/files"), SizeIs(4));
}

TEST_F(Trash, ThatCannotBeMadeLeavesTheSessionWhereItIs) {
  write(home() + "/.local");
  const Status discarded = discard_session(session());
  ASSERT_FALSE(discarded);
  EXPECT_THAT(discarded.error().text(), HasSubstr("there is no trash"));
  EXPECT_THAT(names_in(sessions()), isWholeSession());
  EXPECT_THAT(names_in(home()), ElementsAre(".local"));
}

TEST_F(Trash, IsNoneWhereTheDataFolderIsRelative) {
  const Environment data("XDG_DATA_HOME", "data");
  const bool is_discarded = discard_session(session()).ok();  // Qt 6 takes the home folder instead
  EXPECT_THAT(names_in(sessions()), SizeIs(is_discarded ? 0 : 3));
  EXPECT_THAT(names_in(home()), SizeIs(is_discarded ? 1 : 0));
}

/// The session's last file is a folder of the process file system: nothing moves it.
TEST_F(Trash, GetsAllFilesOrNone) {
  ASSERT_FALSE(move_to_trash(files_of_session(session()) << "/proc/self"));
  EXPECT_THAT(names_in(sessions()), isWholeSession());
  EXPECT_THAT(names_in(home() + "/.local/share/Trash/files"), IsEmpty());
  EXPECT_THAT(names_in(home() + "/.local/share/Trash/info"), IsEmpty());
}

TEST_F(Trash, SkipsFilesThatAreNotThere) {
  ASSERT_TRUE(QFile::remove(session() + "-shm"));
  ASSERT_TRUE(discard_session(session()));
  EXPECT_THAT(names_in(home() + "/.local/share/Trash/files"),
              ElementsAre("evening.abrazo", "evening.abrazo-wal"));
}

TEST_F(Trash, IsNotUsedForWhatIsRenamed) {
  ASSERT_TRUE(rename_session(session(), working() + "/morning.abrazo"));
  EXPECT_THAT(names_in(sessions()), IsEmpty());
  ASSERT_TRUE(rename_session(working() + "/morning.abrazo", session()));
  EXPECT_THAT(names_in(sessions()), isWholeSession());
}

TEST_F(Trash, AFileInTheWayOfARenamedSessionStopsAllOfIt) {
  const QString other = sessions() + "/other.abrazo";
  write(other);
  EXPECT_FALSE(rename_session(session(), other));
  EXPECT_THAT(names_in(sessions()),
              ElementsAre("evening.abrazo", "evening.abrazo-shm", "evening.abrazo-wal", "other.abrazo"));
}

}  // namespace
}  // namespace abrazo::app::trash_test
