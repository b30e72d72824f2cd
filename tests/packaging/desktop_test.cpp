#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QMimeDatabase>
#include <cstdlib>
#include <fstream>

#include "core/session/file/project.hpp"
#include "tests/cli/run_command.hpp"
#include "tests/packaging/installed_files.hpp"

namespace abrazo::test::desktop_test {
namespace {

namespace fs = std::filesystem;

Outcome check(const std::vector<std::string>& words) {
  return RunningCommand(words, fs::temp_directory_path()).wait();
}

/// A desktop where the package is installed: the installed type beside the system's own, in one database.
class DesktopTypes : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string update = program_at("update-mime-database");
    const fs::path common = "/usr/share/mime/packages/freedesktop.org.xml";
    if (update.empty() || !fs::exists(common)) GTEST_SKIP() << "needs the package shared-mime-info";
    fs::create_directories(folder_ / "mime" / "packages");
    fs::copy_file(common, folder_ / "mime" / "packages" / "freedesktop.org.xml");
    fs::copy_file(installed("share/mime/packages/abrazo.xml"), folder_ / "mime" / "packages" / "abrazo.xml");
    const Outcome told = check({update, (folder_ / "mime").string()});
    ASSERT_EQ(told.status, 0) << told.err;
    ASSERT_TRUE(save_project(session().string(), {}));
    ::setenv("XDG_DATA_DIRS", folder_.c_str(), 1);
    ::setenv("XDG_DATA_HOME", (folder_ / "nobody").c_str(), 1);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string by_name(const fs::path& file) { return type_of(file, QMimeDatabase::MatchExtension); }
  static std::string by_content(const fs::path& file) { return type_of(file, QMimeDatabase::MatchContent); }

  fs::path written(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  fs::path session() const { return folder_ / "evening.abrazo"; }

 private:
  static std::string type_of(const fs::path& file, QMimeDatabase::MatchMode mode) {
    return QMimeDatabase().mimeTypeForFile(QString::fromStdString(file.string()), mode).name().toStdString();
  }

  const fs::path folder_ = fs::temp_directory_path() / ("abrazo-desktop-" + std::to_string(::getpid()));
};

TEST_F(DesktopTypes, KnowASessionByItsName) {
  EXPECT_EQ(by_name(session()), "application/x-abrazo-session");
}

TEST_F(DesktopTypes, KnowARenamedSessionByItsContent) {
  EXPECT_EQ(by_content(written("renamed", content_of(session()))), "application/x-abrazo-session");
}

TEST_F(DesktopTypes, TakeNoOtherDatabaseForASession) {
  std::string other = content_of(session());
  other[68] = 'X';  // the application's number
  EXPECT_EQ(by_content(written("other", other)), "application/vnd.sqlite3");
}

TEST(Desktop, EntryNamesWhatIsInstalled) {
  const std::string entry = content_of(installed("share/applications/abrazo.desktop"));
  EXPECT_THAT(entry, ::testing::HasSubstr("\nExec=abrazo-workbench %F\n"));
  EXPECT_THAT(entry, ::testing::HasSubstr("\nIcon=abrazo\n"));
  EXPECT_THAT(entry, ::testing::HasSubstr("\nMimeType=application/x-abrazo-session;\n"));
  const std::string validator = program_at("desktop-file-validate");
  if (validator.empty()) GTEST_SKIP() << "desktop-file-validate is not installed";
  const Outcome told = check({validator, installed("share/applications/abrazo.desktop").string()});
  EXPECT_EQ(told.status, 0);
  EXPECT_EQ(told.out + told.err, "");
}

TEST(Desktop, IconHasTheSizesItIsNamedAfter) {
  for (const int size : {16, 48, 128, 256}) {
    const std::string folder = std::to_string(size) + "x" + std::to_string(size);
    const std::string png = content_of(installed("share/icons/hicolor/" + folder + "/apps/abrazo.png"));
    ASSERT_GT(png.size(), 100U) << size;
    const auto number = [&](std::size_t at) {
      return static_cast<unsigned char>(png[at + 2]) * 256 + static_cast<unsigned char>(png[at + 3]);
    };
    EXPECT_EQ(number(16), size);
    EXPECT_EQ(number(20), size);
  }
}

}  // namespace
}  // namespace abrazo::test::desktop_test
