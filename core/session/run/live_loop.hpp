#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/frame_listener.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/session/frames/latest_slot.hpp"
#include "core/session/run/command_queue.hpp"
#include "core/session/run/partner_output.hpp"
#include "core/session/run/solver_control.hpp"
#include "core/stream/receive/pose_source.hpp"

namespace abrazo {

/// One turn of the live loop without a thread: commands, newest pose, step, sinks, snapshot. Owned by the
/// solver thread; tests drive it with an injected clock. Queue, history and slot must outlive it.
class LiveLoop {
 public:
  /// @param clock session clock, read after solving and after sending; without it both times are that of
  /// `turn`
  LiveLoop(std::shared_ptr<PartnerSynthesizer> synthesizer, std::shared_ptr<PoseSource> source,
           CommandQueue& commands, FrameHistory& history, LatestSlot<FrameSnapshot>& latest,
           std::function<double()> clock = {});
  ~LiveLoop();

  /// @param now_s  session clock
  /// @return session time of the next work, unless `wake_up` is notified earlier
  /// @throws std::runtime_error if a command failed; thrown at the end, after the other commands and a due
  /// pose were handled
  double turn(double now_s);

  /// Publishes a failed snapshot with this text; the partner holds its last pose.
  void publish_failure(const std::string& why, double now_s);

  /// Whether the clip that plays the user is paused. No frames are made then, except for `settling_s` after
  /// a command that changes the answer; another library only acts on the next frame. Thread-safe.
  bool is_held() const { return is_held_; }
  static constexpr double settling_s = 0.5;

  /// How far the clip is solved that is solved over its length.
  struct ClipProgress {
    std::uint64_t solved = 0, frames = 0;
    std::uint64_t run = 0;  ///< counts how often it was begun
    double last_s = 0;      ///< time of its last frame
    bool is_whole() const { return solved >= frames; }
    bool operator==(const ClipProgress&) const = default;
  };
  /// None: the source is another. Thread-safe.
  std::optional<ClipProgress> clip_progress() const;
  /// The frame that is seen: those around it are the first that a change solves again. Thread-safe.
  void look_at(double clip_time_s) { seen_s_ = clip_time_s; }

  /// Notified when a command or a pose came in.
  const std::shared_ptr<WakeUp>& wake_up() const { return commands_.wake_up(); }

 private:
  template <typename Action>
  void attempt(const Action& action);
  void apply(const Command& command, double now_s);
  void replace_source(const ReplaceSource& replacement, double now_s);
  void listen_to_source();
  void take_measures();
  void solve(const SourcePose& input, double now_s);
  double time_since_previous(const SourcePose& input);
  double frame_time(const SourcePose& input, double now_s) const;
  void wait_for_pose(double now_s);
  bool rests(double now_s);
  double loss_after_s() const;
  std::shared_ptr<const SynthesizerState> state_if_due();
  void continue_counting();
  void begin_clip_again(bool with_state);
  void begin_clip();
  void note_progress(const std::optional<ClipProgress>& progress);
  void publish(std::shared_ptr<FrameSnapshot> snapshot);

  SolverControl control_;
  std::shared_ptr<PoseSource> source_;
  std::shared_ptr<const std::string> input_;  ///< the source's name in a recording
  CommandQueue& commands_;
  FrameHistory& history_;
  LatestSlot<FrameSnapshot>& latest_;
  std::function<double()> clock_;
  PartnerOutput output_;
  std::vector<std::shared_ptr<FrameListener>> listeners_;

  std::optional<Body> source_body_;  ///< last one given by the source
  std::uint64_t next_index_ = 0;
  std::uint64_t state_due_ = 0;  ///< index of the next frame to keep the synthesizer's state
  double previous_time_s_ = -1;  ///< of the last pose, on the source's clock
  double last_frame_s_ = -1;     ///< of the last frame, session clock
  double waiting_since_s_ = -1;  ///< waiting for a pose since; -1 before the first turn
  bool is_lost_ = false;         ///< no pose for too long
  bool has_solved_ = false;
  bool is_paused_ = false;  ///< wanted last, also while the source is a device, which cannot be paused
  std::atomic<bool> is_held_ = false;
  double settles_until_s_ = -1;  ///< a held pose is solved until then
  double rests_since_s_ = -1;    ///< a held pose is not solved since then; -1 = it is
  double smoothed_interval_s_ = 0;
  std::uint64_t dropped_before_ = 0;  ///< by previous sources
  std::uint64_t dropped_at_start_ = 0, dropped_now_ = 0;
  bool is_first_of_source_ = true;
  std::atomic<double> seen_s_ = 0;
  std::optional<std::uint64_t> preview_end_;  ///< index after the frames solved first, because they are seen
  mutable std::mutex progress_mutex_;
  std::optional<ClipProgress> progress_;
  std::string trouble_;  ///< what failed in this turn; thrown at its end
};

}  // namespace abrazo
