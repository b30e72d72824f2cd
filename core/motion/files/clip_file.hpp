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

/// The types that clips can be written as, by the ending of a file's name.
inline constexpr std::array<std::string_view, 5> clip_file_types = {".bvh", ".glb", ".csv", ".npz", ".npy"};

/// The unit and the axes of a file, where its type leaves them open: all but GLB, which is in metres, Y up.
struct ClipFileSpace {
  double units_per_metre = 1;
  UpAxis up = UpAxis::Y;                  ///< Z: x stays, y goes to the back (Blender's axes)
  std::optional<JointOrder> joints = {};  ///< of a .npy or .npz; nothing = the 25

  bool is_usual() const { return units_per_metre == 1 && up == UpAxis::Y; }
};

/// Whether clips can be written to a file of this name; the Error names the types there are, or says that
/// this one has its own unit and axes, cannot hold so many bodies, or cannot have that order of joints.
Status check_clip_file(const std::string& path, const ClipFileSpace& space = {}, std::size_t bodies = 1);

/// The content of a file of that type with these clips.
Result<std::string> clip_file_content(const std::string& path, std::span<const Clip> clips,
                                      const ClipFileSpace& space = {});

/// Writes it, whole or not at all.
Status write_clip_file(const std::string& path, std::span<const Clip> clips, const ClipFileSpace& space = {});

}  // namespace abrazo
