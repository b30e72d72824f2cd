#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/motion/body/body.hpp"
#include "core/selection/intended_pairs.hpp"
#include "core/selection/vetoes.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

class RoleViews;
struct SynthesizerState;

using Duration = std::chrono::duration<double>;

/// The whole method, one frame at a time: a user's pose in, both characters out (paper 3.3-3.4).
/// Owns the whole state: the two previous results, foot locks, the current source, the user's body.
/// Deterministic: the same library, settings and input give identical bits. Not thread-safe.
class PartnerSynthesizer {
 public:
  /// @param excluded_takes  never selected (leave-one-take-out)
  static Result<std::unique_ptr<PartnerSynthesizer>> create(
      std::shared_ptr<const MotionLibrary> library, const Settings& settings,
      const std::vector<std::string>& excluded_takes = {});
  ~PartnerSynthesizer();

  /// After a longer time without a solved frame, the temporal state is reset.
  static constexpr double tracking_loss_s = 0.3;

  /// Solves one frame. Never throws and never returns a pose that is not finite: unmet constraints are in
  /// `status` and `residual`; after a failure the last good poses are held.
  /// @param user the user's pose, 25 joints, world [m]; any body size
  /// @param elapsed  since the previous step; after more than `tracking_loss_s` without a solved frame the
  /// temporal state is reset
  /// @return         valid until the next call
  const FrameResult& step(const Pose& user, Duration elapsed);

  /// Applies from the next step on; state is kept. With the selection `intent` the first step learns from the
  /// library, for a second or more, unless prepared through `views`. When the user's role changes, both
  /// bodies continue from where they are, the partner as at a change of source. The first change builds the
  /// other role's view of the library unless prepared through `views`.
  /// @throws std::exception if that view cannot be built; nothing is changed then
  void set_settings(const Settings& settings);
  const Settings& settings() const;

  /// Sets the user's body; without it the first plausible pose is measured.
  void set_user_body(const Body& body);
  /// For another user: the next plausible pose is measured.
  void forget_user_body();
  /// The given or measured body; none before that.
  const std::optional<Body>& user_body() const;

  /// Clears the previous frames: the next step is a first one.
  void reset();

  /// Always selects this pair while it is set, even if it is vetoed. A pair of an excluded take, or one that
  /// does not exist, is ignored.
  void pin_pair(std::optional<int> pair);

  /// Replaces the vetoes, from the next step on. If no selectable pair is left, steps fail with that message.
  void set_vetoes(const Vetoes& vetoes);

  /// Sets the intended move, from the next step on. While one of its pairs is selectable, Eq. 7 selects only
  /// these; for the selection `intent` other pairs cost more.
  void set_intended(const std::optional<IntendedPairs>& meant);

  /// Everything that the next step depends on, except settings and input.
  SynthesizerState state() const;
  /// Continues from `state`, taken from a synthesizer of the same library and excluded takes. Settings stay,
  /// except the user's role, which is the state's.
  void restore(const SynthesizerState& state);
  /// Continues from the state of a synthesizer over another library: bodies and locks stay, recorded pairs
  /// are selected again; pin, vetoes and intended move stay those of this object.
  void take_over(const SynthesizerState& state);

  const MotionLibrary& library() const;
  /// The library as seen by the user of each role. Thread-safe.
  const std::shared_ptr<const RoleViews>& views() const;
  std::shared_ptr<const MotionLibrary> shared_library() const;

 private:
  struct State;
  explicit PartnerSynthesizer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace abrazo
