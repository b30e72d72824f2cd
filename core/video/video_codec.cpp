#include "core/video/video_codec.hpp"

#include <dlfcn.h>

#include <cstdlib>

#include "core/video/file_kind.hpp"

namespace abrazo {

namespace {

constexpr const char* module_name = "libabrazo-video.so";
constexpr const char* entry_point = "abrazo_video_codec";

Result<const VideoCodec*> load() {
  silence_video_codec();
  std::error_code trouble;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", trouble);
  if (trouble)
    return Error{"videos cannot be read or written, since the program does not find its own place (" +
                     trouble.message() + "); mount /proc",
                 "/proc/self/exe"};
  std::string looked;
  for (const std::filesystem::path& place : video_codec_places(program)) {
    looked += (looked.empty() ? "" : ", ") + place.lexically_normal().string();
    if (!std::filesystem::exists(place, trouble)) continue;
    void* module = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* entry = module ? dlsym(module, entry_point) : nullptr;
    if (!entry)
      return Error{
          std::string("videos cannot be read or written, since a part of the program cannot be loaded (") +
              dlerror() + "); install Abrazo anew",
          place.string()};
    return reinterpret_cast<const VideoCodec* (*)()>(entry)();
  }
  return Error{"videos cannot be read or written, since a part of the program is missing (looked for " +
                   looked + "); install Abrazo anew",
               module_name};
}

}  // namespace

std::vector<std::filesystem::path> video_codec_places(const std::filesystem::path& program) {
  if (!program.is_absolute()) return {};
  const std::filesystem::path folder = program.parent_path();
  return {folder / module_name, folder / ABRAZO_MODULES_FROM_PROGRAMS / module_name};
}

Result<const VideoCodec*> video_codec() {
  static const Result<const VideoCodec*> codec = load();
  return codec;
}

/// The reader reports FFmpeg's problems as messages instead.
void silence_video_codec() {
  // Nothing is fetched from elsewhere, whatever the file refers to, and no list of other files is followed.
  static const std::string options = "protocol_whitelist;file|format_whitelist;" + known_demuxers();
  static const int once =
      setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0) + setenv("OPENCV_FFMPEG_CAPTURE_OPTIONS", options.c_str(), 1);
  static_cast<void>(once);
}

}  // namespace abrazo
