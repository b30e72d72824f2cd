#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/positions.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/metrics/movement.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

/// Position of a step's source in the recordings.
struct SourceMoment {
  int take = -1;
  bool swapped = false;
  double time_s = 0;  ///< in the take
};

/// One step, with the values needed to rate the partner's motion.
struct PartnerStep {
  Pose partner = Pose::Zero();
  double time_s = 0;
  SourceMoment source;
  bool source_changed = false;
  std::array<bool, 2> locked{};  ///< feet: left, right
};

/// From a step that did not fail. @param partner_is_active the user is the passive one
PartnerStep partner_step(const FrameResult& frame, double time_s, const MotionLibrary& library,
                         bool partner_is_active);

/// Whether the second moment is a continuation of the first: the same take and roles, not before it, and not
/// more than 1/3 s of the take after it.
bool continues(const SourceMoment& before, const SourceMoment& after);

/// Quality of the partner's motion, and its relation to the recordings it is made from.
class MotionQuality {
 public:
  explicit MotionQuality(const ToeRest& rest) : rest_(rest), movement_(rest) {}

  void add(const PartnerStep& step);
  /// Call after a failed step and before another take.
  void interrupt();

  /// NaN if there was nothing to measure.
  struct Figures {
    MovementMetric::Figures movement;
    double changes_per_s = 0;  ///< changes of source: marked as such, or not a continuation
    /// Pace: time in the take per elapsed time, over steps that continue the source.
    double pace_p05 = 0, pace_p50 = 0, pace_p95 = 0;
    double standing_share = 0;     ///< pace below 0.25
    double source_pace_share = 0;  ///< pace from 0.75 to 1.25
    /// At a change: mean over the joints of the distance from where the last velocities lead.
    double step_at_change_max_m = 0, step_at_change_mean_m = 0;
    double hover_mean_m = 0;  ///< of locked toe bases above their rest
    double hover_p90_m = 0;
  };
  Figures figures() const;

  const MovementMetric& movement() const { return movement_; }
  const std::vector<double>& paces() const { return paces_; }
  const std::vector<double>& hovers_m() const { return hovers_m_; }

 private:
  void add_source(const PartnerStep& step, const std::optional<MovementStep>& moved);

  ToeRest rest_;
  MovementMetric movement_;
  std::optional<PartnerStep> last_;
  double observed_s_ = 0;
  int changes_ = 0;
  std::vector<double> paces_, hovers_m_, steps_at_change_m_;
};

}  // namespace abrazo
