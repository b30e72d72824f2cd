#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "core/session/frames/decisions.hpp"
#include "core/session/run/role_switch.hpp"
#include "core/synthesis/partner_synthesizer.hpp"

namespace abrazo {

/// What a person asked of the running solver, and what of it holds at present: settings and decisions.
/// Applies them to the synthesizer; the only one who does.
class SolverControl {
 public:
  explicit SolverControl(std::shared_ptr<PartnerSynthesizer> synthesizer);

  PartnerSynthesizer& synthesizer() const { return *synthesizer_; }

  /// The user's role among them counts while the hand decides about it.
  void set_settings(const Settings& settings);
  void pin(std::optional<int> pair);
  void set_vetoes(const Vetoes& vetoes);
  void intend(const std::optional<MeantMove>& move);
  void control_role(RoleControl by);
  /// Settings and decisions stay, but those on pairs, takes and labels that the new library does not have
  /// fall away. Both bodies go on from where they are.
  void replace(std::shared_ptr<PartnerSynthesizer> synthesizer);

  /// Before a step: a declared move that was in force until now is released, the role changes where it is to.
  /// @return whether anything changed
  bool before_step(double now_s);
  /// After a step, as `PartnerSynthesizer::step` was given it.
  void after_step(const FrameResult& result, const Pose& user, double time_s);

  /// The selection that was asked for waits until it has learned the library; Eq. 7 selects meanwhile.
  bool is_learning() const;

  /// Under which the next step is solved; null while there are none.
  const std::shared_ptr<const Decisions>& decisions() const { return decisions_; }

 private:
  bool can_take(UserRole role);
  void apply(Settings wanted);
  SelectionMethod possible_selection(UserRole role);
  void decide(const Decisions& decisions);
  bool is_over(const MeantMove& move, double now_s) const;
  void watch_move(const FrameResult& result);

  std::shared_ptr<PartnerSynthesizer> synthesizer_;
  Decisions current_;
  std::shared_ptr<const Decisions> decisions_;
  UserRole asked_role_;                    ///< by the hand
  SelectionMethod asked_selection_;        ///< by the hand
  std::array<bool, 2> could_not_learn_{};  ///< by role; until it is asked for again
  std::string untold_;                     ///< why, thrown after the next step's changes
  RoleSwitch role_switch_;
  int followed_pair_ = -1;  ///< of the intended move
  bool move_is_done_ = false;
};

}  // namespace abrazo
