#include "core/stream/protocol/byte_reader.hpp"

#include <algorithm>

namespace abrazo {

void ByteReader::fail(std::string_view why) {
  if (!failed()) failure_ = "at byte " + std::to_string(offset()) + ": " + std::string(why);
}

bool ByteReader::has(std::size_t length, std::string_view what) {
  if (failed()) return false;
  if (length <= left()) return true;
  fail("expected " + std::string(what) + " (" + std::to_string(length) + " bytes), but " +
       std::to_string(left()) + " are left");
  return false;
}

std::uint64_t ByteReader::integer(std::size_t size, std::string_view what) {
  if (!has(size, what)) return 0;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = order_ == ByteOrder::Big ? at_ + i : at_ + size - 1 - i;
    value = value << 8 | bytes_[at];
  }
  at_ += size;
  return value;
}

Vec3 ByteReader::vec3(std::string_view what) {
  if (!has(12, what)) return Vec3::Zero();
  Vec3 vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = static_cast<double>(f32(what));
  return vector;
}

std::size_t ByteReader::count(std::string_view what, std::size_t least_bytes) {
  const std::int32_t number = i32(what);
  if (failed()) return 0;
  if (number < 0 || static_cast<std::size_t>(number) > left() / least_bytes) {
    fail(std::to_string(number) + " " + std::string(what) + " cannot follow, " + std::to_string(left()) +
         " bytes are left");
    return 0;
  }
  return static_cast<std::size_t>(number);
}

std::string ByteReader::c_string(std::string_view what) {
  if (failed()) return {};
  const auto rest = bytes_.subspan(at_);
  const auto end = std::find(rest.begin(), rest.end(), std::uint8_t{0});
  if (end == rest.end()) {
    fail("expected " + std::string(what) + " that ends in a zero byte");
    return {};
  }
  std::string text(rest.begin(), end);
  at_ += text.size() + 1;
  return text;
}

std::string ByteReader::characters(std::size_t length, std::string_view what) {
  if (!has(length, what)) return {};
  const auto from = bytes_.subspan(at_, length);
  at_ += length;
  return {from.begin(), from.end()};
}

void ByteReader::skip(std::size_t length, std::string_view what) {
  if (has(length, what)) at_ += length;
}

ByteReader ByteReader::part(std::size_t length, std::string_view what) {
  const std::size_t from = offset();
  if (!has(length, what)) {
    ByteReader nothing({}, order_, from);
    nothing.failure_ = failure_;
    return nothing;
  }
  ByteReader inner(bytes_.subspan(at_, length), order_, from);
  at_ += length;
  return inner;
}

}  // namespace abrazo
