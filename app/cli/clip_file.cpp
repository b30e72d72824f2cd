#include "app/cli/clip_file.hpp"

#include "core/base/atomic_file.hpp"
#include "core/motion/bvh.hpp"
#include "core/motion/clip_csv.hpp"
#include "core/motion/glb_writer.hpp"

namespace abrazo::app {

Status check_clip_file(const std::string& path) {
  for (const char* extension : {".bvh", ".glb", ".csv"})
    if (path.ends_with(extension)) return Done{};
  return Error{"this file type cannot be written; use .bvh, .glb or .csv", path};
}

Result<std::string> clip_file_content(const std::string& path, std::span<const Clip> clips) {
  if (path.ends_with(".bvh")) return write_bvh(clips);
  if (path.ends_with(".glb")) return write_glb(clips);
  return write_clip_csv(clips);
}

Status write_clip_file(const std::string& path, std::span<const Clip> clips) {
  const auto content = clip_file_content(path, clips);
  if (!content) return content.error();
  return write_whole_file(path, *content);
}

}  // namespace abrazo::app
