#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/motion/joints/marker_model.hpp"

namespace abrazo {

/// The place and side that are called so by name_of_place; nothing for another name.
std::optional<std::pair<MarkerPlace, std::size_t>> marker_spot(std::string_view name);

/// The names of all places, of pairs the left one, separated by commas; for errors.
std::string all_marker_places();

}  // namespace abrazo
