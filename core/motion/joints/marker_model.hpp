#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Where on a body a marker is. All but the first eight come in pairs: index 0 left, 1 right.
enum class MarkerPlace {
  Neck,      ///< C7, at the back
  Back,      ///< T10
  Clavicle,  ///< between the collar bones, in front
  Sternum,
  Sacrum,  ///< where there are no two at the back of the pelvis
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
  /// Per place and side the names a marker may have; the first that exists is taken. Unsided: side 0.
  std::array<std::array<std::vector<std::string>, 2>, marker_place_count> names;
  bool toes_are_mean = false;  ///< all of the toe's names are one point's surroundings, not alternatives
};

/// "plug-in-gait" (Vicon's full body, with or without inner markers), "cmu-markers" (the 41 of the CMU
/// laboratory), "optitrack-baseline" (37 or 41).
const std::vector<MarkerModel>& builtin_marker_models();

/// Markers without which the model cannot be used and which are not among the points. Empty: it fits.
std::vector<std::string> missing_markers(const MarkerModel& model, const std::vector<std::string>& points);

/// The 25 joints, named as in the joint set, in the file's unit: docs/guide/formats.md says how each is
/// found.
/// @param metres_per_unit  the estimates know sizes of bodies and markers
/// @return an Error that names the marker and the frames, when one that is needed has gaps
Result<NamedMotion> joints_of_markers(const MarkerModel& model, const NamedMotion& markers,
                                      double metres_per_unit);

/// The unit, of millimetres, centimetres, inches and metres, in which a person with these markers has a
/// usual size [m].
double unit_of_markers(const MarkerModel& model, const NamedMotion& markers);

}  // namespace abrazo
