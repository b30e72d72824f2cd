#include "core/base/output_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace abrazo::output_file_test {
namespace {

namespace fs = std::filesystem;

class WholeFilesTest : public testing::Test {
 protected:
  WholeFilesTest()
      : folder_(fs::temp_directory_path() / ("abrazo_whole_files_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~WholeFilesTest() override { fs::remove_all(folder_); }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  fs::path folder_;
};

TEST_F(WholeFilesTest, GetTheirNamesTogether) {
  WholeFiles files;
  ASSERT_TRUE(files.add(at("one"), "1"));
  ASSERT_TRUE(files.add(at("two"), "2"));
  EXPECT_FALSE(fs::exists(at("one")));
  ASSERT_TRUE(files.commit());
  EXPECT_EQ(read_whole_file(at("one")).value(), "1");
  EXPECT_EQ(read_whole_file(at("two")).value(), "2");
}

TEST_F(WholeFilesTest, NoneIsLeftIfOneCannotBeWritten) {
  ASSERT_TRUE(write_whole_file(at("one"), "old"));
  {
    WholeFiles written;
    ASSERT_TRUE(written.add(at("one"), "1"));
    EXPECT_FALSE(written.add(at("gone/two"), "2"));
  }
  EXPECT_EQ(read_whole_file(at("one")).value(), "old");
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace abrazo::output_file_test
