#include "core/stream/vmc/vmc_watch.hpp"

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr double check_every_s = 1.0;

/// T going back by less is a packet overtaken by another [s].
constexpr double reset_s = 0.5;

/// Frames with one T, over how long, before its clock counts as standing.
constexpr std::uint64_t frozen_frames = 20;
constexpr double frozen_s = 0.5;

/// A bone jumps to and fro: turned by more than this from the value before, and back by most of it [rad].
constexpr double jump_rad = 0.1;
constexpr double back_share = 0.3;
constexpr int fewest_jumps = 30;

}  // namespace

void VmcWatch::heard(double arrived_s) {
  last_message_s_ = arrived_s;
  if (first_message_s_ < 0) first_message_s_ = arrived_s;
}

void VmcWatch::ok(const VmcOk& ok, double arrived_s) {
  heard(arrived_s);
  ok_ = ok;
}

void VmcWatch::time(double value, double arrived_s, Issues& issues) {
  heard(arrived_s);
  if (time_ == value) return;
  // Two senders' clocks alternate; this is reported as such.
  if (time_ && value < *time_ - reset_s && !two_senders_)
    issues.push_back({"clock-reset", sender_ + ": its T went from " + exact_text(*time_) + " s back to " +
                                         exact_text(value) + " s; the sender was restarted"});
  time_ = value;
  time_changed_s_ = arrived_s;
  frames_at_this_time_ = 0;
}

void VmcWatch::bone(int bone, const VmcTransform& local, double arrived_s) {
  heard(arrived_s);
  last_bone_s_ = arrived_s;
  if (!local.rotation) return;
  Trail& trail = trails_[static_cast<std::size_t>(bone)];
  if (trail.count >= 2) {
    const double jump = local.rotation->angularDistance(trail.last);
    if (jump > jump_rad) {
      ++moved_;
      if (local.rotation->angularDistance(trail.before) < back_share * jump) ++alternated_;
    }
  }
  trail.before = trail.last;
  trail.last = *local.rotation;
  ++trail.count;
}

void VmcWatch::pass_time(double now_s, Issues& issues) {
  if (checked_s_ < 0) checked_s_ = now_s;
  if (now_s - checked_s_ < check_every_s) return;
  checked_s_ = now_s;
  const bool is_alive = now_s - last_message_s_ < check_every_s;
  if (is_alive) check(now_s, issues);
  moved_ = alternated_ = 0;
}

void VmcWatch::check(double now_s, Issues& issues) {
  two_senders_ = moved_ >= fewest_jumps && alternated_ > 0.7 * moved_;
  if (two_senders_)
    issues.push_back(
        {"two-senders", sender_ + ": bones jump to and fro between two poses: two characters share this "
                                  "address. The protocol cannot tell them apart; give each its own port"});
  if (frames_at_this_time_ >= frozen_frames && now_s - time_changed_s_ > frozen_s && time_)
    issues.push_back({"frozen-sender", sender_ + ": T stands at " + exact_text(*time_) + " s through " +
                                           std::to_string(frames_at_this_time_) +
                                           " frames; it does not count, or the sender hangs"});
  if (now_s - last_bone_s_ >= check_every_s && now_s - first_message_s_ >= check_every_s)
    issues.push_back({"no-bones", sender_ + ": sends VMC, but no bones" +
                                      (ok_ && ok_->loaded == 0 ? "; it has no avatar loaded: load one"
                                                               : "; switch the sending of bones on")});
  if (!ok_) return;
  if (ok_->loaded == 0)
    issues.push_back({"not-loaded", sender_ + ": says that no avatar is loaded (OK 0)"});
  else if (ok_->calibration != 3)
    issues.push_back({"not-calibrated", sender_ + ": says that it is " +
                                            (ok_->calibration == 2   ? "being calibrated"
                                             : ok_->calibration == 1 ? "waiting for its calibration"
                                                                     : "not calibrated") +
                                            "; poses may be wrong until it is"});
  if (ok_->tracking == 0)
    issues.push_back({"not-tracking", sender_ + ": says that its tracking is bad (OK, fourth number 0)"});
}

}  // namespace abrazo
