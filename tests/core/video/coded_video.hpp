#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/video/video_frame.hpp"

namespace abrazo::test {

/// A picture that carries a number in squares of black and white that survive any compression.
cv::Mat coded_picture(int number, cv::Size size);
/// The number in it, also where it was compressed; -1 where it cannot be read. It must be upright.
int code_of(const VideoFrame& frame);

/// Writes pictures 0 .. pictures - 1. @return false where this machine's OpenCV lacks the encoder
bool write_coded_video(const std::filesystem::path& file, const std::string& fourcc, int pictures, double fps,
                       cv::Size size = {320, 240});

// Changes to an .mp4 that no encoder at hand makes.
/// Each picture is shown so many ticks (of `fps` x `ticks`); (pictures, ticks) one after the other.
void set_durations(const std::filesystem::path& file,
                   const std::vector<std::pair<std::uint32_t, std::uint32_t>>& runs);
/// The matrix that says how far it has to be turned clockwise, after it was mirrored left to right if so.
void set_rotation(const std::filesystem::path& file, double degrees, bool is_mirrored = false);
/// The number of ticks a picture is shown for while all are alike.
std::uint32_t even_duration(const std::filesystem::path& file);

}  // namespace abrazo::test
