#pragma once

#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/opening/joint_maps.hpp"

namespace abrazo {

/// The result of reading a motion file with some options, for a person to judge before it is opened.
struct ImportView {
  MotionReading reading;
  std::vector<std::string> performers;  ///< those that can be read
  std::size_t performer = 0;            ///< the one that would play the user
  ImportedClip imported;                ///< of that performer; without poses if it cannot be read
  std::optional<Error> trouble;         ///< why it cannot be read
  UnmappedMotion unmapped;              ///< the points, if only their assignment to joints is missing
  std::string layout;                   ///< layout_of; empty: the points could not be read
  double moves_m = 0;                   ///< largest distance on the ground between two places of the root

  bool is_readable() const { return !imported.clip.poses.empty(); }
  /// What a person should confirm: performer and animation if nobody chose one of several, and what the
  /// warnings ask. Empty: nothing.
  std::vector<std::string> questions() const;
  /// The height of the floor with which the feet would stand on it [m], where they are more than 3 cm off it
  /// in the file and nothing was said or moved; else none.
  std::optional<double> floor_to_enter() const;
};

/// Reads a file with changing options. One thread at a time.
class ImportPreview {
 public:
  ImportView look(const MotionReading& reading, const Progress& progress = {});

 private:
  MotionPoints points_;
};

}  // namespace abrazo
