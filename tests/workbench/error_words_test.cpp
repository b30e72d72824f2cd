#include "app/workbench/base/error_words.hpp"

#include <gtest/gtest.h>

namespace abrazo::app::error_words_test {
namespace {

TEST(ErrorWords, SayWhatTheWindowOffers) {
  const Error error{"an .amc needs its skeleton", "walk.amc", Hint::NameSkeleton};
  EXPECT_EQ(words(error), "walk.amc: an .amc needs its skeleton (open it together with the motion)");
  EXPECT_EQ(words(Error{"is empty", "walk.amc"}), "walk.amc: is empty");
}

TEST(ErrorWords, NameNoOptionOfTheCommandLine) {
  for (int hint = 0; hint <= static_cast<int>(Hint::NameReport); ++hint)
    EXPECT_EQ(window_words(static_cast<Hint>(hint)).find("--"), std::string_view::npos) << hint;
}

}  // namespace
}  // namespace abrazo::app::error_words_test
