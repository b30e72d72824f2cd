#pragma once

#include <filesystem>
#include <string>

namespace abrazo {

/// What a file is that does not open as a video, and what to do, by its content. To follow the file's name in
/// a message: "holds sound and no pictures; choose the file with the pictures"
std::string why_no_video(const std::filesystem::path& file);

/// Whether it begins as one of the containers that are read. Only these are given to FFmpeg, since others can
/// be lists of files and addresses that it would open (HLS, DASH, concat, SDP).
bool is_known_container(const std::filesystem::path& file);

/// Names of FFmpeg's demuxers for these containers, with commas between: the others are not to be used.
std::string known_demuxers();

}  // namespace abrazo
