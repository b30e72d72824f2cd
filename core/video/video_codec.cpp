#include "core/video/video_codec.hpp"

#include <dlfcn.h>

#include <array>
#include <cstdlib>

namespace abrazo {

namespace {

constexpr const char* module_name = "libabrazo-video.so";
constexpr const char* entry_point = "abrazo_video_codec";

/// Beside the program, as it is built, or where it is installed; nowhere that others may write to.
std::array<std::filesystem::path, 2> places() {
  std::error_code trouble;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", trouble).parent_path();
  return {folder / module_name, folder / ABRAZO_MODULES_FROM_PROGRAMS / module_name};
}

Result<const VideoCodec*> load() {
  silence_video_codec();
  std::string looked;
  for (const std::filesystem::path& place : places()) {
    std::error_code trouble;
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

Result<const VideoCodec*> video_codec() {
  static const Result<const VideoCodec*> codec = load();
  return codec;
}

/// What FFmpeg has to say of a file is said by the reader, as a message instead.
void silence_video_codec() {
  // Nor is anything fetched from elsewhere, whatever a file says inside.
  static const int once = setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0) +
                          setenv("OPENCV_FFMPEG_CAPTURE_OPTIONS", "protocol_whitelist;file", 1);
  static_cast<void>(once);
}

}  // namespace abrazo
