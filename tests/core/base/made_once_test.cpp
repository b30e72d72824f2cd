#include "core/base/made_once.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <memory>
#include <thread>
#include <vector>

namespace abrazo::made_once_test {
namespace {

using Text = MadeOnce<std::string>;

/// Waits for something that another thread does; a test that waits in vain fails after 20 s.
template <typename Condition>
bool happens(const Condition& condition) {
  for (int i = 0; i < 20000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(MadeOnce, IsMadeOnceHoweverManyThreadsAskForIt) {
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> made = 0;
    const Text text([&](const Progress&) {
      ++made;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return std::string("once");
    });
    constexpr int askers = 8;
    std::latch start(askers);
    std::vector<const std::string*> given(askers);
    {
      std::vector<std::jthread> threads;
      for (int asker = 0; asker < askers; ++asker)
        threads.emplace_back([&, asker] {
          start.arrive_and_wait();
          if (asker % 2 == 0) text.prepare();
          given[static_cast<std::size_t>(asker)] = &text.get();
          EXPECT_EQ(text.get(), "once");
        });
    }
    EXPECT_EQ(made, 1);
    for (const std::string* one : given) EXPECT_EQ(one, given.front());
  }
}

TEST(MadeOnce, IsNotMadeBeforeSomebodyAsks) {
  int made = 0;
  {
    const Text text([&](const Progress&) { return ++made, std::string(); });
    EXPECT_FALSE(text.is_ready());
  }
  EXPECT_EQ(made, 0);
}

TEST(MadeOnce, IsReadyOnceItWasMade) {
  int made = 0;
  {
    const Text text([&](const Progress&) { return ++made, std::string("made"); });
    text.get();
    EXPECT_TRUE(text.is_ready());
    text.prepare();
  }
  EXPECT_EQ(made, 1) << "there is nothing left to prepare";
}

TEST(MadeOnce, PreparedBesideItIsThereWithoutAWait) {
  std::latch go_on(1);
  const Text text([&](const Progress&) {
    go_on.wait();
    return std::string("made");
  });
  text.prepare();
  EXPECT_FALSE(text.is_ready());
  text.prepare();
  go_on.count_down();
  ASSERT_TRUE(happens([&] { return text.is_ready(); }));
  EXPECT_EQ(text.get(), "made");
  EXPECT_FALSE(text.trouble());
}

TEST(MadeOnce, WhoeverAsksWhileItIsPreparedGetsTheSame) {
  std::atomic<int> made = 0;
  std::latch begun(1);
  const Text text([&](const Progress&) {
    begun.count_down();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return std::to_string(++made);
  });
  text.prepare();
  begun.wait();
  EXPECT_EQ(text.get(), "1");
  EXPECT_EQ(made, 1);
}

TEST(MadeOnce, WhatCouldNotBeMadeIsTriedAgain) {
  int tries = 0;
  const Text text([&](const Progress&) {
    if (++tries < 3) throw std::runtime_error("not yet");
    return std::string("at last");
  });
  EXPECT_THROW(text.get(), std::runtime_error);
  EXPECT_FALSE(text.is_ready());
  EXPECT_THROW(text.get(), std::runtime_error);
  EXPECT_EQ(text.get(), "at last");
  EXPECT_EQ(tries, 3);
}

TEST(MadeOnce, TroubleOfAPreparationIsSaidOnceAndItCanBeAskedForAgain) {
  std::atomic<int> tries = 0;
  const Text text([&](const Progress&) -> std::string {
    switch (++tries) {
      case 1:
        throw std::runtime_error("no room");
      case 2:
        throw std::bad_alloc();
      default:
        return "made";
    }
  });
  for (const std::string expected : {"no room", "there is not enough memory for it"}) {
    EXPECT_FALSE(text.trouble()) << "none before it was tried";
    text.prepare();
    std::optional<std::string> trouble;
    ASSERT_TRUE(happens([&] { return (trouble = text.trouble()).has_value(); }));
    EXPECT_EQ(*trouble, expected);
    EXPECT_FALSE(text.trouble()) << "said once";
    EXPECT_FALSE(text.is_ready());
  }
  text.prepare();
  ASSERT_TRUE(happens([&] { return text.is_ready(); }));
  EXPECT_EQ(text.get(), "made");
}

TEST(MadeOnce, GoneWhileItIsPreparedStopsThat) {
  std::atomic<bool> begun = false, was_asked_to_stop = false;
  {
    const Text text([&](const Progress& progress) {
      begun = true;
      was_asked_to_stop = happens([&] { return !progress(0.5, "working"); });
      return std::string("half");
    });
    text.prepare();
    ASSERT_TRUE(happens([&] { return begun.load(); }));
    EXPECT_FALSE(was_asked_to_stop);
  }
  EXPECT_TRUE(was_asked_to_stop);
}

}  // namespace
}  // namespace abrazo::made_once_test
