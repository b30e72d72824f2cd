#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "core/session/frames/decisions.hpp"
#include "core/session/run/role_switch.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"

namespace abrazo {

/// The requested settings and decisions of the running solver, and those now in force. The only class that
/// applies them to the synthesizer.
class SolverControl {
 public:
  explicit SolverControl(std::shared_ptr<PartnerSynthesizer> synthesizer);

  PartnerSynthesizer& synthesizer() const { return *synthesizer_; }

  /// The user's role in the settings applies only under RoleControl::Hand.
  void set_settings(const Settings& settings);
  void pin(std::optional<int> pair);
  void set_vetoes(const Vetoes& vetoes);
  void intend(const std::optional<IntendedMove>& move);
  void control_role(RoleControl by);
  /// Settings and decisions stay, except decisions on pairs, takes and labels that are not in the new
  /// library. Both bodies continue from where they are.
  void replace(std::shared_ptr<PartnerSynthesizer> synthesizer);

  /// As at the beginning, with everything that was asked for since: the next step is a first one.
  void begin_again();
  /// From a state of this library, with what is asked for now.
  void continue_from(const SynthesizerState& state);
  /// Selects as asked once the library is learned. @return whether that changed now
  bool take_learned();

  /// Before a step: releases an intended move that has ended and applies a due change of role.
  /// @return whether anything changed
  bool before_step(double now_s);
  /// After a step, with the input of `PartnerSynthesizer::step`.
  void after_step(const FrameResult& result, const Pose& user, double time_s);

  /// Whether the requested selection is still learning the library; Eq. 7 selects meanwhile.
  bool is_learning() const;

  /// The decisions for the next step; null if there are none.
  const std::shared_ptr<const Decisions>& decisions() const { return decisions_; }

 private:
  bool can_take(UserRole role);
  void apply(Settings wanted);
  SelectionMethod possible_selection(UserRole role);
  void decide(const Decisions& decisions);
  void follow(const std::optional<IntendedMove>& move);
  bool is_over(const IntendedMove& move, double now_s) const;
  void watch_move(const FrameResult& result);

  std::shared_ptr<PartnerSynthesizer> synthesizer_;
  Decisions current_;
  std::shared_ptr<const Decisions> decisions_;
  UserRole asked_role_;                     ///< by the hand
  std::optional<IntendedMove> asked_move_;  ///< also when it is over
  SelectionMethod asked_selection_;         ///< by the hand
  std::array<bool, 2> could_not_learn_{};   ///< by role; until requested again
  std::string unreported_;                  ///< unreported reason, thrown after the next step's changes
  RoleSwitch role_switch_;
  int followed_pair_ = -1;  ///< pair of the intended move followed last
  bool move_is_done_ = false;
  std::jthread leaving_;  ///< ends the synthesizers that were replaced
};

}  // namespace abrazo
