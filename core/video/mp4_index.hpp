#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace abrazo {

/// Up to `count` bytes of a file.
std::string bytes_at(std::ifstream& stream, std::uint64_t at, std::uint64_t count);

/// The index ("moov") of an MP4 or QuickTime file of `size` bytes, at most 16 MB of it; empty if there is none.
std::string mp4_index(std::ifstream& stream, std::uint64_t size);

/// How the coded pictures of a file are to be shown: mirrored left to right if so, then turned.
struct PictureOrientation {
  bool is_mirrored = false;
  int turn_deg = 0;     ///< clockwise: 0, 90, 180, 270
  double told_deg = 0;  ///< the turn in the file; if it is none of these, the pictures are not turned
};

/// By the display matrix of its first track of pictures (ISO/IEC 14496-12, 8.3.2); none if the file has no
/// such matrix.
std::optional<PictureOrientation> mp4_orientation(const std::filesystem::path& file);

}  // namespace abrazo
