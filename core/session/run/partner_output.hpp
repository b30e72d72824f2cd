#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/command.hpp"
#include "core/stream/send/pose_sink.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// The body of a character's poses in a result: the chosen one for its role. While it changes, the goal.
/// @param user  the user's body, once it is known
Body body_of_character(const MotionLibrary& library, Character character, const Settings& settings,
                       const std::optional<Body>& user);

/// Sends both characters: solved poses go to every sink immediately; while nothing is solved, the last poses
/// are repeated, `held_rate_hz` times a second. Each sink gets the body before the first pose,
/// and again when a choice, role or library change it.
class PartnerOutput {
 public:
  static constexpr double held_rate_hz = 10;

  void attach(Character character, std::shared_ptr<PoseSink> sink);
  void detach(const std::shared_ptr<PoseSink>& sink);
  bool empty() const { return sinks_.empty(); }

  /// @return whether anything was sent
  /// @param user_body  the user's, once it is known
  bool send(const FrameResult& result, const std::shared_ptr<const MotionLibrary>& library,
            const Settings& settings, const std::optional<Body>& user_body, double time_s);
  /// Repeats the last poses if they are due. @param is_tracked the user is there, but held still
  /// @return whether anything was sent
  bool hold(double time_s, bool is_tracked = false);
  /// Time of the next due `hold`.
  double next_hold_s() const {
    if (!has_poses_ || sinks_.empty()) return std::numeric_limits<double>::infinity();
    return sent_s_ + 1 / held_rate_hz;
  }

 private:
  void tell_bodies(const MotionLibrary& library, const Settings& settings,
                   const std::optional<Body>& user_body);
  void send_to_all(double time_s, bool tracked);

  struct Attached {
    Character character;
    std::shared_ptr<PoseSink> sink;
    std::optional<Body> body = std::nullopt;  ///< that it was given
  };
  std::vector<Attached> sinks_;
  Pose user_ = Pose::Zero(), partner_ = Pose::Zero();
  bool has_poses_ = false;
  double sent_s_ = 0;
};

}  // namespace abrazo
