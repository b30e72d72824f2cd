#pragma once

#include <optional>

#include "app/workbench/compare/comparison.hpp"
#include "core/session/frames/playback.hpp"
#include "widgets/compare/compare_panel.hpp"

namespace abrazo::app {

/// All that decides about what is compared; plain data.
struct CompareSituation {
  std::optional<Settings> frozen;  ///< A
  Settings present;                ///< of the settings panel: B
  bool is_aside = false;           ///< the live solver keeps A
  Playback playback;
  FrameSnapshotPtr shown;  ///< at the cursor
  widgets::WhatIfSpan span = widgets::WhatIfSpan::TwoSeconds;
};

/// What is to be solved again around a cursor that is parked; nothing where nothing would differ, or no range
/// is marked. A covered cursor keeps the task there is.
std::optional<ComparisonTask> what_if_task(const CompareSituation& now, const ComparisonTask* current);

/// What runs beside the live solver: the run that it does not solve itself.
/// @param since_s  when A and B parted
std::optional<ComparisonTask> shadow_task(const CompareSituation& now, double since_s);

/// Is this instant among the frames of a task with an end?
bool covers(const ComparisonTask& task, double time_s);

}  // namespace abrazo::app
