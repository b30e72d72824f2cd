#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Places of markers on a body. All except the first eight come in pairs: index 0 left, 1 right.
enum class MarkerPlace {
  Neck,      ///< C7, at the back
  Back,      ///< T10
  Clavicle,  ///< between the collar bones, in front
  Sternum,
  Sacrum,  ///< if the pelvis has no two markers at the back
  HeadTop,
  HeadFront,
  HeadSide,
  HeadFrontSide,  ///< temples; sided from here on
  HeadBackSide,
  PelvisFront,  ///< ASIS
  PelvisBack,   ///< PSIS
  Shoulder,     ///< acromion
  UpperArm,
  Elbow,  ///< outer epicondyle
  ElbowInner,
  WristThumb,
  WristLittle,
  Hand,  ///< head of a middle metacarpal
  Thigh,
  Knee,  ///< outer
  KneeInner,
  Shin,
  Ankle,  ///< outer malleolus
  AnkleInner,
  Heel,
  Toe,  ///< head of the 2nd metatarsal; several: their mean
  ToeTip,
  Count
};
inline constexpr std::size_t marker_place_count = static_cast<std::size_t>(MarkerPlace::Count);

/// A named set of markers on a body, from which the 25 joints can be estimated.
struct MarkerModel {
  std::string name;  ///< "plug-in-gait"
  /// Possible names of a marker per place and side; the first that exists is used. Unsided places: side 0.
  std::array<std::array<std::vector<std::string>, 2>, marker_place_count> names;
  bool toes_are_mean = false;  ///< the toe is the mean of all its markers; the names are not alternatives
};

/// "plug-in-gait" (Vicon's full body, with or without inner markers), "cmu-markers" (the 41 of the CMU
/// laboratory), "optitrack-baseline" (37 or 41).
const std::vector<MarkerModel>& builtin_marker_models();

/// Required markers that are not among the points. Empty: the model fits.
std::vector<std::string> missing_markers(const MarkerModel& model, const std::vector<std::string>& points);

/// The 25 joints, named as in the joint set, in the file's unit: docs/guide/formats.md gives the definitions.
/// @param metres_per_unit the estimates depend on sizes of bodies and markers
/// @return an Error that names the marker and the frames, if a required marker has gaps
Result<NamedMotion> joints_of_markers(const MarkerModel& model, const NamedMotion& markers,
                                      double metres_per_unit);

/// The unit (millimetre, centimetre, inch or metre) in which a person with these markers has a usual size
/// [m].
double unit_of_markers(const MarkerModel& model, const NamedMotion& markers);

}  // namespace abrazo
