#include "core/bodies/take_retargeting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/base/atomic_file.hpp"
#include "core/choreography/salsa.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::take_retargeting_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Two takes of 12 frames, and an empty folder that is gone afterwards.
class TakeRetargeting : public testing::Test {
 protected:
  TakeRetargeting()
      : takes{test::swinging_take("slow", 12, 1), test::swinging_take("fast", 12, 2)},
        folder_(fs::temp_directory_path() / ("abrazo_take_retargeting_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    wish.takes = {"slow", "fast"};
    wish.active = *parse_body_choice("scale:0.9");
    wish.output = at("out.csv");
  }
  ~TakeRetargeting() override { fs::remove_all(folder_); }

  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
    std::ranges::sort(all);
    return all;
  }
  std::string refusal() const { return check_retargeting(wish, at("takes.json")).error().text(); }

  std::vector<PairedTake> takes;
  RetargetWish wish;

 private:
  fs::path folder_;
};

/// Two seconds of generated salsa.
PairedTake salsa() {
  ChoreographyOptions options;
  options.minutes = 0.2;
  PairedTake take = generate_salsa(options).front();
  for (Clip* clip : {&take.a, &take.b}) {
    clip->poses.erase(clip->poses.begin() + 300, clip->poses.end());
    clip->poses.erase(clip->poses.begin(), clip->poses.begin() + 180);
  }
  return take;
}

/// Mean change of the distance of joints of both bodies that are within 15 cm in the recording [m].
double contact_change(const RetargetedPair& pair) {
  double sum = 0;
  int contacts = 0;
  for (std::size_t f = 0; f < pair.frames.size(); ++f)
    for (int a = 0; a < joint_count; ++a)
      for (int b = 0; b < joint_count; ++b) {
        const double recorded =
            (pair.recorded.active.poses[f].row(a) - pair.recorded.passive.poses[f].row(b)).norm();
        if (recorded > 0.15) continue;
        const PairPose& made = pair.frames[f].pose;
        sum += std::abs((made.row(a) - made.row(b + joint_count)).norm() - recorded);
        ++contacts;
      }
  EXPECT_GT(contacts, 0);
  return sum / std::max(1, contacts);
}

/// Mean length of the second difference of all joints [m].
double roughness(const RetargetedPair& pair) {
  double sum = 0;
  for (std::size_t f = 1; f + 1 < pair.frames.size(); ++f)
    sum +=
        (pair.frames[f - 1].pose - 2 * pair.frames[f].pose + pair.frames[f + 1].pose).rowwise().norm().mean();
  return sum;
}

TEST_F(TakeRetargeting, TheWeightOfContactsKeepsThem) {
  const PairedTake take = salsa();
  wish.active = *parse_body_choice("scale:1.3");
  const auto change = [&](double contacts) {
    wish.contacts = contacts;
    const auto made = retarget_take(take, wish);
    EXPECT_TRUE(made);
    return contact_change(made->pair);
  };
  const double without = change(0), usual = change(1), strong = change(4);
  EXPECT_LT(usual, without);
  EXPECT_LT(strong, usual);
}

TEST_F(TakeRetargeting, TheWeightOfSmoothnessSmooths) {
  const PairedTake take = salsa();
  wish.active = *parse_body_choice("scale:1.3");
  const auto rough = [&](double smoothness) {
    wish.smoothness = smoothness;
    const auto made = retarget_take(take, wish);
    EXPECT_TRUE(made);
    return roughness(made->pair);
  };
  EXPECT_LT(rough(4), rough(0));
}

TEST_F(TakeRetargeting, WeightsAreFactorsFromZeroToFour) {
  for (const double wrong : {-0.1, 4.1, std::numeric_limits<double>::quiet_NaN()}) {
    wish.contacts = wrong;
    EXPECT_THAT(refusal(), HasSubstr("a factor from 0 to 4 is expected for contacts"));
    wish.contacts = 1;
    wish.smoothness = wrong;
    EXPECT_THAT(refusal(), HasSubstr("a factor from 0 to 4 is expected for smoothness"));
    wish.smoothness = 1;
  }
}

TEST_F(TakeRetargeting, EveryTakeHasFilesOfItsOwn) {
  wish.trace = at("out.jsonl");
  const auto done = retarget_takes(takes, wish, "takes.json");
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_THAT(names(), ElementsAre("out_fast.csv", "out_fast.jsonl", "out_slow.csv", "out_slow.jsonl"));
  ASSERT_EQ(done->size(), 2u);
  EXPECT_EQ(done->front().name, "slow");
  EXPECT_EQ(done->front().frames, 12u);
  EXPECT_THAT(done->front().motion_files, ElementsAre(at("out_slow.csv")));
  EXPECT_THAT(done->front().bodies_text(), HasSubstr("12 frames, active scale:0.9 ("));
}

TEST_F(TakeRetargeting, OneTakeHasTheNameOfTheOutput) {
  wish.takes = {"slow"};
  takes.pop_back();
  wish.from = 2;
  wish.to = 7;
  const auto done = retarget_takes(takes, wish, "takes.json");
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_THAT(names(), ElementsAre("out.csv"));
  EXPECT_EQ(done->front().frames, 5u);
}

TEST_F(TakeRetargeting, ACharacterPerformsBothMotions) {
  ASSERT_TRUE(write_whole_file(at("rig.vrm"), test::rig(test::Naming::Vrm1)));
  wish.character = at("rig.vrm");
  wish.output = at("out.glb");
  const auto done = retarget_takes(takes, wish, "takes.json");
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_THAT(names(), ElementsAre("out_fast_active.glb", "out_fast_passive.glb", "out_slow_active.glb",
                                   "out_slow_passive.glb", "rig.vrm"));
}

TEST_F(TakeRetargeting, CancelledInTheLastTakeItLeavesNothing) {
  wish.trace = at("out.jsonl");
  const auto done = retarget_takes(takes, wish, "takes.json", [](double fraction, std::string_view doing) {
    return !(doing.starts_with("fast: ") && fraction > 0.9);
  });
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text(), HasSubstr("cancelled"));
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(TakeRetargeting, OfATakeThatCannotBeMadeNoOtherIsWritten) {
  takes[1] = test::swinging_take("fast", 6, 2);
  wish.from = 8;
  const auto done = retarget_takes(takes, wish, "takes.json");
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text(), HasSubstr("take fast"));
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(TakeRetargeting, TheMotionsOfAManifestAreNotReplaced) {
  ASSERT_TRUE(write_whole_file(at("takes.json"), R"({"name": "set", "takes": [{"name": "slow",
    "a": {"motion": "slow_a.amc", "skeleton": "a.asf"}, "b": {"motion": "slow_b.bvh"}}]})"));
  wish.takes = {"slow"};
  ASSERT_TRUE(write_whole_file(at("slow_b.bvh"), "recorded"));
  wish.output = at("slow_b.bvh");
  EXPECT_THAT(refusal(), HasSubstr("is also read; the output needs another name"));
  wish.output = at("other.bvh");
  wish.trace = at("slow_b.bvh");
  EXPECT_THAT(refusal(), HasSubstr("is also read"));
  wish.trace.clear();
  EXPECT_TRUE(check_retargeting(wish, at("takes.json")));
}

TEST_F(TakeRetargeting, WhatCannotBeWrittenIsSaidBefore) {
  EXPECT_TRUE(check_retargeting(wish, ""));
  wish.takes.clear();
  EXPECT_THAT(refusal(), HasSubstr("no take is chosen"));
  wish.takes = {"slow", "slow"};
  EXPECT_THAT(refusal(), HasSubstr("choose each take once"));
  wish.takes = {"slow", "fast"};
  wish.active = *parse_body_choice("user");
  EXPECT_THAT(refusal(), HasSubstr("a recorded pair has no user"));
  wish.active = {};
  wish.trace = wish.output;
  EXPECT_THAT(refusal(), HasSubstr("cannot share a file"));
  wish.trace.clear();
  wish.output = at("out.fbx");
  EXPECT_THAT(refusal(), HasSubstr("this file type cannot be written"));
  wish.output = at("gone/out.csv");
  EXPECT_THAT(refusal(), HasSubstr("the folder does not exist"));
  wish.character = at("rig.vrm");
  wish.output = at("out.csv");
  EXPECT_THAT(refusal(), HasSubstr(".glb or .vrm"));
}

TEST_F(TakeRetargeting, TheNameOfATakeLeadsToNoOtherFolder) {
  wish.takes = {"../../slow", "fast"};
  EXPECT_THAT(wish.motion_files("../../slow"), ElementsAre(at("out_.._.._slow.csv")));
}

TEST_F(TakeRetargeting, AnInputIsNotReplaced) {
  ASSERT_TRUE(write_whole_file(at("out_slow.csv"), "an input"));
  wish.passive = *parse_body_choice(at("out_slow.csv"));
  EXPECT_THAT(refusal(), HasSubstr("is also read"));
}

}  // namespace
}  // namespace abrazo::take_retargeting_test
