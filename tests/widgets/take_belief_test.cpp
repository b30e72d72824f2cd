#include "widgets/library/take_belief.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abrazo::widgets::take_belief_test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

/// Two takes of ten blocks each; the first also with the other performer active.
class Belief : public testing::Test {
 protected:
  static constexpr int block_frames = 30;
  void SetUp() override {
    takes.resize(2);
    for (LibraryTake& take : takes) take.frames = 10 * block_frames;
    add_take(0, false);
    add_take(0, true);
    add_take(1, false);
    believed.assign(blocks.size(), 0);
    belief.begin(blocks, takes);
  }
  void add_take(std::uint32_t take, bool swapped) {
    for (int block = 0; block < 10; ++block)
      blocks.push_back({take, swapped, block * block_frames, (block + 1) * block_frames});
  }
  std::vector<LibraryTake> takes;
  std::vector<BeliefBlock> blocks;
  std::vector<std::uint8_t> believed;
  TakeBelief belief;
};

TEST_F(Belief, LightsTheBlockThatIsBelievedAndNothingElse) {
  believed[23] = 255;
  EXPECT_THAT(belief.show(believed), ElementsAre(1));
  for (int frame = 90; frame < 120; ++frame) EXPECT_EQ(belief.at(1, frame), 1) << frame;
  // A part is some three frames; one at the seam of two blocks belongs to both.
  for (int frame = 0; frame < 86; ++frame) EXPECT_EQ(belief.at(1, frame), 0) << frame;
  for (int frame = 124; frame < 300; ++frame) EXPECT_EQ(belief.at(1, frame), 0) << frame;
  EXPECT_THAT(belief.along(0), Each(0));
}

TEST_F(Belief, OfEitherActivePerformerIsTheStrongerOne) {
  believed[4] = 102, believed[14] = 204;
  believed[5] = 204, believed[15] = 102;
  belief.show(believed);
  EXPECT_DOUBLE_EQ(belief.at(0, 4 * block_frames + 15), 0.8);
  EXPECT_DOUBLE_EQ(belief.at(0, 5 * block_frames + 15), 0.8);
}

TEST_F(Belief, TellsOnlyTakesThatLookDifferent) {
  believed[0] = 100, believed[20] = 200;
  EXPECT_THAT(belief.show(believed), ElementsAre(0, 1));
  EXPECT_THAT(belief.show(believed), IsEmpty());
  believed[0] = 101;  // less than one of the levels
  EXPECT_THAT(belief.show(believed), IsEmpty());
  believed[20] = 100;
  EXPECT_THAT(belief.show(believed), ElementsAre(1));
}

TEST_F(Belief, GoesOutWithAFrameThatSaysNothing) {
  believed[0] = 255;
  belief.show(believed);
  EXPECT_TRUE(belief.is_any());
  EXPECT_THAT(belief.show({}), ElementsAre(0));
  EXPECT_FALSE(belief.is_any());
  EXPECT_THAT(belief.along(0), Each(0));
}

TEST_F(Belief, OfAnotherModelReplacesTheOneBefore) {
  believed[0] = 255;
  belief.show(believed);
  const std::vector<BeliefBlock> halves = {{1, false, 0, 150}, {1, false, 150, 300}};
  belief.begin(halves, takes);
  EXPECT_THAT(belief.show(std::vector<std::uint8_t>{0, 255}), ElementsAre(0, 1));
  EXPECT_EQ(belief.at(1, 10), 0);
  EXPECT_EQ(belief.at(1, 290), 1);
}

TEST_F(Belief, IsBrightestInTheMiddleOfTheBrightestStretch) {
  believed[22] = 100, believed[24] = 200, believed[25] = 200;
  belief.show(believed);
  EXPECT_DOUBLE_EQ(belief.peak(1).belief, 0.8);
  EXPECT_NEAR(belief.peak(1).frame, 150, 3);  // one part
  EXPECT_EQ(belief.peak(0).belief, 0);
}

TEST_F(Belief, OfShortTakesAndLongOnesReachesTheirEnds) {
  takes[0].frames = 5, takes[1].frames = 1'000'000;
  const std::vector<BeliefBlock> short_and_long = {{0, false, 4, 5}, {1, false, 999'970, 1'000'000}};
  belief.begin(short_and_long, takes);
  belief.show(std::vector<std::uint8_t>{255, 255});
  EXPECT_EQ(belief.along(0).back(), TakeBelief::levels);
  EXPECT_EQ(belief.along(0).front(), 0);
  EXPECT_EQ(belief.along(1).back(), TakeBelief::levels);
  EXPECT_EQ(belief.at(0, 100), 1) << "held at its end";
}

TEST_F(Belief, IsNoneOfTakesTheLibraryDoesNotHaveAndOfEmptyBlocks) {
  const std::vector<BeliefBlock> odd = {{7, false, 0, 30}, {0, false, 30, 30}};
  belief.begin(odd, takes);
  EXPECT_THAT(belief.show(std::vector<std::uint8_t>{255, 255}), IsEmpty());
  EXPECT_FALSE(belief.is_any());
}

}  // namespace
}  // namespace abrazo::widgets::take_belief_test
