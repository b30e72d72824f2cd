#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// A take's roles and labels as tiers "role" and "move", seconds = frame / fps of the take, with vocabularies
/// of the library's values. Frames with unknown active performer are gaps.
/// @throws std::invalid_argument if the library has no such take
Annotations annotations_of_take(const MotionLibrary& library, std::string_view take);

/// Roles and labels of the first role tier and the first move tier, in frames of the take. Times are rounded
/// to the nearest frame and limited to the take; empty intervals and moves without a value are left out.
/// @return an Error if a role is neither "a" nor "b"
struct TakeAnnotation {
  std::vector<RoleInterval> roles;
  std::vector<LabelInterval> labels;
};
Result<TakeAnnotation> take_annotation(const Annotations& annotations, double fps, int frames);
using TakeAnnotations = std::map<std::string, TakeAnnotation, std::less<>>;  ///< by name of the take

/// The library with other roles and labels of some takes, without rebuilding meshes: a frame whose active
/// character changed reuses its mesh with the bodies exchanged. Roles determine the pairs, as in a build: the
/// annotated assignment, both assignments where there is no role, and both everywhere if the library was
/// built with both roles. Equal to a build with these annotations, except the order of mesh elements and, in
/// exchanged pairs, the rounding of poses (1e-12 m) and the few edges where Delaunay is not unique. Pair
/// numbers change if roles change.
Result<MotionLibrary> with_annotations(const MotionLibrary& library, const TakeAnnotations& takes);

}  // namespace abrazo
