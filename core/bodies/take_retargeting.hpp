#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/bodies/chosen_body.hpp"
#include "core/bodies/pair_retargeting.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/motion/body/body_choice.hpp"

namespace abrazo {

/// Which recorded takes get which bodies, and where the result goes.
struct RetargetWish {
  std::vector<std::string> takes;  ///< each once
  long long from = 0;              ///< first frame, 0-based, of every take
  std::optional<long long> to;     ///< frame behind the last; none = to the end
  BodyChoice active, passive;
  /// Weight of the recorded distances of joints that are near one another, times the usual one: higher keeps
  /// contacts, lower the shape of each body.
  double contacts = 1;
  /// Weight of the smoothed pair, times the usual one.
  double smoothness = 1;
  static constexpr double greatest_factor = 4;  ///< of both; the least is 0
  std::string output;  ///< .bvh, .glb, .csv or .npz; of several takes OUT_TAKE for each
  std::string trace;   ///< JSON lines, likewise for each take; empty = none
  std::string
      character;  ///< GLB or VRM that performs the motion, in OUT_active and OUT_passive; empty = none

  /// The files with the motion of a take: one, or two with a character.
  std::vector<std::string> motion_files(const std::string& take) const;
  /// Its trace; empty without one.
  std::string trace_file(const std::string& take) const;
};

/// Checks before long work that the wish can be fulfilled: takes and bodies are usable for a recorded pair,
/// the file type exists, and every file can be written without replacing an input or another result.
/// @param source  file of the library or manifest; empty if there is none
Status check_retargeting(const RetargetWish& wish, const std::string& source);

/// What was made of one take.
struct RetargetedTake {
  std::string name;
  std::size_t frames = 0;
  std::string active_body, passive_body;  ///< as chosen: "library", "scale:0.85", "walk.bvh"
  double active_height_m = 0, passive_height_m = 0;
  std::vector<std::string> motion_files;
  std::size_t frames_with_holds = 0;
  double hold_change_mean_m = 0, hold_change_max_m = 0;  ///< 0 without holds
  double excess_max_m = 0;                               ///< deepest overlap beyond the recording's
  double bone_error_max = 0;                             ///< relative
  std::size_t nearest_only = 0;                          ///< frames whose pose these bodies cannot do
  std::string first_shortfall;                           ///< why the first of them
  double first_shortfall_s = 0;

  /// "60 frames, active scale:0.85 (1.45 m), passive library (1.63 m)"
  std::string bodies_text() const;
  /// Holds, overlap and bones; and how many frames are only the nearest pose, if any are.
  std::string quality_text() const;
};

/// A take on other bodies, computed.
struct TakeOnBodies {
  RetargetedPair pair;
  ChosenBody active, passive;

  RetargetedTake described() const;  ///< without files
};

/// The frames and bodies of the wish of one take, as `retarget_takes` writes them; writes nothing. Bodies are
/// measured over the whole take, so a part of it gets the same ones.
/// @return an Error also if `progress` cancelled
Result<TakeOnBodies> retarget_take(const PairedTake& take, const RetargetWish& wish,
                                   const Progress& progress = {});

/// Transfers takes to other bodies and writes the files of the wish: all of them, or none. The window and
/// the command line both retarget through it, so their files are the same to the bit.
/// @param takes   those of the wish, in its order
/// @param source  name of their library or manifest, for the trace and messages
/// @return an Error if nothing was written, also if `progress` cancelled
Result<std::vector<RetargetedTake>> retarget_takes(const std::vector<PairedTake>& takes,
                                                   const RetargetWish& wish, const std::string& source,
                                                   const Progress& progress = {});

}  // namespace abrazo
