#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/joints/marker_model.hpp"

namespace abrazo {

/// A model of markers whose names are of no known set, by the parts of the names: side, segment and place on
/// it ("rshld", "R.Knee.Lat", "lankbk"). Two markers on opposite sides of a joint, front and back or top and
/// low, have it in their middle. Toes without a marker are places that add_inferred_toes adds.
/// @return nothing unless all places are found without which a model cannot be used
std::optional<MarkerModel> marker_model_by_words(const std::vector<std::string>& points);

/// Adds the toes that the model by words names and the markers lack: ahead of the ankle, along the line from
/// its back to its front, and below. @return the joints that follow from them
std::vector<int> add_inferred_toes(const MarkerModel& model, NamedMotion& markers);

}  // namespace abrazo
