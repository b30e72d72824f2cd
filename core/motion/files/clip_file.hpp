#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/files/import_clip.hpp"

namespace abrazo {

/// File types for writing clips, by file extension.
inline constexpr std::array<std::string_view, 5> clip_file_types = {".bvh", ".glb", ".csv", ".npz", ".npy"};

/// Unit and axes of a file, if its type leaves them open: all except GLB, which is in metres, Y up.
struct ClipFileSpace {
  double units_per_metre = 1;
  UpAxis up = UpAxis::Y;                  ///< Z: x unchanged, y to the back (Blender's axes)
  std::optional<JointOrder> joints = {};  ///< for .npy and .npz; none = the 25 joints

  bool is_usual() const { return units_per_metre == 1 && up == UpAxis::Y; }
};

/// Checks that clips can be written to a file of this name. The Error lists the types, or says that the type
/// has fixed unit and axes, cannot hold this number of bodies, or does not support the order of joints.
Status check_clip_file(const std::string& path, const ClipFileSpace& space = {}, std::size_t bodies = 1);

/// The content of a file of that type with these clips.
Result<std::string> clip_file_content(const std::string& path, std::span<const Clip> clips,
                                      const ClipFileSpace& space = {});

/// Writes the file, completely or not at all.
Status write_clip_file(const std::string& path, std::span<const Clip> clips, const ClipFileSpace& space = {});

}  // namespace abrazo
