#pragma once

#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/opening/joint_maps.hpp"

namespace abrazo {

/// What a motion file becomes when it is read in some way, for a person to judge before it is opened.
struct ImportView {
  MotionReading reading;
  std::vector<std::string> performers;  ///< those that can be read
  std::size_t performer = 0;            ///< the one that would play the user
  ImportedClip imported;                ///< of that performer; without poses where it cannot be read
  std::optional<Error> trouble;         ///< why it cannot be read
  UnmappedMotion unmapped;              ///< the points, where which point is which joint is what is missing
  std::string layout;                   ///< layout_of; empty: not even its points could be read
  double moves_m = 0;                   ///< largest distance on the ground between two places of the root

  bool is_readable() const { return !imported.clip.poses.empty(); }
};

/// Reads a file in one way after another. One thread at a time.
class ImportPreview {
 public:
  ImportView look(const MotionReading& reading, const Progress& progress = {});

 private:
  MotionPoints points_;
};

}  // namespace abrazo
