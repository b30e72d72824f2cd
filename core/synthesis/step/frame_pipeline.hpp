#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/retarget/body_retargeter.hpp"
#include "core/selection/intent_selector.hpp"
#include "core/selection/pair_selector.hpp"
#include "core/synthesis/bodies/shown_bodies.hpp"
#include "core/synthesis/edit/pair_editor.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"
#include "core/synthesis/step/frame_memory.hpp"

namespace abrazo {

/// Processes one frame for a user who plays the first body of the library's pairs: retarget, select, edit,
/// measure, show on the chosen bodies. Keeps the state for the next frame: the two previous results, foot
/// locks, the current source.
class FramePipeline {
 public:
  /// @param pairs the selectable pairs
  /// @param index over those pairs of this library; built if null
  FramePipeline(std::shared_ptr<const MotionLibrary> library, const Settings& settings,
                std::vector<int> pairs, std::shared_ptr<const PoseIndex> index = nullptr);

  /// @param user finite; @param elapsed_s since the last solved frame; 0 at the start
  void solve(const Pose& user, double elapsed_s);
  /// Fails a frame without solving it: the last good poses are held. The message is `why` and `where`.
  void refuse(std::string_view why, std::string_view where = {});
  /// Clears the state: the next frame is a first one.
  void forget();
  /// Tracking was lost: the next frame does not follow the last. With the playback `continuous` the partner
  /// still continues from where it is.
  void lose_track();

  void set_settings(const Settings& settings) { settings_ = settings; }
  /// Sets the user's body; none: it is measured on the next plausible poses.
  void set_user_body(const std::optional<Body>& body);
  /// Sets the model of the selection `intent`; without it Eq. 7 selects. RoleViews prepares a shared one.
  void set_intent(std::shared_ptr<const IntentModel> model);
  bool has_intent() const { return intent_.has_value(); }
  void pin_pair(std::optional<int> pair) { pinned_ = pair; }
  void set_vetoes(const Vetoes& vetoes) { selector_.set_vetoes(vetoes); }
  void set_intended(const std::optional<IntendedPairs>& meant) { selector_.set_intended(meant); }

  const FrameResult& result() const { return out_; }

  const FrameMemory& memory() const { return memory_; }
  /// Restores the state: the next frame follows those before `memory`.
  void restore(const FrameMemory& memory);
  /// Takes over the state of a pipeline over other pairs, or over the same pairs with roles exchanged: both
  /// bodies continue from where they are, the recorded source does not.
  void take_over(const FrameMemory& memory);

 private:
  void begin_frame();
  void fail(std::string_view why, std::string_view where = {});
  bool measure(const Pose& user, double dt_s);
  void retarget(const Pose& user);
  bool select(double dt_s);
  SelectionQuery query_of(double dt_s) const;
  bool selects_by_intent() const { return settings_.selection == SelectionMethod::Intent && intent_; }
  void select_pinned(const SelectionQuery& query);
  bool plays() const { return settings_.playback == SourcePlayback::Continuous; }
  void follow_source(double dt_s);
  bool continues_source(int pair, double dt_s) const;
  bool move(double dt_s);
  std::optional<ShownPartner> shown_partner(double dt_s) const;
  void hold_feet(double dt_s);
  PairPose predicted(double dt_s) const;
  SourcePlayhead expected_playhead(double dt_s) const;
  Pose partner_speed() const;
  FootLocks::Situations feet(double dt_s) const;
  bool is_recorded_foot_slow(int vertex) const;
  RigidDistances wanted_lengths() const;
  RigidDistances lengths_as_moved() const;
  EditTask edit_task(double dt_s) const;
  EditTask pair_task() const;
  EditTask parting_task(const PairPose& moved) const;
  void add_motion(EditTask& task) const;
  void report(const PairEditor::Outcome& outcome);
  void report_feet(int locked_bodies);
  void show(const Pose& user, double dt_s);
  void show_on_bodies(const Pose& user, double dt_s);
  void remember(double dt_s);

  std::shared_ptr<const MotionLibrary> library_;
  Settings settings_;
  PairSelector selector_;
  std::optional<IntentSelector> intent_;
  PairEditor editor_;
  ShownBodies shown_;
  std::optional<BodyRetargeter> retargeter_;
  bool retargeter_scales_path_ = true;
  std::optional<int> pinned_;

  FrameMemory memory_;
  FrameMemory next_;             ///< memory_ with this frame; replaces it if the frame is solved
  Pose partner_ = Pose::Zero();  ///< moved, before the edit

  FrameResult out_;
};

/// Exchanges the two bodies of a frame: turns a frame solved for a passive user into the order active,
/// passive.
void exchange_roles(const FrameResult& solved, FrameResult& exchanged);

}  // namespace abrazo
