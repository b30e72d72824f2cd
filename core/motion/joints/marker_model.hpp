#pragma once

#include <array>
#include <string>
#include <string_view>
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
  Ear,
  ClavicleSide,  ///< on each collar bone, where there is none between them
  PelvisFront,   ///< ASIS
  PelvisBack,    ///< PSIS
  Shoulder,      ///< acromion
  UpperArm,
  Elbow,  ///< outer epicondyle
  ElbowInner,
  WristThumb,
  WristLittle,
  Hand,       ///< head of a middle metacarpal
  HandThumb,  ///< head of the 2nd metacarpal; with the next an alternative to a middle one
  HandLittle,
  Thigh,
  Knee,  ///< outer
  KneeInner,
  Shin,
  Ankle,  ///< outer malleolus
  AnkleInner,
  Heel,
  Toe,       ///< head of the 2nd metatarsal
  ToeInner,  ///< of the 1st; with the next an alternative to the 2nd
  ToeOuter,  ///< of the 5th
  ToeTip,
  Count
};
inline constexpr std::size_t marker_place_count = static_cast<std::size_t>(MarkerPlace::Count);
inline constexpr std::size_t first_sided_place = static_cast<std::size_t>(MarkerPlace::HeadFrontSide);

/// "outer knee", as in files; with the side before it where there are two: "left outer knee".
std::string name_of_place(MarkerPlace place, std::size_t side);

/// A named set of markers on a body, from which the 25 joints can be estimated.
struct MarkerModel {
  std::string name;  ///< "plug-in-gait"
  /// Possible names of a marker per place and side; the first that exists is used. Unsided places: side 0.
  std::array<std::array<std::vector<std::string>, 2>, marker_place_count> names;
};

/// The sets of laboratories that are known by name; docs/guide/formats.md lists them. The last, "landmarks",
/// has the names of all others, for files that mix them.
const std::vector<MarkerModel>& builtin_marker_models();

/// A model from a JSON file: {"name": "...", "markers": {"neck": "C7", "left shoulder": ["LSHO", "LACR"],
/// ...}}.
Result<MarkerModel> parse_marker_model(std::string_view json, std::string_view where);

/// Whether a file's text is a marker model rather than a joint map.
bool is_marker_model(std::string_view json);

/// The JSON that reads back to the same model.
std::string marker_model_json(const MarkerModel& model);

/// Markers without which the model cannot be used and which are not among the points. Empty: it fits.
std::vector<std::string> missing_markers(const MarkerModel& model, const std::vector<std::string>& points);

/// How much of a model is among some points.
struct MarkerFit {
  const MarkerModel* model = nullptr;
  std::size_t found = 0;             ///< of its places
  std::vector<std::string> missing;  ///< missing_markers
  bool legs = false, arms = false;   ///< the pelvis, knees and ankles; elbows and wrists of both sides
  bool shoulders = false;
};

/// The first built-in model that fits, otherwise the one with most places found, and among equals the
/// one with fewest missing.
MarkerFit nearest_marker_model(const std::vector<std::string>& points);
MarkerFit fit_of(const MarkerModel& model, const std::vector<std::string>& points);

/// A sentence that says why the points are not a whole body in that model: "the markers are of the lower body
/// ...".
std::string why_no_body(const MarkerFit& fit);

/// For a person who gives places to markers: which joints no marker tells of, the places without which the
/// file cannot be used, and what helps. Empty if nothing is missing.
std::string why_not_enough(const MarkerFit& fit);

/// The 25 joints, named as in the joint set, in the file's unit: docs/guide/formats.md says how each is
/// found. Joints without markers (head, hands) are inferred and named in a warning.
/// @param metres_per_unit  the estimates know sizes of bodies and markers
/// @return an Error that names the marker and the frames if a required marker has gaps
Result<NamedMotion> joints_of_markers(const MarkerModel& model, const NamedMotion& markers,
                                      double metres_per_unit);

/// The unit (millimetre, centimetre, inch or metre) in which a person with these markers has a usual size
/// [m].
double unit_of_markers(const MarkerModel& model, const NamedMotion& markers);

}  // namespace abrazo
