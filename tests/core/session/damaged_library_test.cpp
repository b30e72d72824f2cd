// The library's file while a session lives on it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/base/atomic_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::damaged_library_test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

/// A session on a library that is mapped, as a large one is.
class MappedLibrary : public testing::Test, protected test::TemporaryFolder {
 protected:
  MappedLibrary() {
    EXPECT_TRUE(write_library(*test::session_library(), file_));
    replace_synthesizer(0);
  }
  void replace_synthesizer(std::uint64_t largest_in_memory_bytes) {
    auto library = read_library(file_, {.largest_in_memory_bytes = largest_in_memory_bytes});
    ASSERT_TRUE(library) << library.error().text();
    auto shared = std::make_shared<const MotionLibrary>(std::move(*library));
    EXPECT_EQ(shared->columns().mapping != nullptr, largest_in_memory_bytes == 0);
    auto synthesizer = PartnerSynthesizer::create(shared, test::responsive_by_pose());
    ASSERT_TRUE(synthesizer);
    session_.commands.push(ReplaceSynthesizer{std::move(*synthesizer)});
  }
  const FrameSnapshot& newest() const { return *session_.keeper->frames.back(); }
  /// The frames of a session in which nothing happens to the file.
  std::vector<FrameSnapshotPtr> undisturbed(double to_s) const {
    test::DrivenSession other;
    other.run_until(to_s);
    return other.keeper->frames;
  }
  void expect_as_undisturbed() {
    const auto expected = undisturbed(session_.now_s);
    const auto& frames = session_.keeper->frames;
    ASSERT_EQ(frames.size(), expected.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(frames[i]->result.result, expected[i]->result.result) << i;
      EXPECT_NE(frames[i]->result.status, StepStatus::Failed) << frames[i]->result.message;
    }
  }

  const std::string file_ = TemporaryFolder::file("dance.h5");
  test::DrivenSession session_;
};

TEST_F(MappedLibrary, IsCopiedForAPassiveUserWhileTheSessionGoesOn) {
  session_.run_until(0.5);
  Settings passive = newest().settings;
  passive.user_role = UserRole::Passive;
  session_.commands.push(SetSettings{passive});
  for (int i = 0; i < 20000 && newest().settings.user_role == UserRole::Active; ++i) {
    session_.run_until(session_.now_s + 1.0 / 60);
    EXPECT_NE(newest().result.status, StepStatus::Failed) << newest().result.message;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(newest().settings.user_role, UserRole::Passive);
}

TEST_F(MappedLibrary, ThatIsReplacedByAnotherLeavesTheSessionAsItWas) {
  session_.run_until(0.5);
  ASSERT_TRUE(write_whole_file(file_, "another library, written as all files are: beside it, then renamed"));
  session_.run_until(1);
  expect_as_undisturbed();
}

TEST_F(MappedLibrary, ThatIsDeletedLeavesTheSessionAsItWas) {
  session_.run_until(0.5);
  fs::remove(file_);
  session_.run_until(1);
  expect_as_undisturbed();
}

TEST_F(MappedLibrary, ThatIsCutShortHoldsThePartnerAndSaysWhy) {
  session_.run_until(0.5);
  const FrameSnapshot before = newest();
  fs::resize_file(file_, 100);
  session_.run_until(1);
  EXPECT_GT(newest().index, before.index) << "the session lives";
  EXPECT_EQ(newest().result.status, StepStatus::Failed);
  EXPECT_THAT(newest().result.message, AllOf(HasSubstr("cut short"), HasSubstr("holds its last pose")));
  EXPECT_EQ(newest().result.result, before.result.result);
  for (const FrameSnapshotPtr& frame : session_.keeper->frames)
    EXPECT_TRUE(frame->result.result.allFinite()) << frame->index;
}

TEST_F(MappedLibrary, ThatIsOverwrittenInPlaceHoldsThePartnerAndSaysWhy) {
  session_.run_until(0.5);
  const FrameSnapshot before = newest();
  {
    std::fstream file(file_, std::ios::binary | std::ios::in | std::ios::out);
    const std::string rubbish(fs::file_size(file_), '\xff');
    file.write(rubbish.data(), static_cast<std::streamsize>(rubbish.size()));
  }
  session_.run_until(1);
  EXPECT_GT(newest().index, before.index);
  EXPECT_EQ(newest().result.status, StepStatus::Failed);
  // Whichever was seen first: what stands in it, or the time of the change.
  EXPECT_THAT(newest().result.message, AnyOf(HasSubstr("damaged in the library's file"),
                                             HasSubstr("another program wrote to the library's file")));
  EXPECT_EQ(newest().result.result, before.result.result);
}

TEST_F(MappedLibrary, OnceItIsBuiltAgainAndOpenedThePartnerMovesOn) {
  session_.run_until(0.5);
  fs::resize_file(file_, 100);
  session_.run_until(0.7);
  ASSERT_EQ(newest().result.status, StepStatus::Failed);
  ASSERT_TRUE(write_library(*test::session_library(), file_));
  replace_synthesizer(0);
  const PairPose held = newest().result.result;
  session_.run_until(1);
  EXPECT_NE(newest().result.status, StepStatus::Failed) << newest().result.message;
  EXPECT_NE(newest().result.result, held);
}

TEST_F(MappedLibrary, ThatIsInMemoryIsNotConcernedByItsFile) {
  replace_synthesizer(1 << 30);
  session_.run_until(0.5);
  fs::resize_file(file_, 100);
  session_.run_until(1);
  expect_as_undisturbed();
}

}  // namespace
}  // namespace abrazo::damaged_library_test
