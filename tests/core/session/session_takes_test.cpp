// The takes of a running session, and what its file does not have of them yet.
#include "core/session/edit/session_takes.hpp"

#include <gtest/gtest.h>

#include "core/session/file/session_contents.hpp"

namespace abrazo::session_takes_test {
namespace {

SessionTakes with_two() {
  SessionTakes takes;
  takes.begin("salsa 001", 2, {"Ana"});
  takes.follow({2, 5, 180});
  takes.end();
  takes.begin("salsa 002", 6, {"Ana"});
  takes.follow({6, 7, 60});
  takes.end();
  return takes;
}

TEST(SessionTakes, ATakeLastsFromItsFirstFrameToItsNewest) {
  SessionTakes takes;
  takes.begin("salsa 001", 2, {"Ana", "Ben"});
  EXPECT_EQ(takes.running(), 1);
  takes.follow({2.25, 4, 120});
  takes.follow({2.25, 5, 180});
  const RecordedTake expected{1, "salsa 001", 2.25, 5, 180, {"Ana", "Ben"}};
  EXPECT_EQ(*takes.list().find(1), expected);
  EXPECT_EQ(takes.end(), expected);
  EXPECT_EQ(takes.running(), -1);
  takes.follow({2.25, 9, 500});
  EXPECT_EQ(*takes.list().find(1), expected) << "it is over";
}

TEST(SessionTakes, WithoutAFrameItIsNotKept) {
  SessionTakes takes;
  takes.begin("salsa 001", 2, {});
  takes.follow({});
  EXPECT_EQ(takes.end().name, "salsa 001");
  EXPECT_TRUE(takes.list().empty());
  takes.begin("salsa 001", 3, {});
  EXPECT_EQ(takes.running(), 2) << "an id is never used twice in a session";
}

TEST(SessionTakes, ARenameIsToBeWrittenUnderTheNameInTheFile) {
  SessionTakes takes = with_two();
  takes.rename(1, "tango 001");
  takes.rename(1, "tango 002");
  EXPECT_EQ(takes.renames(), (TakeEdits{{"salsa 001", "tango 002"}})) << "the last one counts";
  takes.written(takes.renames());
  EXPECT_TRUE(takes.edits().empty());
  takes.rename(1, "waltz");
  EXPECT_EQ(takes.edits(), (TakeEdits{{"tango 002", "waltz"}})) << "so it is called in the file now";
}

TEST(SessionTakes, ARemovalIsWrittenLastBecauseItCanBeUndone) {
  SessionTakes takes = with_two();
  const RecordedTake first = *takes.list().find(1);
  takes.remove(1);
  EXPECT_TRUE(takes.renames().empty());
  EXPECT_EQ(takes.edits(), (TakeEdits{{"salsa 001", std::nullopt}}));
  takes.restore(first);
  EXPECT_EQ(takes.list().all().front(), first);
  EXPECT_EQ(takes.edits(), (TakeEdits{{"salsa 001", "salsa 001"}})) << "nothing is removed from the file";
}

TEST(SessionTakes, OfAFileContinueItsNumbers) {
  SessionContents file;
  file.performers.push_back({.name = "Ana"});
  SessionTake recorded;
  recorded.id = 7;
  recorded.name = "salsa 001";
  recorded.start_s = 1, recorded.end_s = 4;
  recorded.first_frame = 60, recorded.last_frame = 239;
  file.takes.push_back(recorded);
  SessionTakes takes(file);
  EXPECT_EQ(takes.list().all(), (std::vector<RecordedTake>{{7, "salsa 001", 1, 4, 180, {"Ana"}}}));
  takes.begin("salsa 002", 5, {});
  EXPECT_EQ(takes.running(), 8);
  takes.rename(7, "first");
  EXPECT_EQ(takes.edits(), (TakeEdits{{"salsa 001", "first"}}));
}

TEST(SessionTakes, AnIdThatIsNotThereChangesNothing) {
  SessionTakes takes = with_two();
  takes.rename(9, "tango");
  takes.remove(9);
  EXPECT_EQ(takes.list(), with_two().list());
  EXPECT_TRUE(takes.edits().empty());
}

}  // namespace
}  // namespace abrazo::session_takes_test
