#include "core/motion/joints/marker_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/text.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo::marker_words_test {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> names(const char* text) {
  std::vector<std::string> all;
  for (const std::string_view word : split_words(std::string_view(text))) all.emplace_back(word);
  return all;
}

/// Two laboratories' own names.
constexpr const char* joined =
    "lasi rasi rpsi lpsi fneck bneck fhead rhead lhead rshld relbtop relblow rwrtop rwrlow lshld lelbtop "
    "lelblow lwrtop lwrlow rkneefr rkneebk rkneeis lkneefr lknssbk lkneeis rankfr rankis rankbk lankfr "
    "lankbk lankis";
constexpr const char* divided =
    "R.ASIS L.ASIS V.Sacral R.Acromium L.Acromium R.Elbow.Lat L.Elbow.Lat R.Elbow.Med L.Elbow.Med R.Wrist "
    "L.Wrist R.Knee.Lat L.Knee.Lat R.Knee.Med L.Knee.Med R.Ankle.Lat L.Ankle.Lat R.Toe L.Toe R.PSIS L.PSIS";

TEST(MarkerWords, PlaceMarkersBySideSegmentAndPlaceOnIt) {
  const auto model = marker_model_by_words(names(joined));
  ASSERT_TRUE(model);
  const auto at = [](const MarkerModel& of, MarkerPlace place, std::size_t side) {
    return of.names[static_cast<std::size_t>(place)][side];
  };
  EXPECT_THAT(at(*model, MarkerPlace::PelvisFront, 0), ElementsAre("lasi"));
  EXPECT_THAT(at(*model, MarkerPlace::Knee, 0), ElementsAre("lkneefr"));
  EXPECT_THAT(at(*model, MarkerPlace::KneeInner, 0), ElementsAre("lknssbk"))
      << "behind, with its typing error";
  EXPECT_THAT(at(*model, MarkerPlace::WristThumb, 1), ElementsAre("rwrtop"));
  EXPECT_THAT(at(*model, MarkerPlace::Neck, 0), ElementsAre("bneck"));
  EXPECT_THAT(at(*model, MarkerPlace::Ear, 1), ElementsAre("rhead"));
  const auto other = marker_model_by_words(names(divided));
  ASSERT_TRUE(other);
  EXPECT_THAT(at(*other, MarkerPlace::Knee, 1), ElementsAre("R.Knee.Lat"));
  EXPECT_THAT(at(*other, MarkerPlace::KneeInner, 1), ElementsAre("R.Knee.Med"));
  EXPECT_THAT(at(*other, MarkerPlace::Toe, 0), ElementsAre("L.Toe"));
}

TEST(MarkerWords, GiveNothingForAPartOfABody) {
  for (const char* part : {"rshld", "lwrtop lwrlow", "rankbk"}) {
    std::vector<std::string> all = names(joined);
    for (const std::string& gone : names(part)) std::erase(all, gone);
    EXPECT_FALSE(marker_model_by_words(all)) << part;
  }
  EXPECT_FALSE(marker_model_by_words(names("M1 M2 M3 M4 M5 M6 M7 M8 M9 M10 M11 M12 M13 M14")));
}

/// Ankles 10 cm deep, shins of 40 cm: the ball is 13 cm ahead and 10 cm below.
TEST(MarkerWords, ToesWithoutMarkersAreAheadOfTheAnkles) {
  NamedMotion markers;
  markers.points = names(joined);
  markers.parents.assign(markers.points.size(), -1);
  Positions frame = Positions::Zero(static_cast<Eigen::Index>(markers.points.size()), 3);
  const auto put = [&](const char* name, const Vec3& place) {
    frame.row(std::ranges::find(markers.points, name) - markers.points.begin()) = place.transpose();
  };
  put("lankfr", {0.1, 0.1, 0.05}), put("lankbk", {0.1, 0.1, -0.05});
  put("lkneefr", {0.1, 0.5, 0.05}), put("lknssbk", {0.1, 0.5, -0.05});
  markers.frames = {frame};
  const auto inferred = add_inferred_toes(*marker_model_by_words(markers.points), markers);
  EXPECT_THAT(inferred, ElementsAre(joints::left_toe_base, joints::right_toe_base));
  const auto toe = std::ranges::find(markers.points, "left toe, inferred") - markers.points.begin();
  EXPECT_LT((markers.frames[0].row(toe).transpose() - Vec3(0.1, 0, 0.13)).norm(), 1e-12);
}

TEST(MarkerWords, TellTwoPeopleOfOneFileByTheirPrefixes) {
  NamedMotion both;
  for (const std::string prefix : {"Z_", "N_"})
    for (const std::string& name : names(joined)) both.points.push_back(prefix + name);
  both.parents.assign(both.points.size(), -1);
  both.frames = {Positions::Zero(static_cast<Eigen::Index>(both.points.size()), 3)};
  const auto performers = split_performers(both);
  ASSERT_EQ(performers.size(), 2U);
  EXPECT_EQ(performers[0].name, "Z");
  EXPECT_EQ(performers[1].points, names(joined));
}

}  // namespace
}  // namespace abrazo::marker_words_test
