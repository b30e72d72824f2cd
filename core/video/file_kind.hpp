#pragma once

#include <filesystem>
#include <string>

namespace abrazo {

/// What a file is that does not open as a video, and what to do, by its own bytes: fit to follow the file's
/// name in a message. "holds sound and no pictures; choose the file with the pictures"
std::string why_no_video(const std::filesystem::path& file);

/// Whether it begins as text and so holds no pictures itself. Lists of other files and addresses do (HLS,
/// DASH, concat, SDP), which a video library would go and open.
bool is_text_file(const std::filesystem::path& file);

}  // namespace abrazo
