#include "core/annotation/library_updates.hpp"

#include <gmock/gmock.h>

#include "core/session/edit/live_annotations.hpp"
#include "core/session/file/library_reference.hpp"
#include "tests/core/annotation/label_tiers.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::library_updates_test {
namespace {

using ::testing::HasSubstr;

class LibraryUpdatesTest : public testing::Test {
 protected:
  const std::string& name(int take) const { return library->takes().at(static_cast<std::size_t>(take)).name; }
  /// As the library has it, and one move more.
  Annotations with_move(int take, const char* value) const {
    Annotations annotations = begun_annotations(*library, name(take));
    EXPECT_TRUE(
        annotations.draw(annotations.first_of(TierKind::Move)->id, 0, 0.1, value, Conflict::Replace, {0, 1}));
    return annotations;
  }
  Annotations as_it_is(int take) const { return begun_annotations(*library, name(take)); }
  bool put(int take, const Annotations& annotations) {
    const auto waits = updates.put(*library, name(take), annotations);
    EXPECT_TRUE(waits);
    return waits && *waits;
  }

  std::shared_ptr<const MotionLibrary> library = test::small_library();
  LibraryUpdates updates;
};

TEST_F(LibraryUpdatesTest, OnlyWhatTheLibraryDoesNotHaveWaits) {
  EXPECT_FALSE(put(0, as_it_is(0)));
  EXPECT_TRUE(updates.is_idle());
  EXPECT_TRUE(put(0, with_move(0, "turn")));
  EXPECT_FALSE(put(0, with_move(0, "turn"))) << "it waits already";
  EXPECT_FALSE(updates.is_idle());
  EXPECT_FALSE(*updates.put(*library, "no such take", with_move(0, "turn")));
}

TEST_F(LibraryUpdatesTest, OfATakeTheNewestCounts) {
  put(0, with_move(0, "turn"));
  put(0, with_move(0, "dip"));
  const auto& takes = updates.begin();
  ASSERT_EQ(takes.size(), 1u);
  EXPECT_EQ(takes.at(name(0)).labels.front().label, "dip");
}

TEST_F(LibraryUpdatesTest, WhatIsUnderWayIsComparedWith) {
  put(0, with_move(0, "turn"));
  updates.begin();
  EXPECT_FALSE(put(0, with_move(0, "turn"))) << "it arrives";
  EXPECT_TRUE(put(0, as_it_is(0))) << "undone while it is under way: it has to be taken out again";
}

TEST_F(LibraryUpdatesTest, WhatDidNotArriveIsPutInWithTheNext) {
  put(0, with_move(0, "turn"));
  updates.begin();
  put(1, with_move(1, "dip"));
  EXPECT_EQ(updates.begin().size(), 2u);
  put(0, with_move(0, "spin"));
  EXPECT_EQ(updates.begin().at(name(0)).labels.front().label, "spin") << "the newer one";
  updates.end();
  EXPECT_TRUE(updates.is_idle());
}

TEST_F(LibraryUpdatesTest, AForgottenUpdateDoesNotWait) {
  put(0, with_move(0, "turn"));
  updates.begin();
  put(1, with_move(1, "dip"));
  updates.forget();
  EXPECT_TRUE(updates.is_idle());
}

TEST_F(LibraryUpdatesTest, ARoleThatIsNoneIsAnError) {
  Annotations annotations = as_it_is(0);
  ASSERT_TRUE(annotations.draw(annotations.first_of(TierKind::Role)->id, 0, 0.1, "leader", Conflict::Replace,
                               {0, 1}));
  const auto refused = updates.put(*library, name(0), annotations);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("say a or b"));
  EXPECT_TRUE(updates.is_idle());
}

TEST_F(LibraryUpdatesTest, ALibraryWithThemHasThem) {
  put(1, with_move(1, "dip"));
  const auto next = with_updates(library, *library, updates.begin());
  ASSERT_TRUE(next);
  EXPECT_EQ((*next)->takes().at(1).labels.front().label, "dip");
  EXPECT_EQ((*next)->takes().at(0).labels.size(), library->takes().at(0).labels.size());
  updates.end();
  EXPECT_FALSE(*updates.put(**next, name(1), with_move(1, "dip")));
}

/// A session that was saved finds the library of its frames by the fingerprint, which is of every bit.
TEST_F(LibraryUpdatesTest, TheSameAnnotationsMakeTheSameLibraryByWhateverWay) {
  const LibraryTake& take = library->takes().front();
  const auto led_by_b = [&take](int from, int to) {
    return TakeAnnotations{{take.name, {{{from, to, ActivePerformer::B}}, take.labels}}};
  };
  const auto straight = with_updates(library, *library, led_by_b(4, 9));
  const auto first = with_updates(library, *library, led_by_b(2, 30));
  const auto then = with_updates(library, **first, led_by_b(4, 9));
  ASSERT_TRUE(straight && first && then);
  EXPECT_NE(library_fingerprint(**straight), library_fingerprint(*library));
  EXPECT_EQ(library_fingerprint(**then), library_fingerprint(**straight));
  const auto back = with_updates(library, **then, {{take.name, {take.roles, take.labels}}});
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, library) << "it is the file's again";
}

}  // namespace
}  // namespace abrazo::library_updates_test
