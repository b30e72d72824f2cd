#pragma once

#include <optional>
#include <string>

namespace abrazo::app {

// What a project remembers of the view, as text; what comes back is from a file, perhaps a stranger's.
// Layout, plots, lanes and scene have theirs where they are.

/// Whence the camera looks.
struct CameraTurn {
  double azimuth_rad = 0;
  double elevation_rad = 0;  ///< up to a right angle, above or below
};
std::string text_of(const CameraTurn& turn);
/// Nothing where it is none.
std::optional<CameraTurn> camera_turn_of(const std::string& text);

}  // namespace abrazo::app
