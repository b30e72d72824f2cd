#pragma once

#include <array>
#include <vector>

#include "core/choreography/fight_technique.hpp"
#include "core/choreography/fighter.hpp"

namespace abrazo {

/// The timing of one blow. Seconds from the start of the take.
struct Blow {
  Attack attack = {};
  bool by_a = true;
  double from = 0, until = 0;           ///< preparation to recovery; the interval of its label
  double start = 0;                     ///< the first movement of the blow itself
  double leaves = 0;                    ///< the hand or foot leaves
  double impact = 0;                    ///< it arrives, or goes past
  double released = 0;                  ///< it begins to return
  double back = 0;                      ///< it is in guard, or on the floor
  double reacts = 0;                    ///< the defender begins to react
  double met = 0;                       ///< the defender is in position
  Spot aimed_at = {};                   ///< position of the defender at the begin of the blow
  std::size_t leg_move = 0, check = 0;  ///< indices of the leg moves of attacker and defender
};

/// A fight over a take: alternating neutral footwork and exchanges, written into the two fighters.
class FightScore {
 public:
  /// @param a_attacks_first  who attacks in the first exchange
  FightScore(Fighter& a, Fighter& b, double seconds, double pace, bool a_attacks_first, RandomSource& random);

  const std::vector<Blow>& blows() const { return blows_; }
  /// The take may be longer than requested if not even one exchange fits.
  double seconds() const { return seconds_; }

 private:
  void neutral(double until);
  double pair_step(double time);
  void exchange(const std::vector<Attack>& attacks);
  /// Brings the fighters to the distance of a blow. @return the earliest start of the blow [s]
  double approach(double time, const Attack& attack, bool first);
  void write_blow(double start, const Attack& attack);
  void write_punch(Blow& blow, const TechniqueForm& form, double path);
  void write_kick(Blow& blow, const TechniqueForm& form, double path);
  void write_trunk(const Blow& blow, const TechniqueForm& form);
  void write_defence(Blow& blow);

  Fighter& attacker() { return *fighters_[a_attacks_ ? 0 : 1]; }
  Fighter& defender() { return *fighters_[a_attacks_ ? 1 : 0]; }

  std::array<Fighter*, 2> fighters_;
  double seconds_;
  double pace_;
  bool a_attacks_;
  RandomSource& random_;
  double now_ = 0;
  std::vector<Blow> blows_;
};

}  // namespace abrazo
