#include "core/base/checksum.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace abrazo::checksum_test {
namespace {

template <typename... Parts>
std::uint64_t sum_of(const Parts&... parts) {
  Checksum sum;
  (sum.add(parts), ...);
  return std::bit_cast<std::uint64_t>(sum.value());
}

TEST(Checksum, OfBytesIsFnv1a) {
  EXPECT_EQ(sum_of(), 0xcbf29ce484222325ULL);
  EXPECT_EQ(sum_of(std::string_view("a")), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(sum_of(std::string_view("foobar")), 0x85944171f73967e8ULL);
  const std::vector<std::uint8_t> bytes = {'b', 'a', 'r'};
  EXPECT_EQ(sum_of(std::string_view("foo"), std::span(bytes)), sum_of(std::string_view("foobar")));
}

// Session files keep these: another number would make every recorded row a damaged one.
TEST(Checksum, OfNumbersStaysWhatFilesHave) {
  EXPECT_EQ(sum_of(std::uint64_t{5}, std::uint64_t{1} << 63), 0xa2df29bc01b47004ULL);
}

TEST(ContentHash, StaysWhatFilesHave) {
  ContentHash hash;
  hash.add(std::uint64_t{0});
  hash.add(std::uint64_t{1});
  hash.add(std::uint64_t{0x0123456789abcdef});
  hash.add(0.25);
  EXPECT_EQ(hash.text(), "66f661bdadfe54d0");
}

}  // namespace
}  // namespace abrazo::checksum_test
