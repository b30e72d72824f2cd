#include "core/stream/protocol/stream_uri.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abrazo::stream_uri_test {
namespace {

using testing::HasSubstr;

std::string error_of(std::string_view text) {
  const auto uri = parse_stream_uri(text);
  return uri ? "no error" : uri.error().text();
}

TEST(StreamUri, HasSchemeHostPortAndOptions) {
  const auto uri = parse_stream_uri("vmc://192.168.1.7:39549?performer=Ana%20B&delay=20");
  ASSERT_TRUE(uri) << uri.error().text();
  EXPECT_EQ(uri->scheme, StreamUri::Scheme::Vmc);
  EXPECT_EQ(uri->host, "192.168.1.7");
  EXPECT_EQ(uri->port, 39549);
  EXPECT_EQ(uri->option("performer"), "Ana B");
  EXPECT_EQ(uri->option("delay"), "20");
  EXPECT_EQ(uri->option("unit", "m"), "m");
  EXPECT_EQ(uri->text, "vmc://192.168.1.7:39549?performer=Ana%20B&delay=20");
}

TEST(StreamUri, TakesTheUsualPortOfTheProtocol) {
  EXPECT_EQ(parse_stream_uri("vmc://localhost")->port, 39539);
  EXPECT_EQ(parse_stream_uri("natnet://motive-pc?multicast=239.255.42.99")->port, 1510);
  EXPECT_EQ(parse_stream_uri("xsens://0.0.0.0")->port, 9763);
}

TEST(StreamUri, MeansThisMachineUnlessItNamesAnotherAddress) {
  for (const char* scheme : {"vmc", "natnet", "xsens"})
    EXPECT_EQ(parse_stream_uri(std::string(scheme) + "://:39540")->host, "127.0.0.1");
  EXPECT_EQ(parse_stream_uri("vmc://*:39540")->host, "0.0.0.0") << "every network is somebody's choice";
}

TEST(StreamUri, SaysWhoReachesAPlaceThatIsListenedAt) {
  EXPECT_EQ(listening_words("127.0.0.1:39539"), "on this machine only (127.0.0.1:39539)");
  EXPECT_EQ(listening_words("localhost:39539"), "on this machine only (localhost:39539)");
  EXPECT_EQ(listening_words("0.0.0.0:39539"), "on every network (0.0.0.0:39539)");
  EXPECT_EQ(listening_words("192.168.1.7:39539"), "on the network of 192.168.1.7 (192.168.1.7:39539)");
  EXPECT_EQ(listening_words("10.0.0.2:5000 and multicast 239.255.42.99:1511"),
            "on the network of 10.0.0.2 (10.0.0.2:5000 and multicast 239.255.42.99:1511)");
}

TEST(StreamUri, WhatIsSentDoesNotComeBackAsTheUser) {
  const auto refused = [](const char* listen, const char* send) {
    const Status away = check_no_loop(*parse_stream_uri(listen), *parse_stream_uri(send));
    return away ? std::string() : away.error().text();
  };
  EXPECT_THAT(refused("vmc://127.0.0.1:39539", "vmc://127.0.0.1:39539"),
              HasSubstr("would come back as the user"));
  EXPECT_NE(refused("vmc://*:39539", "vmc://localhost:39539"), "");
  EXPECT_NE(refused("vmc://192.168.1.7:39539", "vmc://192.168.1.7:39539"), "");
  EXPECT_EQ(refused("vmc://127.0.0.1:39539", "vmc://127.0.0.1:39540"), "");
  EXPECT_EQ(refused("vmc://127.0.0.1:39539", "vmc://192.168.1.7:39539"), "") << "another machine's port";
}

TEST(StreamUri, OfAClipIsAFileWithAnyCharacter) {
  const auto uri = parse_stream_uri("clip:takes/a?b&c.bvh");
  ASSERT_TRUE(uri);
  EXPECT_EQ(uri->scheme, StreamUri::Scheme::Clip);
  EXPECT_EQ(uri->file, "takes/a?b&c.bvh");
}

TEST(StreamUri, SaysWhatIsPossibleWhenItIsWrong) {
  EXPECT_THAT(error_of("osc://host:1"), HasSubstr("expected vmc://HOST:PORT, natnet://HOST"));
  EXPECT_THAT(error_of("vmc:host"), HasSubstr("vmc://HOST:PORT"));
  EXPECT_THAT(error_of("vmc://host:70000"), HasSubstr("expected a number from 1 to 65535"));
  EXPECT_THAT(error_of("vmc://host:39539/avatar"), HasSubstr("ends with the port"));
  EXPECT_THAT(error_of("vmc://[::1]:39539"), HasSubstr("IPv4"));
  EXPECT_THAT(error_of("vmc://ho st"), HasSubstr("neither a name nor an address"));
  EXPECT_THAT(error_of("vmc://host?dely=20"), AllOf(HasSubstr("'dely'"), HasSubstr("delay=MILLISECONDS")));
  EXPECT_THAT(error_of("vmc://host?delay"), HasSubstr("has no value"));
  EXPECT_THAT(error_of("vmc://host?delay=1&delay=2"), HasSubstr("twice"));
  EXPECT_THAT(error_of("vmc://host?multicast=239.0.0.1"), HasSubstr("no option 'multicast' for vmc"));
  EXPECT_THAT(error_of("clip:"), HasSubstr("motion file"));
}

TEST(StreamSchemes, AreReadByTheirWordAndStandInTheOrderOfTheirNumbers) {
  for (std::size_t i = 0; i < stream_schemes().size(); ++i) {
    const SchemeFacts& facts = stream_schemes()[i];
    EXPECT_EQ(static_cast<std::size_t>(facts.scheme), i);
    EXPECT_EQ(&facts_of(facts.scheme), &facts);
    EXPECT_FALSE(facts.sender.empty() || facts.title.empty()) << facts.word;
    const bool is_clip = facts.scheme == StreamUri::Scheme::Clip;
    const auto uri = parse_stream_uri(std::string(facts.word) + (is_clip ? ":walk.bvh" : "://"));
    ASSERT_TRUE(uri) << uri.error().text();
    EXPECT_EQ(uri->scheme, facts.scheme);
    EXPECT_EQ(uri->port, facts.port);
    EXPECT_EQ(uri->host, is_clip ? "" : usual_stream_host);
  }
}

TEST(StreamUri, TellsOptionsOfSendingFromThoseOfListening) {
  const auto uri = parse_stream_uri("vmc://host?framing=t-last");
  ASSERT_TRUE(uri);
  EXPECT_TRUE(check_stream_options(*uri, StreamDirection::Send));
  const Status listening = check_stream_options(*uri, StreamDirection::Listen);
  ASSERT_FALSE(listening);
  EXPECT_THAT(listening.error().text(),
              AllOf(HasSubstr("'framing' is for sending"), HasSubstr("unit=m|cm|mm")));
}

TEST(StreamUri, GivesMillisecondsAsSecondsAndRefusesNonsense) {
  const auto delay = [](const std::string& text) {
    return milliseconds_option(*parse_stream_uri("vmc://host?delay=" + text), "delay", 500);
  };
  EXPECT_DOUBLE_EQ(**delay("20"), 0.020);
  EXPECT_FALSE(delay("-1"));
  EXPECT_FALSE(delay("501"));
  EXPECT_FALSE(delay("nan"));
  EXPECT_THAT(delay("soon").error().text(), HasSubstr("milliseconds from 0 to 500"));
  EXPECT_FALSE(milliseconds_option(*parse_stream_uri("vmc://host"), "delay", 500)->has_value());
}

}  // namespace
}  // namespace abrazo::stream_uri_test
