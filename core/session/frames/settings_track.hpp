#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// From one frame of a session to the next, other settings.
struct SettingsChange {
  double time_s = 0;        ///< session time of the first frame solved under `after`
  double until_s = 0;       ///< the same; of merged changes that of the last
  std::uint64_t frame = 0;  ///< index of the first frame solved under `after`
  Settings before, after;
  std::string text;  ///< "α 0.5 → 0.3"
};

/// Keys of the settings that differ, in the order in which settings are shown.
std::vector<std::string_view> changed_settings(const Settings& before, const Settings& after);

/// "α 0.5 → 0.3, planted below 0 → 0.3 m/s"; several that end at a preset are "preset paper". Empty when
/// nothing differs.
std::string change_text(const Settings& before, const Settings& after);

/// The settings of a session over time, gathered from its frames. With the inputs it is all that is needed to
/// solve the session again.
class SettingsTrack {
 public:
  /// The frame after those appended before; one that is older or the same is ignored.
  void append(const FrameSnapshot& frame);
  void append(std::span<const FrameSnapshotPtr> frames);
  /// Gives up what lies before the oldest frame there is. The settings that it was solved under stay known.
  void evict_before(double time_s);
  void clear();

  bool empty() const { return !started_; }
  /// Ascending in frame and time.
  const std::deque<SettingsChange>& changes() const { return changes_; }
  /// Under which the frame shown at a time was solved; null while there is no frame.
  const Settings* at(double time_s) const;
  /// The same by the frame's index.
  const Settings* at_frame(std::uint64_t frame) const;
  /// For a lane: changes of the same settings that follow one another within `gap_s`, as a drag of a slider
  /// gives them, are one, from the first value to the last; one that ends where it began is left out.
  std::vector<SettingsChange> merged(double gap_s) const;

 private:
  bool started_ = false;
  std::uint64_t last_frame_ = 0;
  Settings first_;  ///< before the first of `changes_`
  Settings last_;   ///< of the newest frame
  std::deque<SettingsChange> changes_;
};

}  // namespace abrazo
