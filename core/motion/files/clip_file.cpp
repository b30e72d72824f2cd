#include "core/motion/files/clip_file.hpp"

#include <algorithm>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/motion/numpy/numpy_writer.hpp"
#include "core/motion/scenes/glb_writer.hpp"
#include "core/motion/tables/clip_csv.hpp"

namespace abrazo {

namespace {

/// The clips with their positions as the file has them.
std::vector<Clip> in_space(std::span<const Clip> clips, double scale, UpAxis up) {
  std::vector<Clip> moved(clips.begin(), clips.end());
  for (Clip& clip : moved)
    for (Pose& pose : clip.poses) {
      turn_from_y_up(pose, up);
      pose *= scale;
    }
  return moved;
}

}  // namespace

Status check_clip_file(const std::string& path, const ClipFileSpace& space, std::size_t bodies) {
  const bool is_known = std::ranges::any_of(clip_file_types, [&](auto type) { return path.ends_with(type); });
  if (!is_known) return Error{"this file type cannot be written; use .bvh, .glb, .csv, .npz or .npy", path};
  if (path.ends_with(".glb") && !space.is_usual())
    return Error{"a GLB is in metres with Y up, whatever reads it; choose unit and axis for other types",
                 path};
  if (path.ends_with(".npy") && bodies > 1)
    return Error{"a .npy holds one body; write the " + std::to_string(bodies) + " as .npz, or one by one",
                 path};
  if (!space.joints) return Done{};
  if (!path.ends_with(".npy") && !path.ends_with(".npz"))
    return Error{"an order of joints is for .npz and .npy; others have the 25 joints with their names", path};
  const auto points = OrderedPoints::of(*space.joints);
  if (!points) return points.error();
  return Done{};
}

Result<std::string> clip_file_content(const std::string& path, std::span<const Clip> clips,
                                      const ClipFileSpace& space) {
  if (const Status checked = check_clip_file(path, space, clips.size()); !checked) return checked.error();
  if (path.ends_with(".glb")) return write_glb(clips);
  const bool is_bvh = path.ends_with(".bvh");
  // A BVH is scaled by its writer: the end sites of its bones are not among the positions.
  const double scale = is_bvh ? 1 : space.units_per_metre;
  std::vector<Clip> moved;
  if (scale != 1 || space.up != UpAxis::Y) {
    moved = in_space(clips, scale, space.up);
    clips = moved;
  }
  if (is_bvh) return write_bvh(clips, space.units_per_metre);
  if (path.ends_with(".csv")) return write_clip_csv(clips);
  const JointOrder& order = space.joints ? *space.joints : builtin_joint_orders().front();
  if (path.ends_with(".npy")) return write_npy(clips.front(), order);
  return write_npz(clips, order, space.up, 1 / space.units_per_metre);
}

Status write_clip_file(const std::string& path, std::span<const Clip> clips, const ClipFileSpace& space) {
  const auto content = clip_file_content(path, clips, space);
  if (!content) return content.error();
  return write_whole_file(path, *content);
}

}  // namespace abrazo
