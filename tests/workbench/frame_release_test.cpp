#include "app/workbench/document/frame_release.hpp"

#include <gtest/gtest.h>

#include <QPointer>
#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include "app/workbench/document/document.hpp"
#include "core/opening/generated_set.hpp"
#include "tests/workbench/until.hpp"

namespace abrazo::app::frame_release_test {
namespace {

/// Counts what is freed, and what of it by this thread.
struct Freed {
  std::atomic<int> all{0}, here{0};
};
std::vector<FrameSnapshotPtr> frames(int count, Freed& freed) {
  std::vector<FrameSnapshotPtr> made;
  for (int i = 0; i < count; ++i)
    made.emplace_back(new FrameSnapshot, [&freed, here = std::this_thread::get_id()](FrameSnapshot* frame) {
      ++freed.all;
      if (std::this_thread::get_id() == here) ++freed.here;
      delete frame;
    });
  return made;
}

TEST(FrameRelease, FreesNothingOnTheThreadThatAsksForIt) {
  Freed freed;
  { const FrameRelease release(frames(3, freed), nullptr); }
  EXPECT_EQ(freed.all, 3);
  EXPECT_EQ(freed.here, 0);
}

TEST(FrameRelease, DeletesItself) {
  Freed freed;
  QObject owner;
  const QPointer<FrameRelease> release = new FrameRelease(frames(3, freed), &owner);
  EXPECT_TRUE(until([&] { return release.isNull(); }));
  EXPECT_EQ(freed.all, 3);
}

TEST(FrameRelease, GetsTheFramesOfASessionThatAnotherReplaces) {
  const auto dance = generated_dance({});
  ASSERT_TRUE(dance) << dance.error().message;
  const auto prepared = [&] { return prepare_solver(*dance, {}).value(); };
  Document document;
  document.beginSession(prepared());
  const auto frame = [&] { return document.session()->history().at(0); };
  ASSERT_TRUE(until([&] { return frame() != nullptr; }));
  const std::weak_ptr<const FrameSnapshot> before = frame();
  document.beginSession(prepared());
  const QObjectList owned = document.children();
  EXPECT_TRUE(std::any_of(owned.begin(), owned.end(),
                          [](QObject* each) { return dynamic_cast<FrameRelease*>(each) != nullptr; }));
  EXPECT_TRUE(until([&] { return before.expired(); }));
}

}  // namespace
}  // namespace abrazo::app::frame_release_test
