#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/synthesis/frame_result.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// What two runs over the same inputs are compared by. Less is better in all of them.
enum class RunFigure {
  Lag,
  HoldChange,
  SourceChanges,
  Jumps,
  SpeedTail,
  Acceleration,
  DeformationEnergy,
  MorphDistance,
  Penetration,
  FootSlide,
  ZmpError,
  BoneLength,
  Unmet,
  StepTime,
  StepTimeTail
};
inline constexpr std::size_t run_figure_count = 15;

/// How a figure is named and written.
struct RunFigureInfo {
  std::string_view name;
  std::string_view unit;
  double scale = 1;  ///< shown = scale times the value in SI units
  int decimals = 1;
  std::string_view help;  ///< what it is, over which frames
};
const RunFigureInfo& info_of(RunFigure figure);

/// One per RunFigure, in SI units; not a number where there was nothing to measure (no hold, no foot down).
using RunFigures = std::array<double, run_figure_count>;

/// One step of a run.
struct RunStep {
  const FrameResult* result = nullptr;
  double time_s = 0;
  bool starts = false;  ///< anew: there is no speed from the step before to this one
};

/// RunSummary's figures and those of the partner's feet and balance. The rate is that of the steps' own
/// times.
RunFigures measure_run(std::span<const RunStep> steps, const MotionLibrary& library, UserRole user_role);

/// What of two runs is drawn over time, one value a step.
enum class StepFigure { PartnerDistance, Lag, HoldChange, DeformationEnergy, Penetration, StepTime };
inline constexpr std::size_t step_figure_count = 6;
const RunFigureInfo& info_of(StepFigure figure);

/// Two runs at one step: what each came to [SI]. Not a number where there is nothing to measure.
struct ComparedStep {
  double time_s = 0;
  std::array<double, step_figure_count> a{}, b{};  ///< of PartnerDistance: a is 0, b how far B is from A
};
/// @throws std::invalid_argument when the runs have not the same steps
std::vector<ComparedStep> compare_steps(std::span<const RunStep> a, UserRole a_role,
                                        std::span<const RunStep> b, UserRole b_role);

}  // namespace abrazo
