#include "core/stream/vmc/osc_packet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <random>

#include "tests/core/stream/vmc_packets.hpp"

namespace abrazo::osc_packet_test {
namespace {

using test::Bytes;
using test::from_hex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = OscElement::Kind;

/// "/VMC/Ext/T" ",f" 1.5, by hand: 10 + 2 NUL, 2 + 2 NUL, 0x3fc00000.
const char* const time_message = "2f564d43 2f457874 2f540000 2c660000 3fc00000";
/// "/a" ",i" 7.
const char* const small_message = "2f610000 2c690000 00000007";
const char* const bundle_head = "2362756e646c6500 0000000000000001";

std::vector<std::string> outline(const OscPacket& packet) {
  std::vector<std::string> words;
  for (const OscElement& element : packet.elements)
    words.push_back(element.kind == Kind::BundleBegin ? "("
                    : element.kind == Kind::BundleEnd ? ")"
                                                      : element.address);
  return words;
}

TEST(OscPacket, ReadsAMessageWrittenByteByByte) {
  const OscPacket packet = read_osc(from_hex(time_message));
  ASSERT_EQ(packet.elements.size(), 1u);
  EXPECT_EQ(packet.elements[0].address, "/VMC/Ext/T");
  EXPECT_THAT(packet.elements[0].arguments, ElementsAre(OscArgument::of(1.5F)));
  EXPECT_THAT(packet.issues, IsEmpty());
}

TEST(OscPacket, ReadsEveryKindOfArgument) {
  // "/a" ",ifsThdFNb": 1, 0.5, "ab", true, 2^40, 0.25, false, nil, blob of 4.
  const OscPacket packet = read_osc(from_hex(
      "2f610000 2c696673 54686446 4e620000 00000001 3f000000 61620000 0000010000000000 3fd0000000000000 "
      "00000004 01020304"));
  ASSERT_EQ(packet.elements.size(), 1u) << packet.issues[0].text;
  const auto& arguments = packet.elements[0].arguments;
  ASSERT_EQ(arguments.size(), 9u);
  EXPECT_EQ(arguments[0].number, 1);
  EXPECT_EQ(arguments[1].number, 0.5);
  EXPECT_EQ(arguments[2].text, "ab");
  EXPECT_EQ(arguments[3].number, 1);
  EXPECT_EQ(arguments[4].number, 1099511627776.0);
  EXPECT_EQ(arguments[5].number, 0.25);
  EXPECT_EQ(arguments[6].number, 0);
  EXPECT_EQ(arguments[8].type, 'b');
}

TEST(OscPacket, ReadsWhatOscsendSends) {
  // oscsend HOST PORT /VMC/Ext/Bone/Pos sfffffff LeftUpperArm -0.13 0 0 0 0 -0.38268343 0.92387953
  const OscPacket packet =
      read_osc(from_hex("2f564d432f4578742f426f6e652f506f73000000 2c73666666666666660000004c6566745570706572"
                        "41726d00000000be051eb800000000000000000000000000000000bec3ef153f6c835e"));
  ASSERT_EQ(packet.elements.size(), 1u);
  EXPECT_EQ(packet.elements[0].address, "/VMC/Ext/Bone/Pos");
  EXPECT_EQ(packet.elements[0].arguments[0].text, "LeftUpperArm");
  EXPECT_FLOAT_EQ(static_cast<float>(packet.elements[0].arguments[1].number), -0.13F);
  EXPECT_FLOAT_EQ(static_cast<float>(packet.elements[0].arguments[7].number), 0.92387953F);
}

TEST(OscPacket, ReadsABundleOfPythonsLibloWithItsTimeTag) {
  const OscPacket packet = read_osc(
      from_hex("2362756e646c6500 ee6b280080000000 00000014 2f564d432f4578742f4f4b002c69000000000001"
               "00000044 2f564d432f4578742f426f6e652f506f73000000 2c7366666666666666000000 486970730000"
               "0000 3e8000003f733333bf000000000000000000000000000000 3f800000 00000014"
               "2f564d432f4578742f5400002c66000040100000"));
  EXPECT_THAT(outline(packet), ElementsAre("(", "/VMC/Ext/OK", "/VMC/Ext/Bone/Pos", "/VMC/Ext/T", ")"));
  EXPECT_EQ(packet.elements[0].time_tag, 0xee6b280080000000u);
  EXPECT_EQ(packet.elements[3].offset, 112u + 4u);
}

TEST(OscPacket, ListsNestedBundlesInTheirOrder) {
  const OscPacket packet = read_osc(from_hex(std::string(bundle_head) + "00000020" + bundle_head +
                                             "0000000c" + small_message + "0000000c" + small_message));
  EXPECT_THAT(outline(packet), ElementsAre("(", "(", "/a", ")", "/a", ")"));
  EXPECT_EQ(packet.elements[0].time_tag, osc_immediately);
}

TEST(OscPacket, KeepsWhatCameBeforeTheCutOfAPacket) {
  Bytes bytes = from_hex(std::string(bundle_head) + "0000000c" + small_message + "00000014" + time_message);
  bytes.resize(bytes.size() - 4);
  const OscPacket packet = read_osc(bytes);
  EXPECT_THAT(outline(packet), ElementsAre("(", "/a", ")"));
  ASSERT_EQ(packet.issues.size(), 1u);
  EXPECT_EQ(packet.issues[0].kind, "truncated");
  EXPECT_EQ(packet.issues[0].offset, 32u);
  EXPECT_THAT(packet.issues[0].text, HasSubstr("an element of 20 bytes in the 16 that are left"));
}

TEST(OscPacket, KeepsWhatComesAfterABadMessage) {
  // The second "/a" has a type that does not exist, the third an argument too few.
  const OscPacket packet = read_osc(
      from_hex(std::string(bundle_head) + "0000000c" + small_message + "0000000c 2f610000 2c7a0000 00000007" +
               "0000000c 2f610000 2c696900 00000007" + "00000014" + time_message));
  EXPECT_THAT(outline(packet), ElementsAre("(", "/a", "/VMC/Ext/T", ")"));
  ASSERT_EQ(packet.issues.size(), 2u);
  EXPECT_EQ(packet.issues[0].kind, "bad-message");
  EXPECT_THAT(packet.issues[0].text, HasSubstr("type tag"));
}

TEST(OscPacket, SaysWhatIsWrongWithAMessage) {
  const auto fault = [](const std::string& hex) {
    const OscPacket packet = read_osc(from_hex(hex));
    EXPECT_THAT(packet.elements, IsEmpty());
    return packet.issues.empty() ? std::string("nothing") : packet.issues[0].text;
  };
  EXPECT_THAT(fault(""), HasSubstr("empty"));
  EXPECT_THAT(fault("2f616263"), HasSubstr("address is not a string"));
  EXPECT_THAT(fault("2f610000"), HasSubstr("no string of type tags"));
  EXPECT_THAT(fault("2f610000 69690000 00000001"), HasSubstr("','"));
  EXPECT_THAT(fault("2f610000 2c696969"), HasSubstr("type tags does not end"));
  EXPECT_THAT(fault("2f610000 2c690000 00000001 00000002"), HasSubstr("4 bytes are left behind"));
  EXPECT_THAT(fault("2f610000 2c690000"), HasSubstr("argument 1 is cut off"));
  EXPECT_THAT(fault("2f610000 2c620000"), HasSubstr("argument 1 is cut off"));
  EXPECT_THAT(fault("2f610000 2c730000 61000061"), HasSubstr("filled up with NUL"));
  EXPECT_THAT(fault("2f610000 2c730000 61616161"), HasSubstr("argument 1 is cut off"));
  EXPECT_THAT(fault("2f610000 2c620000 7fffffff"), HasSubstr("argument 1 is cut off"));
  EXPECT_THAT(fault("4d585450 30320000"), HasSubstr("another protocol"));
  EXPECT_THAT(fault("2362756e 646c6500 00000000"), HasSubstr("its head alone has 16"));
  EXPECT_THAT(fault("2362756e 646c6521 00000000 00000001"), HasSubstr("not with '#bundle'"));
}

TEST(OscPacket, RefusesElementsWhoseLengthCannotBe) {
  const OscPacket packet =
      read_osc(from_hex(std::string(bundle_head) + "00000000" + "00000003 2f6100" + "00"));
  EXPECT_THAT(outline(packet), ElementsAre("(", ")"));
  ASSERT_EQ(packet.issues.size(), 3u);
  EXPECT_EQ(packet.issues[0].kind, "bad-bundle");
  EXPECT_EQ(packet.issues[1].kind, "bad-bundle");
  EXPECT_EQ(packet.issues[2].kind, "truncated");
  const OscPacket huge = read_osc(from_hex(std::string(bundle_head) + "ffffffff 2f610000"));
  EXPECT_EQ(huge.issues.at(0).kind, "truncated");
}

TEST(OscPacket, BoundsTheDepthOfBundles) {
  Bytes bytes = from_hex(small_message);
  for (int depth = 0; depth < 200; ++depth) {
    Bytes outer = from_hex(bundle_head);
    for (int shift = 24; shift >= 0; shift -= 8)
      outer.push_back(static_cast<std::uint8_t>(bytes.size() >> shift));
    outer.insert(outer.end(), bytes.begin(), bytes.end());
    bytes = outer;
  }
  const OscPacket packet = read_osc(bytes);
  EXPECT_EQ(packet.elements.size(), 2u * deepest_osc_bundle);
  ASSERT_EQ(packet.issues.size(), 1u);
  EXPECT_THAT(packet.issues[0].text, HasSubstr("8 deep"));
}

TEST(OscPacket, BoundsTheNumberOfIssues) {
  std::string hex = bundle_head;
  for (int i = 0; i < 10000; ++i) hex += "00000000";
  EXPECT_EQ(read_osc(from_hex(hex)).issues.size(), most_osc_issues);
}

TEST(OscPacket, WritesWhatItReads) {
  const std::vector<OscElement> elements = {
      osc_bundle_begin(77),
      osc_message("/one", {OscArgument::of(3), OscArgument::of(0.1F), OscArgument::of("a text")}),
      osc_bundle_begin(),
      osc_message("/two", {}),
      osc_bundle_end(),
      osc_message("/three", {OscArgument{'d', 1e300, {}}}),
      osc_bundle_end()};
  const Bytes bytes = write_osc(elements);
  EXPECT_EQ(bytes.size() % 4, 0u);
  const OscPacket back = read_osc(bytes);
  EXPECT_THAT(back.issues, IsEmpty());
  ASSERT_EQ(back.elements.size(), elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    EXPECT_EQ(back.elements[i].kind, elements[i].kind);
    EXPECT_EQ(back.elements[i].address, elements[i].address);
    EXPECT_EQ(back.elements[i].time_tag, elements[i].time_tag);
    EXPECT_EQ(back.elements[i].arguments, elements[i].arguments);
  }
  EXPECT_EQ(write_osc(std::vector{osc_message("/VMC/Ext/T", {OscArgument::of(1.5F)})}),
            from_hex(time_message));
}

TEST(OscPacket, RefusesToWriteWhatIsNoPacket) {
  const OscElement message = osc_message("/a", {});
  const auto refused = [](const std::vector<OscElement>& elements) {
    EXPECT_THROW(write_osc(elements), std::invalid_argument);
  };
  refused({});
  refused({message, message});
  refused({osc_bundle_end()});
  refused({osc_bundle_begin(), message});
  refused({osc_bundle_begin(), osc_bundle_end(), message});
  refused({osc_message("/a", {OscArgument{'b', 0, {}}})});
}

/// Memory whose end is followed by a page that must not be touched.
class GuardedMemory {
 public:
  GuardedMemory() : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
    begin_ = static_cast<std::uint8_t*>(
        mmap(nullptr, 3 * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    mprotect(begin_ + 2 * page_, page_, PROT_NONE);
  }
  ~GuardedMemory() { munmap(begin_, 3 * page_); }
  std::span<const std::uint8_t> holding(const Bytes& bytes) {
    std::uint8_t* const at = begin_ + 2 * page_ - bytes.size();
    std::memcpy(at, bytes.data(), bytes.size());
    return {at, bytes.size()};
  }

 private:
  std::size_t page_;
  std::uint8_t* begin_;
};

/// Some bytes changed, the packet cut or filled up; often in the four bytes that lengths and type tags are.
void damage(Bytes& bytes, std::mt19937& random) {
  const auto any = [&](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most - 1)(random);
  };
  for (std::size_t i = 0, changes = 1 + any(4); i < changes && !bytes.empty(); ++i) {
    const std::size_t at = any(bytes.size());
    constexpr std::array<std::uint8_t, 12> likely = {0, 1, 4, 0x7f, 0x80, 0xff, ',', '/', '#', 'b', 's', '['};
    bytes[at] = any(2) == 0 ? likely[any(likely.size())] : static_cast<std::uint8_t>(any(256));
  }
  if (any(4) == 0) bytes.resize(any(bytes.size() + 1));
  if (any(16) == 0) bytes.resize(bytes.size() + any(9));
}

TEST(OscPacket, NeverReadsBeyondAPacketHoweverDamaged) {
  std::vector<Bytes> packets = test::as_vmc_application(test::t_pose(), 1.0F);
  packets.push_back(from_hex(time_message));
  packets.push_back(
      from_hex("2f610000 2c696673 54686446 4e620000 00000001 3f000000 61620000 0000010000000000 "
               "3fd0000000000000 00000004 01020304"));
  packets.push_back(write_osc(
      std::vector{osc_bundle_begin(), osc_message("/VMC/Ext/OK", {OscArgument::of(1)}), osc_bundle_begin(),
                  osc_message("/a", {OscArgument::of("text")}), osc_bundle_end(), osc_bundle_end()}));
  std::mt19937 random(3);
  GuardedMemory memory;
  std::size_t with_issues = 0;
  for (int i = 0; i < 100000; ++i) {
    Bytes bytes = packets[static_cast<std::size_t>(i) % packets.size()];
    damage(bytes, random);
    const OscPacket packet = read_osc(memory.holding(bytes));
    with_issues += packet.issues.empty() ? 0 : 1;
    int depth = 0;
    for (const OscElement& element : packet.elements) {
      depth += element.kind == Kind::BundleBegin ? 1 : element.kind == Kind::BundleEnd ? -1 : 0;
      ASSERT_GE(depth, 0);
      ASSERT_LE(element.offset, bytes.size());
    }
    ASSERT_EQ(depth, 0);
  }
  EXPECT_GT(with_issues, 30000u);
}

}  // namespace
}  // namespace abrazo::osc_packet_test
