#include "core/base/result.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace abrazo::result_test {
namespace {

TEST(Result, HoldsAValue) {
  Result<int> result = 3;
  ASSERT_TRUE(result);
  EXPECT_EQ(*result, 3);
  *result = 4;
  EXPECT_EQ(result.value(), 4);
}

TEST(Result, HoldsTheReasonWhyThereIsNone) {
  const Result<int> result = Error{"expected 6 numbers", "walk.bvh:17"};
  EXPECT_FALSE(result);
  EXPECT_EQ(result.error().text(), "walk.bvh:17: expected 6 numbers");
}

TEST(Error, EndsWithTheWordsThatAProgramHasForItsHint) {
  const HintWords words = [](Hint hint) -> std::string_view {
    return hint == Hint::SetFrameRate ? " (--fps)" : "";
  };
  const Error error{"set the rate", "walk.trc", Hint::SetFrameRate};
  EXPECT_EQ(error.text(), "walk.trc: set the rate");
  EXPECT_EQ(error.text(words), "walk.trc: set the rate (--fps)");
  EXPECT_EQ((Error{"is empty", "walk.trc"}).text(words), "walk.trc: is empty");
  EXPECT_EQ((Warning{"120 fps was guessed", Hint::SetFrameRate}).text(words), "120 fps was guessed (--fps)");
}

TEST(Result, ThrowsWhenAskedForAValueThatIsNotThere) {
  const Result<int> result = Error{"no", ""};
  EXPECT_THROW(static_cast<void>(result.value()), std::logic_error);
}

TEST(Result, GivesUpAValueThatCannotBeCopied) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 5);
}

TEST(Error, IsOnlyItsMessageWhenThereIsNoPlace) {
  EXPECT_EQ((Error{"no clip", ""}).text(), "no clip");
}

TEST(Error, ShowsNothingThatSteersATerminal) {
  const Error error{"two joints are named '\x1b[2Jhip\x07\x7f', expected:\n\tone", "\rÜbung.bvh:3"};
  EXPECT_EQ(error.text(),
            "?Übung.bvh:3: two joints are named '?[2Jhip?"
            "?', expected:??one");
}

}  // namespace
}  // namespace abrazo::result_test
