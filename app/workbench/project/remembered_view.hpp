#pragma once

#include <optional>
#include <string>

namespace abrazo::app {

// View state of a project as text; input may be an untrusted file. Layout, plots, lanes and scene have their
// own functions.

/// Direction of the camera.
struct CameraTurn {
  double azimuth_rad = 0;
  double elevation_rad = 0;  ///< up to a right angle, above or below
};
std::string text_of(const CameraTurn& turn);
/// None if invalid.
std::optional<CameraTurn> camera_turn_of(const std::string& text);

}  // namespace abrazo::app
