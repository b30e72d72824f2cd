#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/joints/joint_map.hpp"
#include "core/stream/protocol/stream_decoder.hpp"

namespace abrazo {

/// Correction of the sender's positions, applied first. Set by a person, never guessed.
struct StreamCorrection {
  double metres_per_unit = 1;
  bool z_up = false;     ///< (x, y, z) -> (x, z, -y)
  double floor_y_m = 0;  ///< height of the sender's floor after the above; subtracted from every y

  Vec3 apply(const Vec3& position) const;
  /// "unit 0.01 m, Z up, floor +0.120 m"; empty if there is no correction.
  std::string text() const;
};

struct FrameAssemblyOptions {
  std::optional<JointMap> joint_map;  ///< none = the built-in one that fits
  StreamCorrection correction;
  double longest_hold_s = 0.5;  ///< time for which an untracked joint is held
};

/// Converts named points of one performer to the 25 joints. An untracked joint keeps its position relative to
/// its parent for a while; without the root or with more than a third missing there is no pose. Output is
/// finite.
class FrameAssembly {
 public:
  static constexpr int most_missing = joint_count / 3;

  explicit FrameAssembly(FrameAssemblyOptions options) : options_(std::move(options)) {}

  struct Assembled {
    std::optional<Pose> pose;
    int held = 0;                      ///< joints kept from the previous frame
    std::optional<StreamIssue> issue;  ///< why there is no pose, or a problem with it
  };
  Assembled assemble(const PerformerFrame& frame);
  /// Drops held joints (for a new sender).
  void forget() { previous_.reset(); }

  const StreamCorrection& correction() const { return options_.correction; }
  void set_floor(double floor_y_m) { options_.correction.floor_y_m = floor_y_m; }

  const std::string& joint_map() const { return map_name_; }
  const std::vector<std::string>& estimated_joints() const { return estimated_; }

 private:
  void bind(const std::shared_ptr<const std::vector<std::string>>& points);
  Assembled fill_missing(Pose pose, const std::array<bool, joint_count>& missing, double time_s);

  FrameAssemblyOptions options_;
  std::shared_ptr<const std::vector<std::string>> points_;
  std::optional<JointBinding> binding_;
  std::string map_name_, why_not_bound_;
  std::vector<std::string> estimated_;
  std::optional<Pose> previous_;
  std::array<double, joint_count> tracked_s_{};  ///< session clock, when each joint was last tracked
};

}  // namespace abrazo
