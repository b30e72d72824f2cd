#pragma once

#include <optional>

#include "core/session/frames/decisions.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/session/frames/playback.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Two runs, A and B, over the same inputs of the session.
struct ComparisonTask {
  std::optional<Settings> a, b;  ///< solved again with these; none: as recorded
  double from_s = 0;             ///< both start from the solver's state at this time
  double to_s = 0;
  bool follows_live = false;                  ///< follows the live solver, without an end
  std::optional<Decisions> b_decisions = {};  ///< B is solved with these; none: those of the recording

  bool operator==(const ComparisonTask&) const = default;
};

/// Which frames are solved again when the cursor is parked.
enum class WhatIfSpan { Frame, TwoSeconds, TenSeconds, InToOut };

/// Everything that determines what is compared; plain data.
struct CompareSituation {
  std::optional<Settings> frozen;  ///< A
  Settings present;                ///< of the settings panel (B)
  bool is_aside = false;           ///< the live solver keeps A
  Playback playback;
  FrameSnapshotPtr shown;  ///< at the cursor
  WhatIfSpan span = WhatIfSpan::TwoSeconds;
  std::optional<int> tried_pin = {};  ///< pair tried on the parked frame; without effect on the live solver
};

/// What to solve again around a parked cursor; none if nothing would differ, or no range is marked. A cursor
/// inside the present task keeps that task.
std::optional<ComparisonTask> what_if_task(const CompareSituation& now, const ComparisonTask* current);

/// The run beside the live solver: the one of the two that the live solver does not solve.
/// @param since_s when A and B began to differ
std::optional<ComparisonTask> shadow_task(const CompareSituation& now, double since_s);

/// Whether a time lies within a task that has an end.
bool covers(const ComparisonTask& task, double time_s);

}  // namespace abrazo
