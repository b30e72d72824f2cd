#include "app/workbench/stream/host_lookup.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QThread>
#include <atomic>
#include <future>
#include <optional>

#include "tests/workbench/until.hpp"

namespace abrazo::app::host_lookup_test {
namespace {

constexpr std::uint32_t studio = 0x0A000007;  // 10.0.0.7

StreamUri uri(const char* text) {
  return parse_stream_uri(text).value();
}

/// Answers once it is let, like a name server far away.
class SlowServer {
 public:
  HostLookup::Resolve resolve() {
    return [this, answer = m_answer.get_future().share()](const std::string& host) -> Result<std::uint32_t> {
      m_asked = true;
      answer.wait();
      m_thread = QThread::currentThread();
      const Result<std::uint32_t> address =
          host == "studio" ? Result<std::uint32_t>(studio) : Error{"nobody knows this name", host};
      m_done = true;
      return address;
    };
  }
  void answer() { m_answer.set_value(); }
  bool wasAsked() const { return m_asked; }
  bool isDone() const { return m_done; }
  QThread* thread() const { return m_thread; }

 private:
  std::promise<void> m_answer;
  std::atomic<bool> m_asked = false, m_done = false;
  std::atomic<QThread*> m_thread = nullptr;
};

TEST(HostLookup, AnAddressIsToldAtOnceAndNobodyIsAsked) {
  SlowServer server;
  HostLookup lookup(server.resolve(), nullptr);
  std::optional<Result<StreamUri>> told;
  lookup.find(uri("natnet://192.168.1.7?multicast=239.255.42.99"),
              [&told](const auto& found) { told = found; });
  ASSERT_TRUE(told && *told);
  EXPECT_EQ((*told)->host, "192.168.1.7");
  EXPECT_FALSE(server.wasAsked());
}

TEST(HostLookup, ANameIsLookedForWhileTheWindowGoesOn) {
  SlowServer server;
  HostLookup lookup(server.resolve(), nullptr);
  std::optional<Result<StreamUri>> told;
  lookup.find(uri("vmc://studio:39540"), [&told](const auto& found) { told = found; });
  ASSERT_TRUE(until([&server] { return server.wasAsked(); }));
  EXPECT_FALSE(told);
  server.answer();
  ASSERT_TRUE(until([&told] { return told.has_value(); }));
  ASSERT_TRUE(*told);
  EXPECT_EQ((*told)->host, "10.0.0.7");
  EXPECT_EQ((*told)->port, 39540);
  EXPECT_EQ((*told)->text, "vmc://studio:39540") << "what was written is what is shown";
  EXPECT_NE(server.thread(), QThread::currentThread());
}

TEST(HostLookup, NamesInOptionsAreReplacedToo) {
  SlowServer server;
  server.answer();
  HostLookup lookup(server.resolve(), nullptr);
  std::optional<Result<StreamUri>> told;
  lookup.find(uri("natnet://192.168.1.7?interface=studio"), [&told](const auto& found) { told = found; });
  ASSERT_TRUE(until([&told] { return told.has_value(); }));
  ASSERT_TRUE(*told);
  EXPECT_EQ((*told)->host, "192.168.1.7");
  EXPECT_EQ((*told)->option("interface"), "10.0.0.7");
}

TEST(HostLookup, ANameThatNobodyKnowsIsAnError) {
  SlowServer server;
  server.answer();
  HostLookup lookup(server.resolve(), nullptr);
  std::optional<Result<StreamUri>> told;
  lookup.find(uri("vmc://nowhere"), [&told](const auto& found) { told = found; });
  ASSERT_TRUE(until([&told] { return told.has_value(); }));
  ASSERT_FALSE(*told);
  EXPECT_EQ(told->error().text(), "nowhere: nobody knows this name");
}

TEST(HostLookup, WhatWasCancelledIsNotTold) {
  SlowServer first, second;
  bool told = false;
  {
    HostLookup given_up(first.resolve(), nullptr);
    given_up.find(uri("vmc://studio"), [&told](const auto&) { told = true; });
    ASSERT_TRUE(until([&first] { return first.wasAsked(); }));
    given_up.cancel();
    first.answer();
    ASSERT_TRUE(until([&first] { return first.isDone(); }));
    QCoreApplication::processEvents();
    EXPECT_FALSE(told);
    given_up.find(uri("vmc://127.0.0.1"), [&told](const auto& found) { told = found.ok(); });
    EXPECT_TRUE(told) << "what comes after is told";
    told = false;
  }
  {
    HostLookup gone(second.resolve(), nullptr);
    gone.find(uri("vmc://studio"), [&told](const auto&) { told = true; });
    ASSERT_TRUE(until([&second] { return second.wasAsked(); }));
  }  // does not wait for the answer
  second.answer();
  ASSERT_TRUE(until([&second] { return second.isDone(); }));
  QCoreApplication::processEvents();
  EXPECT_FALSE(told);
}

}  // namespace
}  // namespace abrazo::app::host_lookup_test
