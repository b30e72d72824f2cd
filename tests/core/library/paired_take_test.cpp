#include "core/library/takes/paired_take.hpp"

#include <gtest/gtest.h>

namespace abrazo::paired_take_test {
namespace {

TEST(PairedTake, RolesHoldFromStartUntilJustBeforeEnd) {
  PairedTake take;
  take.roles = {{10, 20, ActivePerformer::A}, {20, 30, ActivePerformer::B}};
  EXPECT_EQ(active_at(take, 10), ActivePerformer::A);
  EXPECT_EQ(active_at(take, 19), ActivePerformer::A);
  EXPECT_EQ(active_at(take, 20), ActivePerformer::B);
  EXPECT_EQ(active_at(take, 29), ActivePerformer::B);
}

TEST(PairedTake, FramesThatNoRoleCoversAreUnknown) {
  PairedTake take;
  EXPECT_EQ(active_at(take, 0), ActivePerformer::Unknown);
  take.roles = {{10, 20, ActivePerformer::A}, {25, 30, ActivePerformer::B}};
  for (const int frame : {0, 9, 20, 24, 30, 1000})
    EXPECT_EQ(active_at(take, frame), ActivePerformer::Unknown) << frame;
}

TEST(PairedTake, LabelsHoldFromStartUntilJustBeforeEnd) {
  const std::vector<LabelInterval> labels = {{0, 5, "turn", "", ""}, {8, 9, "walk", "", ""}};
  EXPECT_EQ(label_at(labels, 0), "turn");
  EXPECT_EQ(label_at(labels, 4), "turn");
  EXPECT_EQ(label_at(labels, 5), "");
  EXPECT_EQ(label_at(labels, 8), "walk");
  EXPECT_EQ(label_at(labels, 9), "");
  EXPECT_EQ(label_at({}, 0), "");
}

}  // namespace
}  // namespace abrazo::paired_take_test
