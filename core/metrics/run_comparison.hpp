#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Figures that compare two runs over the same inputs. Less is better for all.
enum class RunFigure {
  BehindSelected,
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

/// Name and format of a figure.
struct RunFigureInfo {
  std::string_view name;
  std::string_view unit;
  double scale = 1;  ///< shown value = scale * value in SI units
  int decimals = 1;
  std::string_view help;  ///< definition, and the frames it covers
};
const RunFigureInfo& info_of(RunFigure figure);

/// One per RunFigure, in SI units; NaN if there was nothing to measure (no hold, no foot on the floor).
using RunFigures = std::array<double, run_figure_count>;

/// One step of a run.
struct RunStep {
  const FrameResult* result = nullptr;
  double time_s = 0;
  bool starts = false;  ///< a new start: no velocity from the previous step to this one
};

/// RunSummary's figures and those of the partner's feet and balance. The rate follows from the times of the
/// steps.
RunFigures measure_run(std::span<const RunStep> steps, const MotionLibrary& library, UserRole user_role);

/// Figures of two runs plotted over time, one value per step.
enum class StepFigure {
  PartnerDistance,
  BehindSelected,
  HoldChange,
  DeformationEnergy,
  Penetration,
  StepTime
};
inline constexpr std::size_t step_figure_count = 6;
const RunFigureInfo& info_of(StepFigure figure);

/// Figures of two runs at one step [SI units]. NaN if there is nothing to measure.
struct ComparedStep {
  double time_s = 0;
  std::array<double, step_figure_count> a{}, b{};  ///< for PartnerDistance: a is 0, b is the distance of B
                                                   ///< from A
};
/// @throws std::invalid_argument if the runs do not have the same steps
std::vector<ComparedStep> compare_steps(std::span<const RunStep> a, UserRole a_role,
                                        std::span<const RunStep> b, UserRole b_role);

}  // namespace abrazo
