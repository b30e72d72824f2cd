#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/motion/joints/marker_model.hpp"

namespace abrazo {

/// The place and side with this name (name_of_place); none for an unknown name.
std::optional<std::pair<MarkerPlace, std::size_t>> marker_spot(std::string_view name);

/// The names of all places, for pairs the left one, separated by commas; for errors.
std::string all_marker_places();

}  // namespace abrazo
