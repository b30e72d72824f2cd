#include "tests/core/video/coded_video.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "core/base/atomic_file.hpp"

namespace abrazo::test {
namespace {

constexpr int bits = 12, columns = 4, square_px = 32, edge_px = 16;

cv::Rect square_of(int bit) {
  return {edge_px + bit % columns * square_px, edge_px + bit / columns * square_px, square_px, square_px};
}

void put(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

std::uint32_t get(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

std::string read(const std::filesystem::path& file) {
  return read_whole_file(file).value();
}

/// Where the box begins: at its length.
std::size_t box(const std::string& bytes, const char* name) {
  const std::size_t index = bytes.rfind("moov");
  const std::size_t at = bytes.find(name, index);
  if (index == std::string::npos || at == std::string::npos) throw std::runtime_error("no such box");
  return at - 4;
}

}  // namespace

cv::Mat coded_picture(int number, cv::Size size) {
  cv::Mat picture(size, CV_8UC3, cv::Scalar(96, 96, 96));
  for (int bit = 0; bit < bits; ++bit)
    cv::rectangle(picture, square_of(bit),
                  (number >> bit & 1) != 0 ? cv::Scalar(235, 235, 235) : cv::Scalar(20, 20, 20), cv::FILLED);
  // Upright: a bar at the lower end.
  cv::rectangle(picture, cv::Rect(0, size.height - 24, size.width, 24), cv::Scalar(20, 20, 220), cv::FILLED);
  return picture;
}

int code_of(const VideoFrame& frame) {
  const auto at = [&frame](int x, int y, int channel) {
    return frame.rgb[(static_cast<std::size_t>(y) * frame.width + x) * 3 + channel];
  };
  const int low = frame.height - 12, middle = frame.width / 2;
  if (at(middle, low, 0) < 150 || at(middle, low, 2) > 100) return -1;
  int number = 0;
  for (int bit = 0; bit < bits; ++bit) {
    const cv::Rect square = square_of(bit);
    const int value = at(square.x + square.width / 2, square.y + square.height / 2, 1);
    if (value > 80 && value < 170) return -1;
    if (value >= 170) number |= 1 << bit;
  }
  return number;
}

bool write_coded_video(const std::filesystem::path& file, const std::string& fourcc, int pictures, double fps,
                       cv::Size size) {
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG,
                         cv::VideoWriter::fourcc(fourcc[0], fourcc[1], fourcc[2], fourcc[3]), fps, size);
  if (!writer.isOpened()) return false;
  for (int i = 0; i < pictures; ++i) writer.write(coded_picture(i, size));
  writer.release();
  return std::filesystem::exists(file) && std::filesystem::file_size(file) > 0;
}

void set_durations(const std::filesystem::path& file,
                   const std::vector<std::pair<std::uint32_t, std::uint32_t>>& runs) {
  std::string bytes = read(file);
  const std::size_t at = box(bytes, "stts");
  const std::uint32_t had = get(bytes, at), has = 16 + 8 * static_cast<std::uint32_t>(runs.size());
  std::string table(has, '\0');
  put(table, 0, has);
  table.replace(4, 4, "stts");
  put(table, 12, static_cast<std::uint32_t>(runs.size()));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    put(table, 16 + 8 * i, runs[i].first);
    put(table, 20 + 8 * i, runs[i].second);
  }
  // The index stands behind the pictures, so that they stay where it says.
  for (const char* around : {"moov", "trak", "mdia", "minf", "stbl"}) {
    const std::size_t outer = box(bytes, around);
    put(bytes, outer, get(bytes, outer) + has - had);
  }
  bytes.replace(at, had, table);
  if (!write_whole_file(file, bytes)) throw std::runtime_error("not written");
}

std::uint32_t even_duration(const std::filesystem::path& file) {
  const std::string bytes = read(file);
  return get(bytes, box(bytes, "stts") + 20);
}

void set_rotation(const std::filesystem::path& file, double degrees, bool is_mirrored) {
  std::string bytes = read(file);
  const std::size_t at = box(bytes, "tkhd") + 8 + 40;  // version 0: the matrix follows 40 bytes of header
  const auto fixed_point = [](double value) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 65536)));
  };
  const double turn = degrees * std::numbers::pi / 180, side = is_mirrored ? -1 : 1;
  put(bytes, at, fixed_point(side * std::cos(turn)));
  put(bytes, at + 4, fixed_point(side * std::sin(turn)));
  put(bytes, at + 12, fixed_point(-std::sin(turn)));
  put(bytes, at + 16, fixed_point(std::cos(turn)));
  if (!write_whole_file(file, bytes)) throw std::runtime_error("not written");
}

}  // namespace abrazo::test
