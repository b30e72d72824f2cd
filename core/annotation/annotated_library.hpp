#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// A take's roles and labels as tiers "role" and "move", seconds = frame / fps of the take, with vocabularies
/// of the values that the library's takes have. Frames whose active performer is unknown are a gap.
/// @throws std::invalid_argument when the library has no such take
Annotations annotations_of_take(const MotionLibrary& library, std::string_view take);

/// The roles and labels that the first role tier and the first move tier say, in frames of the take. Times
/// are rounded to the nearest frame and end with the take; intervals that become empty are left out, and so
/// are moves that say nothing.
/// @return an Error when a role is neither "a" nor "b"
struct TakeAnnotation {
  std::vector<RoleInterval> roles;
  std::vector<LabelInterval> labels;
};
Result<TakeAnnotation> take_annotation(const Annotations& annotations, double fps, int frames);

/// The library with other roles and labels of one take, without rebuilding a mesh: a frame whose active
/// character changed takes the same mesh with the bodies in each other's place. Roles decide which pairs
/// there are, as in building: the annotated assignment, both where nothing is said; both everywhere when the
/// library has both where a role is said. Equal to building it with these annotations, but for the order of
/// mesh elements and, in pairs whose bodies change places, the rounding of poses (1e-12 m) and the few edges
/// where Delaunay is not unique. Pair numbers change when roles do.
Result<MotionLibrary> with_annotation(const MotionLibrary& library, std::string_view take,
                                      const TakeAnnotation& annotation);

}  // namespace abrazo
