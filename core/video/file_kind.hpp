#pragma once

#include <filesystem>
#include <string>

namespace abrazo {

/// What a file is that does not open as a video, and what to do, by its content. To follow the file's name in
/// a message: "holds sound and no pictures; choose the file with the pictures"
std::string why_no_video(const std::filesystem::path& file);

/// Whether it begins as text and so contains no pictures. Playlists of other files and addresses (HLS, DASH,
/// concat, SDP) do, and a video library would open these.
bool is_text_file(const std::filesystem::path& file);

}  // namespace abrazo
