#pragma once

#include <optional>

#include "core/session/frames/frame_snapshot.hpp"
#include "core/session/frames/playback.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// Two runs, A and B, over the same inputs of the session.
struct ComparisonTask {
  std::optional<Settings> a, b;  ///< solved again with these; none: as it was recorded
  double from_s = 0;             ///< both start from what the solver knew then
  double to_s = 0;
  bool goes_on = false;  ///< along with the live solver, without an end

  bool operator==(const ComparisonTask&) const = default;
};

/// Which frames are solved again when the cursor is parked.
enum class WhatIfSpan { Frame, TwoSeconds, TenSeconds, InToOut };

/// All that decides about what is compared; plain data.
struct CompareSituation {
  std::optional<Settings> frozen;  ///< A
  Settings present;                ///< of the settings panel: B
  bool is_aside = false;           ///< the live solver keeps A
  Playback playback;
  FrameSnapshotPtr shown;  ///< at the cursor
  WhatIfSpan span = WhatIfSpan::TwoSeconds;
};

/// What is to be solved again around a cursor that is parked; nothing where nothing would differ, or no range
/// is marked. A covered cursor keeps the task there is.
std::optional<ComparisonTask> what_if_task(const CompareSituation& now, const ComparisonTask* current);

/// What runs beside the live solver: the run that it does not solve itself.
/// @param since_s  when A and B parted
std::optional<ComparisonTask> shadow_task(const CompareSituation& now, double since_s);

/// Is this instant among the frames of a task with an end?
bool covers(const ComparisonTask& task, double time_s);

}  // namespace abrazo
