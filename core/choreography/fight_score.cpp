#include "core/choreography/fight_score.hpp"

#include <algorithm>
#include <cmath>

#include "core/choreography/strike_contact.hpp"
#include "core/choreography/strike_reach.hpp"

namespace abrazo {
namespace {

constexpr double shortest_guard = 0.45;  ///< [s]
constexpr double last_guard = 0.6;       ///< remaining time for a last guard after an exchange [s]

Vec3 between(const Spot& from, const Spot& to) {
  return to.place - from.place;
}

/// Long enough that the body accelerates by no more than 8 m/s^2 (least jerk: 5.77 times length / time^2).
double shuffle_time(double length) {
  return std::max(0.28, 0.85 * std::sqrt(length));
}

/// About normal, standard deviation 1, at most 2.
double drawn_error(RandomSource& random) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += random.uniform(-0.5, 0.5);
  return sum * std::sqrt(3.0);
}

}  // namespace

FightScore::FightScore(Fighter& a, Fighter& b, double seconds, double pace, bool a_attacks_first,
                       RandomSource& random)
    : fighters_{&a, &b}, seconds_(seconds), pace_(pace), a_attacks_(a_attacks_first), random_(random) {
  neutral(random.uniform(0.7, 1.3) / pace);
  const auto fits = [&](std::size_t blows) {
    return now_ + (1.7 + 0.65 * static_cast<double>(blows)) / pace_ + last_guard <= seconds_;
  };
  do {
    std::vector<Attack> attacks = draw_combination(random);
    if (!fits(attacks.size())) attacks.resize(1);
    exchange(attacks);
    const bool counters = random.chance(0.22);
    a_attacks_ = counters ? !a_attacks_ : random.chance(0.5);
    if (!counters || !fits(1)) neutral(now_ + std::max(shortest_guard, random.uniform(0.5, 1.9) / pace));
  } while (fits(1));
  seconds_ = std::max(seconds_, now_ + last_guard);
  neutral(seconds_);
  for (Fighter* fighter : fighters_) fighter->settle(seconds_);
  for (const Blow& blow : blows_)
    write_contact(blow, *fighters_[blow.by_a ? 0 : 1], *fighters_[blow.by_a ? 1 : 0]);
}

void FightScore::neutral(double until) {
  double time = now_;
  while (time + 0.55 / pace_ < until) time = pair_step(time) + random_.uniform(0.04, 0.45) / pace_;
  now_ = until;
}

double FightScore::pair_step(double time) {
  Fighter &a = *fighters_[0], &b = *fighters_[1];
  const Vec3 line = between(a.final_spot(), b.final_spot());
  const double size = (a.body().height + b.body().height) / 3.5;
  const double small = 0.7 + 0.15 * (a.performance().amplitude + b.performance().amplitude);
  const double distance = size * random_.uniform(1.22, 1.42);
  const double turn = small * random_.uniform(-0.42, 0.42);
  const Vec3 centre = a.final_spot().place + 0.5 * line;
  const Vec3 travel =
      small * Vec3(random_.uniform(-0.15, 0.15), 0, random_.uniform(-0.15, 0.15)) - 0.15 * centre;
  const double heading = a.final_spot().heading + turn;
  const Vec3 half = 0.5 * distance * forward_of(heading);
  const std::array<Spot, 2> to = {Spot{centre + travel - half, heading},
                                  Spot{centre + travel + half, b.final_spot().heading + turn}};
  double done = time;
  const int first = random_.below(2);
  for (const int who : {first, 1 - first}) {
    Fighter& fighter = *fighters_[static_cast<std::size_t>(who)];
    const Spot& place = to[static_cast<std::size_t>(who)];
    const double late = who == first ? 0 : random_.uniform(0.05, 0.14);
    const double length = between(fighter.final_spot(), place).norm();
    const double duration = shuffle_time(length) / pace_;
    const double error = fighter.performance().timing_error_s * std::abs(drawn_error(random_));
    const double start = std::max(time + late + error, fighter.free_from());
    done = std::max(done, fighter.shuffle(start, duration, place));
  }
  return done;
}

double FightScore::approach(double time, const Attack& attack, bool first) {
  Fighter &by = attacker(), &against = defender();
  const Vec3 line = between(by.final_spot(), against.final_spot());
  const double wanted = strike_reach(by, against, attack).distance;
  const double step = line.norm() - wanted;
  if (std::abs(step) < 0.02) return std::max(time, first ? by.free_from() : time);
  // Too near after a blow: the one attacked gives way. Otherwise the attacker goes.
  const bool gives_way = !first && step < 0;
  Fighter& mover = gives_way ? against : by;
  const double start = std::max(time, mover.free_from());
  const double duration = shuffle_time(std::abs(step)) / pace_;
  const Vec3 way = (gives_way ? -1 : 1) * step * line.normalized();
  const double arrives =
      mover.shuffle(start, duration, {mover.final_spot().place + way, mover.final_spot().heading});
  // A jab goes with the leading foot; what turns on a foot waits for it.
  const double early = attack.technique == Technique::Jab ? 0.60 : is_kick(attack.technique) ? 0.10 : 0.28;
  return std::max(start, arrives - early * duration);
}

void FightScore::exchange(const std::vector<Attack>& attacks) {
  const std::size_t first_blow = blows_.size();
  for (const Attack& attack : attacks) {
    const bool first = blows_.size() == first_blow;
    const double ready =
        first ? std::max(now_, defender().free_from() - 0.3 / pace_) : blows_.back().released + 0.02;
    write_blow(approach(ready, attack, first), attack);
    if (!first) blows_[blows_.size() - 2].until = blows_.back().start;
  }
  for (std::size_t i = first_blow; i < blows_.size(); ++i)
    blows_[i].from = i == first_blow ? now_ : blows_[i - 1].until;
  now_ = blows_.back().until;
}

void FightScore::write_blow(double start, const Attack& attack) {
  const TechniqueForm form = form_of(attack.technique);
  const double path = strike_reach(attacker(), defender(), attack).path;
  Blow blow;
  blow.attack = attack, blow.by_a = a_attacks_;
  // The foot that kicks or turns must stand by then, and those of the defender by the time he reacts.
  blow.start = std::max(start, defender().free_from() - 0.06);
  const double lead = form.lead_s / pace_;
  if (is_kick(attack.technique)) blow.start = std::max(blow.start, attacker().free_from() - lead);
  if (form.pivot_yaw != 0) blow.start = std::max(blow.start, attacker().free_from(form.pivot) - 0.5 * lead);
  blow.leaves = blow.start + lead;
  blow.aimed_at = defender().spot(blow.start);
  if (is_kick(attack.technique))
    write_kick(blow, form, path);
  else
    write_punch(blow, form, path);
  write_trunk(blow, form);
  write_defence(blow);
  blows_.push_back(blow);
}

void FightScore::write_punch(Blow& blow, const TechniqueForm& form, double path) {
  // A least-jerk movement peaks at 15/8 of its mean speed.
  // One that is stopped has not slowed down by itself when it meets the guard.
  const bool hook = blow.attack.technique == Technique::Hook;
  const double stopped = is_block(blow.attack.defence) && !hook ? 1.15 : 1;
  const double speed = stopped * pace_ * random_.uniform(form.speed_low, form.speed_high);
  // A hook swings wide, so its way is longer than the straight line.
  const double way = hook ? std::hypot(path, 0.32) : path;
  blow.impact = blow.leaves + std::max(0.092, 1.875 * way / speed);
  blow.released = blow.impact + (is_block(blow.attack.defence) ? 0.05 : 0.025);
  blow.back = blow.released + form.recovery_s / pace_;
  blow.until = blow.released + 0.85 * form.recovery_s / pace_;
}

void FightScore::write_kick(Blow& blow, const TechniqueForm& form, double path) {
  const double speed = pace_ * random_.uniform(form.speed_low, form.speed_high);
  const double extended = blow.leaves + 0.18 / pace_;  // the knee is nearly up
  blow.impact = extended + std::max(0.14, 1.875 * path / speed);
  blow.released = blow.impact + (is_block(blow.attack.defence) ? 0.06 : 0.03);
  blow.back = blow.released + (0.22 + form.recovery_s) / pace_;
  blow.until = blow.back;
  LegMove leg = kick_form(attacker().body(), blow.attack.technique);
  leg.chamber = {blow.leaves, blow.leaves + 0.28 / pace_, blow.released + 0.12 / pace_, blow.back};
  leg.strike = {extended, blow.impact, blow.released, blow.released + 0.30 / pace_};
  blow.leg_move = attacker().leg_move_count(form.limb);
  attacker().add(form.limb, leg);
}

void FightScore::write_trunk(const Blow& blow, const TechniqueForm& form) {
  const StrikeTrunk trunk = strike_trunk(attacker(), form);
  const double late = 0.3 * (blow.impact - blow.start);
  // Who has not learnt it yet starts from the shoulders and brings the hips too late.
  const double clumsy =
      std::min(late, attacker().performance().timing_error_s * std::abs(drawn_error(random_)));
  const double turned = std::min(blow.impact - 0.02 + 0.7 * clumsy, blow.released);
  attacker().add(TrunkMove{{blow.start + clumsy, turned, blow.released, blow.back}, trunk.hips});
  attacker().add(
      TrunkMove{{blow.start + late, blow.impact, blow.released + 0.03, blow.back + 0.05}, trunk.shoulders});
  if (form.pivot_yaw == 0) return;
  const double turn = std::max(blow.start, attacker().free_from(form.pivot));
  attacker().pivot(form.pivot, turn, blow.impact, form.pivot_yaw);
  attacker().pivot(form.pivot, blow.released, blow.back, 0);
}

void FightScore::write_defence(Blow& blow) {
  Fighter& by = defender();
  const Attack& attack = blow.attack;
  const double error = by.performance().timing_error_s * drawn_error(random_);
  // The whole trunk takes longer to move than a hand.
  const double needed = is_block(attack.defence) ? 0.15 : 0.25;
  const double slowest = std::clamp(blow.impact - blow.start - needed, 0.07, 0.15);
  blow.reacts = blow.start + random_.uniform(0.06, slowest) + std::max(-0.05, error);
  blow.met = std::max(blow.impact - (is_block(attack.defence) ? 0 : 0.02) + error, blow.reacts + 0.10);
  const double amplitude = is_block(attack.defence) ? 1 : 0.6 + 0.4 * by.performance().amplitude;
  TrunkOffsets trunk = amplitude * trunk_of(attack.defence, attack.technique);
  trunk.head<3>() *= by.body().height / 1.75;
  const double held = std::max(blow.released, blow.met) + 0.06;
  by.add(TrunkMove{{blow.reacts, blow.met, held, held + 0.46 / pace_}, trunk});
  if (attack.defence == Defence::ShinCheck) {
    LegMove leg = check_form(by.body());
    const double lift = std::max(blow.reacts, by.free_from());
    leg.chamber = {lift, std::max(blow.met, lift + 0.2), held, held + 0.36 / pace_};
    by.add(Side::Left, leg);
  }
  if (attack.defence == Defence::StepBack) {
    const Vec3 away = -0.23 * by.body().height * amplitude * forward_of(by.final_spot().heading);
    const double start = std::max(blow.reacts, by.free_from());
    by.shuffle(start, std::max(0.38, blow.met - start + 0.10),
               {by.final_spot().place + away, by.final_spot().heading});
  }
}

}  // namespace abrazo
