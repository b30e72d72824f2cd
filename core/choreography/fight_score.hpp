#pragma once

#include <array>
#include <vector>

#include "core/choreography/fight_technique.hpp"
#include "core/choreography/fighter.hpp"

namespace abrazo {

/// One blow as it takes place. Times in seconds from the start of the take.
struct Blow {
  Attack attack = {};
  bool by_a = true;
  double from = 0, until = 0;           ///< preparation to recovery; the interval of its label
  double start = 0;                     ///< the first movement of the blow itself
  double leaves = 0;                    ///< the hand or foot
  double impact = 0;                    ///< arrives, or goes past
  double released = 0;                  ///< begins to come back
  double back = 0;                      ///< in guard, on the floor
  double reacts = 0;                    ///< the other begins to defend
  double met = 0;                       ///< and is where he wants to be
  Spot aimed_at = {};                   ///< where the other stood when the blow began
  std::size_t leg_move = 0, check = 0;  ///< which of the leg moves, of the attacker and of the defender
};

/// A fight of two over a take: neutral footwork and exchanges in turn, written into the two fighters.
class FightScore {
 public:
  /// @param a_attacks_first  who attacks in the first exchange
  FightScore(Fighter& a, Fighter& b, double seconds, double pace, bool a_attacks_first, RandomSource& random);

  const std::vector<Blow>& blows() const { return blows_; }
  /// The take may last longer than asked for when not even one exchange fits.
  double seconds() const { return seconds_; }

 private:
  void neutral(double until);
  double pair_step(double time);
  void exchange(const std::vector<Attack>& attacks);
  /// Brings them to the distance of a blow. @return when the blow may begin
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
