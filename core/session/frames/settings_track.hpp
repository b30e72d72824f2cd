#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// A change of settings between two frames of a session.
struct SettingsChange {
  double time_s = 0;        ///< session time of the first frame solved under `after`
  double until_s = 0;       ///< the same; for merged changes that of the last
  std::uint64_t frame = 0;  ///< index of the first frame solved under `after`
  Settings before, after;
  std::string text;  ///< "α 0.5 → 0.3"
  /// Why the method changed although nobody asked for it: "the library was learned". Else empty.
  std::string reason;
};

/// Keys of the settings that differ, in display order.
std::vector<std::string_view> changed_settings(const Settings& before, const Settings& after);

/// "α 0.5 → 0.3, planted below 0 → 0.3 m/s"; several that end at a preset are "preset paper". Empty when
/// nothing differs.
std::string change_text(const Settings& before, const Settings& after);

/// The settings of a session over time, collected from its frames. With the inputs it is sufficient to solve
/// the session again.
class SettingsTrack {
 public:
  /// Appends the next frame; a frame that is not newer is ignored.
  void append(const FrameSnapshot& frame);
  void append(std::span<const FrameSnapshotPtr> frames);
  /// Drops changes before the oldest available frame, whose settings stay known.
  void evict_before(double time_s);
  void clear();

  bool empty() const { return !started_; }
  /// Ascending in frame and time.
  const std::deque<SettingsChange>& changes() const { return changes_; }
  /// Settings of the frame shown at a time; null if there is no frame.
  const Settings* at(double time_s) const;
  /// The same by the frame's index.
  const Settings* at_frame(std::uint64_t frame) const;
  /// Changes for a lane of the timeline: successive changes of the same settings within `gap_s`, as from a
  /// dragged slider, are merged from the first value to the last. A merged change that ends where it began is
  /// left out.
  std::vector<SettingsChange> merged(double gap_s) const;

 private:
  bool started_ = false;
  bool learning_ = false;  ///< in the newest frame: Eq. 7 selects until the library is learned
  std::uint64_t last_frame_ = 0;
  Settings first_;  ///< before the first of `changes_`
  Settings last_;   ///< of the newest frame
  std::deque<SettingsChange> changes_;
};

}  // namespace abrazo
