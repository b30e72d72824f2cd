#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "core/base/result.hpp"

namespace abrazo {

/// Writes pictures as an MPEG-4 video. The file appears under its name when it is complete, or not at all.
class VideoWriter {
 public:
  /// @param width, height  of every picture [pixels], even
  static Result<VideoWriter> open(const std::filesystem::path& file, int width, int height, double fps);
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  ~VideoWriter();

  /// @param rgb    red, green, blue per pixel, rows from the top
  /// @param stride bytes from one row to the next
  Status add(std::span<const std::uint8_t> rgb, std::size_t stride);
  int frames() const;

  /// Closes the file, verifies the number of frames, and renames it.
  Status finish();

 private:
  struct State;
  explicit VideoWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace abrazo
