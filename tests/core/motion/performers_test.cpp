#include "core/motion/joints/performers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::performers_test {
namespace {

using test::the_warning;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Names of a whole body that every reader knows.
std::vector<std::string> body(const std::string& before = "") {
  std::vector<std::string> points;
  for (const std::string_view joint : joint_names) points.push_back(before + std::string(joint));
  return points;
}

std::vector<std::string> box(const std::string& before, int corners = 8) {
  std::vector<std::string> points;
  for (int corner = 1; corner <= corners; ++corner) points.push_back(before + "M" + std::to_string(corner));
  return points;
}

NamedMotion capture(const std::vector<std::vector<std::string>>& parts) {
  NamedMotion motion;
  motion.name = "evening";
  for (const auto& part : parts) motion.points.insert(motion.points.end(), part.begin(), part.end());
  motion.parents.assign(motion.points.size(), -1);
  motion.frames.emplace_back(Positions::Zero(static_cast<Eigen::Index>(motion.points.size()), 3));
  for (Eigen::Index p = 0; p < motion.frames[0].rows(); ++p) motion.frames[0](p, 0) = static_cast<double>(p);
  return motion;
}

std::vector<std::string> names_of(const std::vector<NamedMotion>& performers) {
  std::vector<std::string> names;
  for (const NamedMotion& performer : performers) names.push_back(performer.name);
  return names;
}

TEST(Performers, AreToldByThePrefixOfTheirPoints) {
  const auto performers = split_performers(capture({body("Anna:"), body("Ben:"), box("Ball:", 4)}));
  EXPECT_THAT(names_of(performers), ElementsAre("Anna", "Ben"));
  EXPECT_EQ(performers[1].points, body());
  EXPECT_EQ(performers[1].frames[0](0, 0), joint_count) << "the places go with the names";
  EXPECT_THAT(the_warning(performers[0].warnings, "left-out").detail, HasSubstr("4 points"));
}

TEST(Performers, APersonWithoutPrefixIsNotLostBesideABoxThatHasOne) {
  const auto performers = split_performers(capture({body(), box("Box:")}));
  EXPECT_THAT(names_of(performers), ElementsAre("evening", "Box"));
  EXPECT_EQ(performers[0].points, body());
}

TEST(Performers, OfTwoOnlyTheSecondMayHaveAPrefix) {
  EXPECT_THAT(names_of(split_performers(capture({body(), body("Ben:")}))), ElementsAre("evening", "Ben"));
}

TEST(Performers, LooseMarkersBesideAPersonAreNobody) {
  const auto performers = split_performers(capture({box("", 12), body("Anna:")}));
  EXPECT_THAT(names_of(performers), ElementsAre("Anna"));
  EXPECT_THAT(the_warning(performers[0].warnings, "left-out").detail, HasSubstr("12 points"));
}

TEST(Performers, OtherMarksEndAPrefixWhereThatGivesABody) {
  for (const std::string mark : {"_", "-", ".", " "}) {
    SCOPED_TRACE("'" + mark + "'");
    const auto performers =
        split_performers(capture({body("Anna" + mark), body("Ben" + mark), box("Box" + mark)}));
    EXPECT_THAT(names_of(performers), ElementsAre("Anna", "Ben", "Box"));
    EXPECT_EQ(performers[0].points, body());
    EXPECT_THAT(names_of(split_performers(capture({body("S1" + mark), box("Ball" + mark, 4)}))),
                ElementsAre("S1"));
  }
}

TEST(Performers, MarksInNamesDivideNobody) {
  std::vector<std::string> unknown;
  for (const char* side : {"L_", "R_", "pelvis_", "trunk_"})
    for (int n = 0; n < 9; ++n) unknown.push_back(side + std::to_string(n));
  const auto whole = split_performers(capture({unknown}));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].points, unknown);
}

}  // namespace
}  // namespace abrazo::performers_test
