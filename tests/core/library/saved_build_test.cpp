#include "core/library/build/saved_build.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/library/store/motion_library_file.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::saved_build_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

class SavedBuild : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) /
             (std::string("abrazo_saved_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder / "motions");
    fs::create_directories(folder / "out");
    const PairedTake take = test::circling_take("t", 300);
    std::ofstream(folder / "motions/a.bvh") << *write_bvh(std::vector<Clip>{take.a});
    std::ofstream(folder / "motions/b.bvh") << *write_bvh(std::vector<Clip>{take.b});
    Manifest::Take described;
    described.name = "t";
    described.a.motion = folder / "motions/a.bvh";
    described.b.motion = folder / "motions/b.bvh";
    manifest.name = "saved";
    manifest.takes = {described};
    files = {folder / "out/l.h5", folder / "out/l.json"};
  }
  void TearDown() override { fs::remove_all(folder); }
  std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder / "out")) names.push_back(entry.path().filename());
    return names;
  }
  fs::path folder;
  Manifest manifest;
  BuildFiles files;
  std::vector<std::string> warnings;
};

TEST_F(SavedBuild, WritesALibraryAndTheManifestThatRepeatsIt) {
  const auto built = build_and_save(manifest, files, {}, warnings);
  ASSERT_TRUE(built.ok()) << built.error().text();
  const auto read = read_library(files.library);
  ASSERT_TRUE(read.ok()) << read.error().text();
  const auto again = read_manifest(files.manifest);
  ASSERT_TRUE(again.ok()) << again.error().text();
  const auto rebuilt = build_and_save(*again, {}, {}, warnings);
  ASSERT_TRUE(rebuilt.ok()) << rebuilt.error().text();
  EXPECT_EQ(rebuilt->columns().poses, built->columns().poses);
  EXPECT_EQ(read->pair_count(), built->pair_count());
  EXPECT_THAT(left(), UnorderedElementsAre("l.h5", "l.json"));
}

TEST_F(SavedBuild, StoppedAtAnyPointLeavesNothingBehind) {
  for (const double stop : {0.0, 0.2, 0.5, 0.79, 0.85, 0.95}) {
    const auto built = build_and_save(
        manifest, files, [stop](double fraction, std::string_view) { return fraction < stop; }, warnings);
    ASSERT_FALSE(built.ok()) << stop;
    EXPECT_EQ(built.error().message, "cancelled") << stop;
    EXPECT_TRUE(left().empty()) << stop;
  }
}

TEST_F(SavedBuild, WithABadPlaceForTheManifestWritesNoLibraryEither) {
  files.manifest = folder / "nowhere/l.json";
  const auto built = build_and_save(manifest, files, {}, warnings);
  ASSERT_FALSE(built.ok());
  EXPECT_THAT(built.error().text(), HasSubstr("nowhere/l.json"));
  EXPECT_TRUE(left().empty());
}

TEST_F(SavedBuild, WithABadPlaceForTheLibraryWritesNoManifestEither) {
  files.library = folder / "nowhere/l.h5";
  ASSERT_FALSE(build_and_save(manifest, files, {}, warnings).ok());
  EXPECT_TRUE(left().empty());
}

}  // namespace
}  // namespace abrazo::saved_build_test
