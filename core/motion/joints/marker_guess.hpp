#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/joints/marker_model.hpp"

namespace abrazo {

/// Guessed places of a file's markers on the body, if their names are unknown; for a person to check.
struct MarkerGuess {
  struct Marker {
    int point = -1;
    MarkerPlace place = MarkerPlace::Count;
    std::size_t side = 0;   ///< as in MarkerModel
    double confidence = 0;  ///< 0 to 1
  };
  std::vector<Marker> markers;  ///< by place and side
  double confidence = 0;        ///< mean over all points; one without a place counts as 0
  UpAxis up_axis = UpAxis::Y;
  bool front_from_walking = false;  ///< the person walks; otherwise only feet and pelvis give the direction

  /// A model of the markers with at least this confidence.
  MarkerModel model(const NamedMotion& motion, double least_confidence) const;
};

/// Guesses with this confidence are used unless a person changes them.
inline constexpr double sure_enough_of_marker = 0.6;

/// Compares the mean place of each marker, in the space of the trunk and in body heights, with a standing
/// person whose arms hang, are bent, or are stretched out; markers left and right of the body are placed in
/// pairs. Markers at constant distances belong to one segment. The front is the direction of walking
/// and of the toes. Names are not used.
/// @return an Error for fewer than 12 points, or if most markers are visible in hardly any frame
Result<MarkerGuess> guess_markers(const NamedMotion& motion);

}  // namespace abrazo
