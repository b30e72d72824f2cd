#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>

#include "core/metrics/movement.hpp"
#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::widgets {

/// All series over time, in menu order.
enum class Series : std::uint8_t {
  DeformationEnergy,
  VelocityEnergy,
  ConstraintEnergy,
  FootLock,
  ExcessPenetration,
  Penetration,
  MorphRms,
  BoneLength,
  PoseCost,
  LeaderCost,
  FollowerCost,
  TotalCost,
  CostMargin,
  ExpectedPartner,
  LeaderMotion,
  UnlikelyMove,
  NotMeant,
  ChangeOfSource,
  IntentTotal,
  IntentMargin,
  RetargetTime,
  SelectTime,
  MeshTime,
  SolveTime,
  TotalTime,
  HoldChange,
  PartnerStep,
  BehindSelected,
  SourceChanges,
  PartnerSpeed,
  RecordedSpeed,
  FootSlide,
  PartnerAcceleration,
  RecordedAcceleration,
  // Series of the selection in the scene; see selection_series.hpp.
  JointResidual,
  JointFromUser,
  JointFromSelected,
  JointSpeed,
  EdgeLength,
  EdgeReference,
  EdgeResidual,
  EdgeWeight,
  CellRatio
};
inline constexpr std::size_t series_count = 43;

struct SeriesInfo {
  Series series;
  std::string_view key;    ///< in files: "energy.deformation"; never changes
  std::string_view group;  ///< "Energy"; groups series in menus
  std::string_view name;   ///< in menus and readouts
  std::string_view brief;  ///< in the header of a pane
  std::string_view unit;   ///< "m²"; empty for a pure number
  int decimals;
  std::string_view meaning;
};

const std::array<SeriesInfo, series_count>& all_series();
const SeriesInfo& info_of(Series series);
std::optional<Series> find_series(std::string_view key);

/// One value per series; NaN if a frame has none.
using SeriesValues = std::array<double, series_count>;

inline double& at(SeriesValues& values, Series series) {
  return values[static_cast<std::size_t>(series)];
}

/// Computes the series of frames in order. Keeps the required state of earlier frames. A failed step has
/// timings only, as in the metrics of a run. Omits series of a selection.
class SeriesReader {
 public:
  SeriesValues read(const FrameSnapshot& frame);

 private:
  void read_energies(const FrameSnapshot& frame, SeriesValues& values) const;
  void read_metrics(const FrameSnapshot& frame, SeriesValues& values);
  void read_movement(const FrameSnapshot& frame, SeriesValues& values);
  void remember(const FrameSnapshot& frame, bool failed);

  struct Previous {
    std::uint64_t index = 0;
    double time_s = 0;            ///< on the session's clock
    double solved_s = 0;          ///< on the solver's clock, of the last successful step; NaN = none
    std::optional<Pose> partner;  ///< none after a failed step
  };
  /// State of the partner, while role and library stay.
  struct Moving {
    std::shared_ptr<const MotionLibrary> library;
    UserRole user_role = UserRole::Active;
    MovementSteps steps;
  };
  /// The sum of the times that the solver was given. On the session's clock the frames of a backlog are much
  /// closer together than the poses in them.
  double solver_s_ = 0;
  std::optional<Previous> previous_;
  std::optional<Moving> moving_;  ///< none after a failed step
  std::deque<bool> changes_;      ///< of the source, latest last
};

/// Number of steps over which source changes are counted.
inline constexpr std::size_t source_window_steps = 100;

}  // namespace abrazo::widgets
