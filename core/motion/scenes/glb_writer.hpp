#pragma once

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"

namespace abrazo {

/// Clips as one binary glTF 2.0 file (metres, seconds, Y up, right-handed, facing +Z: as here). Each clip is
/// a character: a node of its name with a skeleton of nodes named like the joints below it, a skin whose bind
/// pose is a T-pose over the origin, and a body surface with a separate colour. All clips move in one
/// animation: a rotation track for every node, a translation track for the root and for joints whose distance
/// from their parent is not constant. At every key the nodes stand where the clips' joints are (to some 1e-5
/// m). Names are prefixed by "<clip name>:" when there are several clips, which may differ in length and
/// rate.
Result<std::string> write_glb(std::span<const Clip> clips);

}  // namespace abrazo
