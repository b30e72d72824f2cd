// A file's markers named by a guess and by a person, and what is saved of it.
#include "core/motion/joints/marker_naming.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/marker_body.hpp"

namespace abrazo::marker_naming_test {
namespace {

using ::testing::HasSubstr;
using By = MarkerNaming::By;

/// A guess of four points: one sure, one likely, one doubtful, one without a place.
MarkerGuess a_guess() {
  MarkerGuess guess;
  guess.markers = {
      {0, MarkerPlace::Neck, 0, 0.9}, {1, MarkerPlace::Knee, 0, 0.45}, {2, MarkerPlace::Knee, 1, 0.1}};
  return guess;
}

const std::vector<std::string> four = {"M1", "M2", "M3", "M4"};

std::size_t places_in(const MarkerModel& model) {
  std::size_t count = 0;
  for (const auto& sides : model.names)
    for (const auto& names : sides) count += names.empty() ? 0 : 1;
  return count;
}

TEST(MarkerNaming, SureOnesAreFilledInAndOthersProposed) {
  MarkerNaming naming(four);
  naming.propose(a_guess());
  EXPECT_EQ(naming.belief_in(0), "sure");
  EXPECT_EQ(naming.belief_in(1), "likely");
  EXPECT_EQ(naming.belief_in(2), "doubtful");
  EXPECT_EQ(naming.belief_in(3), "");
  EXPECT_EQ(naming.place_of(1), "left knee");
  EXPECT_EQ(naming.counted(), "3 of 4 markers guessed, 1 sure");
  EXPECT_EQ(places_in(naming.model("mine")), 1U) << "a proposal is not part of the model";
}

TEST(MarkerNaming, AnAcceptedProposalIsPartOfTheModel) {
  MarkerNaming naming(four);
  naming.propose(a_guess());
  EXPECT_TRUE(naming.accept(1));
  EXPECT_FALSE(naming.accept(3)) << "nothing was guessed of it";
  EXPECT_EQ(naming.belief_in(1), "said");
  EXPECT_EQ(naming.counted(), "2 of 4 markers guessed, 1 sure; 1 said");
  EXPECT_EQ(places_in(naming.model("mine")), 2U);
}

TEST(MarkerNaming, AGuessOverwritesNothingThatAPersonSaid) {
  MarkerNaming naming(four);
  ASSERT_TRUE(naming.say(0, "sternum"));
  ASSERT_TRUE(naming.say(3, "left knee"));
  naming.propose(a_guess());
  EXPECT_EQ(naming.place_of(0), "sternum");
  EXPECT_EQ(naming.place_of(3), "left knee");
  EXPECT_EQ(naming.place_of(1), "") << "the place belongs to the fourth point";
  EXPECT_EQ(naming.place_of(2), "right knee");
}

TEST(MarkerNaming, APlaceBelongsToOneMarker) {
  MarkerNaming naming(four);
  naming.propose(a_guess());
  ASSERT_TRUE(naming.say(3, "neck"));
  EXPECT_EQ(naming.place_of(0), "") << "the guess gives way";
  const Status again = naming.say(0, "neck");
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("already M4"));
  ASSERT_TRUE(naming.say(3, ""));
  EXPECT_TRUE(naming.say(0, "neck"));
}

TEST(MarkerNaming, AnUnknownPlaceIsRefusedWithTheKnownOnes) {
  MarkerNaming naming(four);
  const Status said = naming.say(0, "left tail");
  ASSERT_FALSE(said);
  EXPECT_THAT(said.error().message, HasSubstr("no place 'left tail'"));
  EXPECT_THAT(said.error().message, HasSubstr("left knee"));
  EXPECT_EQ(naming.place_of(0), "");
}

TEST(MarkerNaming, AModelOfOtherPointsIsRefusedAndChangesNothing) {
  MarkerNaming naming(four);
  naming.propose(a_guess());
  MarkerModel other;
  other.name = "other";
  other.names[0][0] = {"C7"};
  const auto read = naming.read(other);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text(), HasSubstr("none of the 4 points"));
  EXPECT_EQ(naming.place_of(0), "neck");
}

/// Every marker of a body that walks ahead, with names that say nothing, in an order of its own.
NamedMotion nameless(NamedMotion motion, const std::string& prefix) {
  std::vector<std::string> names;
  for (std::size_t p = 0; p < motion.points.size(); ++p) names.push_back(prefix + std::to_string(p + 1));
  motion.points = names;
  return motion;
}

/// A body that the guess was not made with: taller and narrower or shorter and broader, arms and legs longer
/// or shorter, measured with noise.
NamedMotion another_person(double tall, double broad, double deep) {
  NamedMotion motion = test::marked_body(60, 0.3).markers;
  unsigned seed = 12345;
  const auto noise = [&seed] {
    seed = seed * 1664525U + 1013904223U;
    return 0.004 * (static_cast<double>(seed >> 8U) / (1U << 24U) - 0.5);
  };
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.03 * static_cast<double>(f), Vec3::UnitY()).toRotationMatrix();
    Positions& frame = motion.frames[f];
    for (Eigen::Index p = 0; p < frame.rows(); ++p) {
      const Vec3 in_body = Vec3(broad, tall, deep).cwiseProduct(turn.transpose() * frame.row(p).transpose());
      frame.row(p) = (turn * in_body + Vec3(noise(), noise(), noise())).transpose();
    }
  }
  return motion;
}

TEST(MarkerNaming, WhatIsSureIsRightOnOtherBodies) {
  const MarkerModel& known = builtin_marker_models().front();
  for (const auto& [tall, broad, deep] :
       {std::array{1.12, 0.95, 1.0}, {0.9, 1.0, 0.95}, {1.0, 1.1, 1.1}, {1.05, 0.9, 0.9}}) {
    const NamedMotion named = another_person(tall, broad, deep);
    const NamedMotion unnamed = nameless(named, "U");
    ASSERT_TRUE(names_say_nothing(unnamed));
    const auto guess = guess_markers(unnamed);
    ASSERT_TRUE(guess) << guess.error().text();
    MarkerNaming naming(unnamed.points);
    naming.propose(*guess);
    int sure = 0;
    for (std::size_t p = 0; p < named.points.size(); ++p) {
      const MarkerNaming::Row& row = naming.rows()[p];
      if (row.by != By::Guess) continue;
      ++sure;
      EXPECT_THAT(known.names[static_cast<std::size_t>(row.place)][row.side],
                  ::testing::Contains(named.points[p]))
          << "guessed as " << naming.place_of(static_cast<int>(p)) << " of a body " << tall << " by "
          << broad;
    }
    EXPECT_GE(sure, 12);
  }
}

TEST(MarkerNaming, ASavedModelReadsBackToTheSameJoints) {
  // All names begin alike: the model has them as the file has.
  const NamedMotion named = test::marked_body(30, 0.15).markers;
  const NamedMotion unnamed = nameless(named, "Take_U");
  EXPECT_FALSE(names_say_nothing(named));
  MarkerNaming naming(unnamed.points);
  for (std::size_t place = 0; place < marker_place_count; ++place)
    for (const std::size_t side : {0U, 1U})
      for (const std::string& name : builtin_marker_models().front().names[place][side])
        if (const auto at = std::ranges::find(named.points, name); at != named.points.end()) {
          ASSERT_TRUE(naming.say(static_cast<int>(at - named.points.begin()),
                                 name_of_place(static_cast<MarkerPlace>(place), side)));
        }
  const MarkerModel model = naming.model("mine");
  const auto again = parse_marker_model(marker_model_json(model), "mine.json");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->names, model.names);
  MarkerNaming read(unnamed.points);
  ASSERT_TRUE(read.read(*again));
  EXPECT_EQ(read.model("mine").names, model.names);
  ImportOptions by_name, by_file;
  by_name.marker_model = builtin_marker_models().front();
  by_file.marker_model = *again;
  const auto expected = import_clip(named, by_name), found = import_clip(unnamed, by_file);
  ASSERT_TRUE(expected) << expected.error().text();
  ASSERT_TRUE(found) << found.error().text();
  ASSERT_EQ(found->clip.poses.size(), expected->clip.poses.size());
  for (std::size_t f = 0; f < found->clip.poses.size(); ++f)
    EXPECT_TRUE(found->clip.poses[f].isApprox(expected->clip.poses[f])) << "frame " << f;
}

}  // namespace
}  // namespace abrazo::marker_naming_test
