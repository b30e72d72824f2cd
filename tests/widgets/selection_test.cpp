// What can be selected, how it changes, and how the views name it.
#include "widgets/common/selection.hpp"

#include <gtest/gtest.h>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets::selection_test {
namespace {

Selection joints_of(std::initializer_list<std::uint8_t> vertices) {
  return {SelectionKind::Joints, vertices, -1};
}

TEST(Selection, ReplacesAddsAndTogglesJointsInTheOrderTheyWereChosen) {
  const Selection one = Selection::joint(20);
  EXPECT_EQ(changed(one, Selection::joint(3), SelectionChange::Replace), Selection::joint(3));
  const Selection two = changed(one, Selection::joint(3), SelectionChange::Add);
  EXPECT_EQ(two, joints_of({20, 3}));
  EXPECT_EQ(two.last_joint(), 3);
  EXPECT_EQ(changed(two, Selection::joint(20), SelectionChange::Add), joints_of({3, 20}))
      << "is the last now";
  EXPECT_EQ(changed(two, Selection::joint(20), SelectionChange::Toggle), joints_of({3}));
  EXPECT_EQ(changed(one, Selection::joint(20), SelectionChange::Toggle), Selection());
}

TEST(Selection, IsReplacedByAnythingThatIsNoJoint) {
  const Selection edge = Selection::edge({45, 20});
  EXPECT_EQ(changed(Selection::joint(3), edge, SelectionChange::Add), edge);
  EXPECT_EQ(changed(edge, Selection::joint(3), SelectionChange::Add), Selection::joint(3));
  EXPECT_EQ(changed(edge, edge, SelectionChange::Toggle), Selection());
  EXPECT_EQ(changed(edge, edge, SelectionChange::Add), edge);
}

TEST(Selection, IsKeptByAClickBesideEverythingWithAKeyHeldAndLostWithoutOne) {
  const Selection joint = Selection::joint(3);
  EXPECT_EQ(changed(joint, {}, SelectionChange::Add), joint);
  EXPECT_EQ(changed(joint, {}, SelectionChange::Toggle), joint);
  EXPECT_EQ(changed(joint, {}, SelectionChange::Replace), Selection());
}

TEST(Selection, HasACounterpartOfTheOtherCharacter) {
  EXPECT_EQ(other_character({}), Selection::joint(joints::Root));
  EXPECT_EQ(other_character(Selection::candidate(7)), Selection::joint(joints::Root));
  EXPECT_EQ(other_character(joints_of({20, 3})), joints_of({45, 28}));
  EXPECT_EQ(other_character(joints_of({45, 28})), joints_of({20, 3}));
  EXPECT_EQ(other_character(Selection::edge({20, 49})), Selection::edge({45, 24}));
}

TEST(Selection, IsTheSameHoweverItsVerticesAreOrdered) {
  EXPECT_EQ(Selection::tetrahedron({3, 40, 1, 2}), Selection::tetrahedron({1, 2, 3, 40}));
  EXPECT_EQ(Selection::edge({40, 3}), Selection::edge({3, 40}));
  EXPECT_NE(Selection::edge({3, 40}), Selection::edge({3, 41}));
}

TEST(Selection, IsNamedByBodiesAndJoints) {
  EXPECT_EQ(name_of(Selection::joint(20)), "leader lhand");
  EXPECT_EQ(name_of(joints_of({20, 49})), "leader lhand, follower rhand");
  EXPECT_EQ(name_of(Selection::edge({49, 20})), "leader lhand — follower rhand");
  EXPECT_EQ(name_of(Selection::candidate(12)), "pair 12");
}

}  // namespace
}  // namespace abrazo::widgets::selection_test
