#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/command.hpp"
#include "core/stream/send/pose_sink.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// The bone lengths of a character's poses in a result: those of the library's usual performer in its role.
const Body& body_of_character(const MotionLibrary& library, Character character, UserRole user_role);

/// Sends both characters: solved poses go to every sink immediately; while nothing is solved, the last poses
/// are repeated, `held_rate_hz` times a second. Each sink gets the body before the first pose,
/// and again when role or library change it.
class PartnerOutput {
 public:
  static constexpr double held_rate_hz = 10;

  void attach(Character character, std::shared_ptr<PoseSink> sink);
  void detach(const std::shared_ptr<PoseSink>& sink);
  bool empty() const { return sinks_.empty(); }

  /// @return whether anything was sent
  bool send(const FrameResult& result, const std::shared_ptr<const MotionLibrary>& library,
            UserRole user_role, double time_s);
  /// Repeats the last poses if they are due. @param is_tracked the user is there, but held still
  /// @return whether anything was sent
  bool hold(double time_s, bool is_tracked = false);
  /// Time of the next due `hold`.
  double next_hold_s() const {
    if (!has_poses_ || sinks_.empty()) return std::numeric_limits<double>::infinity();
    return sent_s_ + 1 / held_rate_hz;
  }

 private:
  void tell_bodies(const std::shared_ptr<const MotionLibrary>& library, UserRole user_role);
  void send_to_all(double time_s, bool tracked);

  struct Attached {
    Character character;
    std::shared_ptr<PoseSink> sink;
    std::shared_ptr<const MotionLibrary> library = nullptr;  ///< library of the body it was given
    UserRole user_role = UserRole::Active;
  };
  std::vector<Attached> sinks_;
  Pose user_ = Pose::Zero(), partner_ = Pose::Zero();
  bool has_poses_ = false;
  double sent_s_ = 0;
};

}  // namespace abrazo
