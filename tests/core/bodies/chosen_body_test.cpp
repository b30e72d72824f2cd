#include "core/bodies/chosen_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "core/motion/files/clip_file.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::chosen_body_test {
namespace {

using ::testing::HasSubstr;
using Kind = BodyChoice::Kind;

class ChosenBody : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  static Clip clip(double scale) { return {"one", 60, std::vector<Pose>(5, scale * test::standing_pose())}; }

  static Clip named(const std::string& name) {
    Clip one = clip(1);
    one.name = name;
    return one;
  }

  Body recorded_ = body_of(test::standing_pose());

 private:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ChosenBody, OfTheLibraryOrASizeComesFromTheRecordedOne) {
  EXPECT_EQ(choose_body({}, recorded_)->body.bone_lengths, recorded_.bone_lengths);
  const auto small = choose_body({.kind = Kind::Scaled, .scale = 0.7}, recorded_);
  EXPECT_NEAR(small->body.height(), 0.7 * recorded_.height(), 1e-12);
  EXPECT_EQ(small->name, "scale:0.7");
}

TEST_F(ChosenBody, OfAFileIsMeasuredInItAndNamedByIt) {
  ASSERT_TRUE(write_clip_file(file("tall.csv"), std::array{clip(1.1)}));
  const auto tall = choose_body({.kind = Kind::OfFile, .file = file("tall.csv")}, recorded_);
  ASSERT_TRUE(tall) << tall.error().text();
  EXPECT_EQ(tall->name, "tall.csv");
  EXPECT_LT(largest_length_difference(tall->body, scaled_body(recorded_, 1.1)), 1e-6);
}

TEST_F(ChosenBody, AFileThatGivesNoBodyIsRefusedWithItsName) {
  const auto refused = [&](const std::string& name) {
    const auto body = choose_body({.kind = Kind::OfFile, .file = file(name)}, recorded_);
    return body ? std::string() : body.error().text();
  };
  EXPECT_THAT(refused("gone.bvh"), HasSubstr("gone.bvh"));
  ASSERT_TRUE(write_clip_file(file("pair.csv"), std::array{named("a"), named("b")}));
  EXPECT_THAT(refused("pair.csv"), HasSubstr("holds 2 performers"));
}

TEST_F(ChosenBody, ARecordedPairHasNoUser) {
  EXPECT_THAT(choose_body({.kind = Kind::User}, recorded_).error().text(), HasSubstr("has no user"));
}

}  // namespace
}  // namespace abrazo::chosen_body_test
