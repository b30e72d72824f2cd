#include "core/video/mp4_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <system_error>

namespace abrazo {
namespace {

constexpr std::uint64_t most_boxes = 4096;          // at the top of a file; a real one has a handful
constexpr std::uint64_t most_searched = 16u << 20;  // bytes of its index that are looked through

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8 | static_cast<std::uint8_t>(c);
  return value;
}

/// The content of the box of this type that begins at or behind `at` in a run of boxes; none if there is none.
/// @param at  afterwards behind it
std::optional<std::string_view> next_box(std::string_view boxes, std::string_view type, std::size_t& at) {
  while (at + 8 <= boxes.size()) {
    const std::string_view rest = boxes.substr(at);
    std::size_t head = 8;
    std::uint64_t length = big_endian(rest.substr(0, 4));
    if (length == 1 && rest.size() >= 16) length = big_endian(rest.substr(8, 8)), head = 16;
    if (length == 0) length = rest.size();
    if (length < head) return std::nullopt;
    const std::string_view box = rest.substr(0, length);
    at += box.size();
    if (box.substr(4, 4) == type) return box.substr(std::min(head, box.size()));
  }
  return std::nullopt;
}

std::optional<std::string_view> first_box(std::string_view boxes, std::string_view type) {
  std::size_t at = 0;
  return next_box(boxes, type, at);
}

bool is_of_pictures(std::string_view track) {
  const auto media = first_box(track, "mdia");
  const auto handler = media ? first_box(*media, "hdlr") : std::nullopt;
  return handler && handler->size() >= 12 && handler->substr(8, 4) == "vide";
}

/// a, b, c, d of the matrix (x, y) -> (a x + c y, b x + d y), y down.
std::optional<std::array<double, 4>> matrix_of(std::string_view track) {
  const auto header = first_box(track, "tkhd");
  if (!header || header->empty()) return std::nullopt;
  const std::size_t at = (*header)[0] == 1 ? 52 : 40;  // version 1 has times of 64 bits
  if (header->size() < at + 20) return std::nullopt;
  std::array<double, 4> matrix{};
  constexpr std::array<std::size_t, 4> places = {0, 4, 12, 16};
  for (std::size_t i = 0; i < 4; ++i)
    matrix[i] = static_cast<std::int32_t>(big_endian(header->substr(at + places[i], 4))) / 65536.0;
  return matrix;
}

PictureOrientation orientation_of(const std::array<double, 4>& matrix) {
  constexpr double near_deg = 0.5;
  const auto [a, b, c, d] = matrix;
  PictureOrientation orientation;
  orientation.is_mirrored = a * d - b * c < 0;
  const double sign = orientation.is_mirrored ? -1 : 1;
  const double degrees = std::atan2(sign * b, sign * a) * 180 / std::numbers::pi;
  orientation.told_deg = degrees < -near_deg ? degrees + 360 : degrees;
  const double quarters = std::round(orientation.told_deg / 90);
  if (std::abs(orientation.told_deg - 90 * quarters) <= near_deg)
    orientation.turn_deg = static_cast<int>(quarters) % 4 * 90;
  return orientation;
}

}  // namespace

std::string bytes_at(std::ifstream& stream, std::uint64_t at, std::uint64_t count) {
  std::string bytes(count, '\0');
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(at));
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

std::string mp4_index(std::ifstream& stream, std::uint64_t size) {
  std::uint64_t at = 0;
  for (std::uint64_t box = 0; box < most_boxes && at + 8 <= size; ++box) {
    const std::string head = bytes_at(stream, at, 16);
    if (head.size() < 8) break;
    std::uint64_t length = big_endian(std::string_view(head).substr(0, 4));
    if (length == 1 && head.size() == 16) length = big_endian(std::string_view(head).substr(8));
    if (length == 0) length = size - at;
    if (head.substr(4, 4) == "moov" || head.substr(4, 4) == "moof")
      return bytes_at(stream, at, std::min(length, most_searched));
    if (length < 8 || length > size - at) break;
    at += length;
  }
  return {};
}

std::optional<PictureOrientation> mp4_orientation(const std::filesystem::path& file) {
  std::error_code failure;
  const std::uint64_t size = std::filesystem::file_size(file, failure);
  std::ifstream stream(file, std::ios::binary);
  if (failure || !stream) return std::nullopt;
  const std::string index = mp4_index(stream, size);
  const auto movie = first_box(index, "moov");
  std::size_t at = 0;
  for (auto track = movie ? next_box(*movie, "trak", at) : std::nullopt; track; track = next_box(*movie, "trak", at)) {
    if (!is_of_pictures(*track)) continue;
    const auto matrix = matrix_of(*track);
    return matrix ? std::optional(orientation_of(*matrix)) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace abrazo
