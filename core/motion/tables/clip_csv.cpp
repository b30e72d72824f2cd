#include "core/motion/tables/clip_csv.hpp"

#include "core/base/text.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

Result<std::string> write_clip_csv(std::span<const Clip> clips) {
  if (clips.empty()) return Error{"there is no clip to write", "CSV"};
  for (const Clip& clip : clips)
    if (clip.poses.size() != clips.front().poses.size())
      return Error{"clips of different lengths cannot share a file; write one file each", clip.name};
  std::string text = "frame,time";
  for (const Clip& clip : clips)
    for (const std::string_view joint : joint_names)
      for (const char axis : {'x', 'y', 'z'}) {
        text += ',';
        if (clips.size() > 1) text += clip.name + '.';
        text += joint;
        text += '_';
        text += axis;
      }
  text += '\n';
  for (std::size_t frame = 0; frame < clips.front().poses.size(); ++frame) {
    text += std::to_string(frame) + ',' + exact_text(static_cast<double>(frame) / clips.front().fps);
    for (const Clip& clip : clips)
      for (int joint = 0; joint < joint_count; ++joint)
        for (int axis = 0; axis < 3; ++axis) text += ',' + exact_text(clip.poses[frame](joint, axis));
    text += '\n';
  }
  return text;
}

}  // namespace abrazo
