#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/motion_format.hpp"

namespace abrazo {

/// Which nodes of a scene hang below which, by index; one may be named below several, or several times.
using SceneHierarchy = std::vector<std::vector<std::size_t>>;

/// The nodes of an FBX, glTF or Collada file as it names them, which need not be a tree. Rather too many
/// links than too few where the file is damaged; an Error where they are unknown, or where values of a glTF
/// file lie outside of its buffers.
Result<SceneHierarchy> scene_hierarchy(std::string_view bytes, MotionFormat format, const std::string& file);

/// What may be read by a reader that descends by recursion and copies what hangs in several places: no
/// circle, at most `deepest` levels, at most `most_copies` when each is copied to wherever it hangs.
Status check_hierarchy(const SceneHierarchy& children, std::size_t deepest, std::size_t most_copies,
                       const std::string& file);

}  // namespace abrazo
