#include "core/motion/body/body_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/bodies.hpp"

namespace abrazo::body_choice_test {
namespace {

using ::testing::HasSubstr;
using Kind = BodyChoice::Kind;

TEST(BodyChoice, IsAKeywordASizeOrAFile) {
  EXPECT_EQ(*parse_body_choice("library"), BodyChoice{});
  EXPECT_EQ(*parse_body_choice(" user "), (BodyChoice{.kind = Kind::User}));
  EXPECT_EQ(*parse_body_choice("scale:0.85"), (BodyChoice{.kind = Kind::Scaled, .scale = 0.85}));
  EXPECT_EQ(*parse_body_choice("walk 2.bvh"), (BodyChoice{.kind = Kind::OfFile, .file = "walk 2.bvh"}));
}

TEST(BodyChoice, ReadsBackFromItsText) {
  for (const BodyChoice& choice :
       {BodyChoice{}, BodyChoice{.kind = Kind::User}, BodyChoice{.kind = Kind::Scaled, .scale = 1.0 / 3},
        BodyChoice{.kind = Kind::OfFile, .file = "a/b.bvh"}})
    EXPECT_EQ(*parse_body_choice(body_choice_text(choice)), choice);
  // A file that is called like a keyword is told from it by its folder.
  EXPECT_EQ(body_choice_text({.kind = Kind::OfFile, .file = "user"}), "./user");
  EXPECT_EQ(parse_body_choice("./user")->kind, Kind::OfFile);
}

TEST(BodyChoice, ASizeThatIsNoneIsRefusedWithItsRange) {
  for (const char* text :
       {"scale:", "scale:tall", "scale:0.29", "scale:3.01", "scale:-1", "scale:nan", "scale:1e999"}) {
    const auto choice = parse_body_choice(text);
    ASSERT_FALSE(choice) << text;
    EXPECT_THAT(choice.error().message, HasSubstr("a number from 0.3 to 3 is expected")) << text;
  }
  EXPECT_THAT(parse_body_choice("  ").error().message, HasSubstr("library, user, scale:NUMBER"));
}

TEST(BodyChoice, AScaledBodyHasEveryLengthScaled) {
  const Body body = body_of(test::standing_pose());
  const Body measured = body_of(Pose(1.3 * test::standing_pose()));
  const Body scaled = scaled_body(body, 1.3);
  EXPECT_LT(largest_length_difference(scaled, measured), 1e-12);
  EXPECT_NEAR(scaled.toe_rest_height, measured.toe_rest_height, 1e-12);
  for (std::size_t i = 0; i < body.pseudo_lengths.size(); ++i)
    EXPECT_NEAR(scaled.pseudo_lengths[i], measured.pseudo_lengths[i], 1e-12);
}

}  // namespace
}  // namespace abrazo::body_choice_test
