#include "core/annotation/session_labels.hpp"

#include <gmock/gmock.h>

#include "tests/core/annotation/label_tiers.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::session_labels_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A take of 60 frames a second of which nothing is said.
PairedTake two_seconds() {
  PairedTake take = test::swinging_take("new", 120, 1);
  take.labels.clear();
  take.roles.clear();
  return take;
}

/// "0-60 two"
std::vector<std::string> labels(const PairedTake& take) {
  std::vector<std::string> texts;
  for (const LabelInterval& each : take.labels)
    texts.push_back(std::to_string(each.start) + "-" + std::to_string(each.end) + " " + each.label);
  return texts;
}

std::vector<std::string> roles(const PairedTake& take) {
  std::vector<std::string> texts;
  for (const RoleInterval& each : take.roles)
    texts.push_back(std::to_string(each.start) + "-" + std::to_string(each.end) +
                    (each.active == ActivePerformer::B ? " b" : " a"));
  return texts;
}

TEST(SessionLabels, ANewTakeHasThoseSaidWhileItWasRecorded) {
  const test::LabelTiers session;
  const PairedTake take = with_session_labels(two_seconds(), session.annotations, 4);
  EXPECT_THAT(labels(take), ElementsAre("0-60 two"))
      << "the end of the one that ran already; the next began at its end";
  EXPECT_THAT(with_session_labels(two_seconds(), session.annotations, 7.5).labels, IsEmpty());
}

TEST(SessionLabels, LabelsThatTheTakeHasStay) {
  const test::LabelTiers session;
  PairedTake labelled = two_seconds();
  labelled.labels = {{0, 10, "own", "", ""}};
  EXPECT_THAT(labels(with_session_labels(labelled, session.annotations, 3)), ElementsAre("0-10 own"));
}

TEST(SessionLabels, RolesComeInWhereNobodySaidWhoLeads) {
  test::LabelTiers session;
  ASSERT_TRUE(session.annotations.draw(session.role, 0, 10, "b", Conflict::Replace, session.place.range));
  PairedTake take = two_seconds();
  EXPECT_THAT(roles(with_session_labels(take, session.annotations, 3)), ElementsAre("0-120 b"));
  take.roles = {{0, 120, ActivePerformer::A}};
  EXPECT_THAT(roles(with_session_labels(take, session.annotations, 3)), ElementsAre("0-120 a"));
}

TEST(SessionLabels, ARoleThatIsNoneIsLeftOut) {
  test::LabelTiers session;
  ASSERT_TRUE(
      session.annotations.draw(session.role, 0, 10, "leader", Conflict::Replace, session.place.range));
  PairedTake take = two_seconds();
  EXPECT_THAT(with_session_labels(take, session.annotations, 3).roles, IsEmpty());
}

}  // namespace
}  // namespace abrazo::session_labels_test
