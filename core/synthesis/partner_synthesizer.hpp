#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/motion/body/body.hpp"
#include "core/selection/meant_pairs.hpp"
#include "core/selection/vetoes.hpp"
#include "core/synthesis/frame_result.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

class RoleViews;
struct SynthesizerState;

using Duration = std::chrono::duration<double>;

/// The whole method, one frame at a time: a user's pose in, both characters out (paper 3.3-3.4).
/// Owns the little state there is: the two previous results, foot locks, the current source, the user's
/// measures. Deterministic: the same library, settings and input give the same bits. Not thread-safe.
class PartnerSynthesizer {
 public:
  /// @param excluded_takes  never selected (leave-one-take-out)
  static Result<std::unique_ptr<PartnerSynthesizer>> create(
      std::shared_ptr<const MotionLibrary> library, const Settings& settings,
      const std::vector<std::string>& excluded_takes = {});
  ~PartnerSynthesizer();

  /// Longer without a solved frame, and the next one begins anew.
  static constexpr double tracking_loss_s = 0.3;

  /// Solves one frame. Never throws and never gives a pose that is not finite: what could not be met is in
  /// `status` and `residual`, and after a failure the last good poses are held.
  /// @param user     the user's pose, 25 joints, world [m]; need not be of the library's size
  /// @param elapsed  since the previous step; more than `tracking_loss_s` without a solved frame starts anew
  /// @return         valid until the next call
  const FrameResult& step(const Pose& user, Duration elapsed);

  /// Applies from the next step on; state is kept. With the selection `intent` the first step learns from
  /// the library, for a second or more, unless `views` was asked for that before. When the user's role
  /// changes, both bodies go on from where they are, the partner as at a change of source. The first change
  /// makes the other role's view of the library unless `views` was asked for it before.
  /// @throws std::exception when that view cannot be made; then all stays as it was
  void set_settings(const Settings& settings);
  const Settings& settings() const;

  /// What the user measures; without it the first pose that can be a person's is measured.
  void set_user_body(const Body& body);
  /// Another user: the next pose that can be a person's is measured.
  void forget_user_body();
  /// Given or measured; none before either.
  const std::optional<Body>& user_body() const;

  /// Forgets the previous frames: the next step is a first one.
  void reset();

  /// Selects this pair while it is set, also one that is vetoed. One that is left out or does not exist is
  /// not selected.
  void pin_pair(std::optional<int> pair);

  /// Does not select these from the next step on; in place of the vetoes before. When none is left, steps
  /// fail and say so.
  void set_vetoes(const Vetoes& vetoes);

  /// From the next step on, while one of them may be selected: by Eq. 7 only these are selected, by the
  /// selection `intent` others cost more.
  void set_meant(const std::optional<MeantPairs>& meant);

  /// All that the next step depends on beside settings and input.
  SynthesizerState state() const;
  /// Goes on where `state` was taken, on a synthesizer of the same library and excluded takes. Settings stay,
  /// but for the user's role, which is the state's.
  void restore(const SynthesizerState& state);
  /// Goes on where one over another library stopped: bodies and locks stay, recorded pairs are chosen anew;
  /// pins, vetoes and what is meant stay this one's.
  void take_over(const SynthesizerState& state);

  const MotionLibrary& library() const;
  /// The library as each role's user sees it; may be asked from another thread.
  const std::shared_ptr<const RoleViews>& views() const;
  std::shared_ptr<const MotionLibrary> shared_library() const;

 private:
  struct State;
  explicit PartnerSynthesizer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace abrazo
