#include "core/motion/files/motion_reading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::motion_reading_test {
namespace {

using test::motion_fixture;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;

MotionReading of(const std::string& name) {
  return {.file = motion_fixture(name).string()};
}

TEST(MotionReading, FollowsWhatIsSaidOfTheFile) {
  MotionReading reading = of("lafan_metres.bvh");
  reading.metres_per_unit = 2;
  reading.fps = 48;
  const auto read = read_performer(reading);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->clip.fps, 48);
  EXPECT_EQ(read->report.metres_per_unit, 2);
  EXPECT_FALSE(read->report.unit_guessed);
}

TEST(MotionReading, RefusesNumbersThatAreNoneAndNamesWhatToChange) {
  for (const double number : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    MotionReading reading = of("lafan_metres.bvh");
    reading.fps = number;
    const Error of_rate = read_performer(reading).error();
    EXPECT_THAT(of_rate.text(), StartsWith("frame rate: expected a number above 0, found '"));
    EXPECT_EQ(of_rate.hint, Hint::SetFrameRate);
    reading.fps.reset();
    reading.metres_per_unit = number;
    const Error of_unit = read_performers(reading).error();
    EXPECT_THAT(of_unit.text(), StartsWith("metres per unit: "));
    EXPECT_EQ(of_unit.hint, Hint::SetUnit);
  }
}

TEST(MotionReading, RefusesAnAxisThatIsNone) {
  MotionReading reading = of("lafan_metres.bvh");
  reading.up = "w";
  EXPECT_EQ(read_performer(reading).error().text(),
            "axis that points up: 'w' is not an axis; use y, z, -y, -z, x or -x");
}

TEST(MotionReading, RefusesAPerformerThatIsNotThere) {
  MotionReading reading = of("lafan_metres.bvh");
  for (const char* who : {"2", "0", "Anna"}) {
    reading.performer = who;
    EXPECT_THAT(read_performer(reading).error().text(),
                HasSubstr("has no performer " + std::string(who) + "; it holds 1 lafan_metres"));
  }
  reading.performer = "lafan_metres";
  EXPECT_TRUE(read_performer(reading));
}

TEST(MotionReading, SaysWhatWasOddWithTheFilesName) {
  const MotionReading reading = of("lafan_rest_first.bvh");
  const auto read = read_performer(reading);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_THAT(warnings_of_import(reading, *read),
              Contains(testing::Field(&Warning::message, StartsWith(reading.file + ": units: "))));
}

}  // namespace
}  // namespace abrazo::motion_reading_test
