#include "core/synthesis/motion/partner_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/body/body_segments.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double slowest_rate = 0.7, fastest_rate = 1.5;
constexpr double lead_closes_s = 0.33;  ///< a lead of the user is closed in about this
constexpr double rate_lag_s = 0.15;
constexpr double farthest_asked_m = 0.3;
constexpr double adaptation_rate = 13;  ///< omega [1/s]
constexpr double near_m = 0.05;         ///< joints nearer to one another than this weigh no more
constexpr double shift_share = 0.4;     ///< of the user's difference from the recorded leader
constexpr double looks_ahead_s = 0.5;
constexpr double carries_ahead_s = 0.5;      ///< so much of the recording is the mean of its speed taken over
constexpr double body_room_m = 0.4;          ///< between two roots
constexpr double pushes_off = 10;            ///< times what is missing of it
constexpr double drawn_share = 2.4;          ///< of what a held hand lies beyond reach
constexpr double approaches_within_m = 0.1;  ///< so much nearer than in the recording: not drawn to the user

RootFrame on_floor(const RootFrame& root) {
  return {{root.position.x(), 0, root.position.z()}, root.heading_rad};
}

/// A hand draws the body along, but not into the user. @param relation  recorded place of the partner
/// relative to the user's root
Vec3 no_nearer(const Vec3& drawn, const RootFrame& partner, const RootFrame& user,
               const RootFrame& relation) {
  Vec3 to_user = user.position - partner.position;
  to_user.y() = 0;
  const double far = to_user.norm();
  if (far < 1e-3) return drawn;
  to_user /= far;
  const double recorded = std::hypot(relation.position.x(), relation.position.z());
  const double barred = std::clamp((recorded - far) / approaches_within_m, 0.0, 1.0);
  return drawn - barred * std::max(0.0, drawn.dot(to_user)) * to_user;
}

/// The centre of mass, horizontal, seen from the body's own root and heading [m].
Vec3 centre_of(const BodyShape& shape, const Body& body) {
  static const auto segments = body_segments(SegmentTable::Mean);
  Vec3 centre = centre_of_mass(segments, placed_body(shape, body, RootFrame{}));
  centre.y() = 0;
  return centre;
}

/// Of the recorded partner's heading [rad].
double turn_between(const RecordedMoment& from, const RecordedMoment& to) {
  return within_half_turn(to.partner_in_take.heading_rad - from.partner_in_take.heading_rad);
}

}  // namespace

/// The mean over moments to come smooths the recording's accelerations without falling behind.
RecordedStep PartnerMover::recorded_step() const {
  RecordedStep recorded{.turn = turn_};
  const SourcePlayhead& now = motion_.playhead;
  if (step_.stands) return recorded;
  const double source_s = now.rate * carries_ahead_s;
  const double ahead_s = std::min(source_s, recorded_ahead(step_.library, now, source_s));
  if (ahead_s <= 0) return recorded;
  const RecordedMoment later = moment_at(moved(step_.library, now, ahead_s));
  const Vec3 moved_by = leg_scale() * (later.partner_in_take.position - moment_.partner_in_take.position) +
                        later.partner_in_take.rotation() * centre_of(shape_in(later), body_) -
                        moment_.partner_in_take.rotation() * centre_of(shape_in(moment_), body_);
  recorded.speed = (now.rate / ahead_s) * (moment_.partner_in_take.rotation().transpose() * moved_by);
  recorded.speed.y() = 0;
  return recorded;
}

Vec3 shift_of_user(const RecordedMoment& moment, const Pose& user, const RootFrame& user_root) {
  const Pose leader = to_world(moment.pair.topRows<joint_count>(), on_floor(user_root));
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (int k = 0; k < joint_count; ++k) {
    double weight = 0;
    for (int l = 0; l < joint_count; ++l) {
      const double apart = std::max((moment.pair.row(k) - moment.pair.row(l + joint_count)).norm(), near_m);
      weight += 1 / (apart * apart * apart);
    }
    sum += weight * (user.row(k) - leader.row(k)).transpose();
    weights += weight;
  }
  Vec3 shift = sum / weights;
  shift.y() = 0;
  return shift;
}

std::uint8_t moving_settings(const Settings& settings) {
  std::uint8_t bits = 0;
  for (const bool is_on : {settings.playback == SourcePlayback::Continuous, settings.foot_locks,
                           settings.hold_weight > 0, settings.collisions, settings.scale_root_path})
    bits = static_cast<std::uint8_t>(2 * bits + (is_on ? 1 : 0));
  return bits;
}

PartnerMover::PartnerMover(PartnerMotion& motion, const MotionStep& step)
    : motion_(motion), step_(step), body_(step.library.usual_passive_body().body) {}

PairPose PartnerMover::move() {
  if (motion_.playhead.pair < 0)
    begin();
  else if (step_.changes)
    change();
  else
    go_on();
  const RootFrame user_place = on_floor(step_.user_root);
  const Vec3 shift = shift_of_user(moment_, step_.user, step_.user_root);
  const RootFrame relation = step_.partner_place.value_or(moment_.partner);
  RootFrame wanted;
  wanted.position =
      user_place.position + user_place.rotation() * on_floor(relation).position + shift_share * shift;
  wanted.heading_rad = user_place.heading_rad + relation.heading_rad;
  wanted.position += wanted.rotation() * centre_of(shape_in(moment_), body_);
  if (!is_placed_) {
    motion_.place = PartnerPlace(wanted);
  } else {
    stand();
    const Vec3 drawn = motion_.holds.drawn(moved_, moment_, step_.user, step_.user_root, body_);
    motion_.place.advance(recorded_step(), away(wanted), step_.elapsed_s, step_.settings.place_rate,
                          drawn_share * no_nearer(drawn, root_, step_.user_root, moment_.partner));
  }
  goes_ = motion_.place.way_to(wanted);
  motion_.since_change_s = changed_ ? 0 : motion_.since_change_s + step_.elapsed_s;
  stand();
  PairPose pair;
  pair << step_.user, moved_;
  return pair;
}

void PartnerMover::stand() {
  const BodyShape shown = motion_.transition.shown(shape_in(moment_));
  root_ = motion_.place.at();
  root_.position -= root_.rotation() * centre_of(shown, body_);
  moved_ = placed_body(shown, body_, root_);
}

/// Not through the user: the wanted place is as far off as in the recording, or as bodies are.
RootFrame PartnerMover::away(const RootFrame& wanted) {
  RootFrame there = wanted;
  const double room =
      std::min(body_room_m, std::hypot(moment_.partner.position.x(), moment_.partner.position.z()));
  Vec3 off = motion_.place.at().position - step_.user_root.position;
  off.y() = 0;
  const double far = off.norm();
  if (far < 1e-3 || far >= room) return there;
  there.position += pushes_off * (room - far) / far * off;
  return there;
}

Pose PartnerMover::adapt(const Pose& edited) {
  // Deeply overlapping bodies can demand metres.
  Pose asked = edited - moved_;
  const double farthest = asked.rowwise().norm().maxCoeff();
  if (farthest > farthest_asked_m) asked *= farthest_asked_m / farthest;
  const Pose bent = moved_ + motion_.adaptation.follow(asked, root_, step_.elapsed_s, adaptation_rate);
  // Joint offsets stretch bones; only their rotations are kept.
  const RootFrame root{bent.row(0), root_.heading_rad};
  Pose pose = placed_body(shape_of(to_normalized(bent, root), bent(0, 1)), body_, root);
  plant_feet(pose);
  hold_hands(pose);
  return pose;
}

double PartnerMover::leg_scale() const {
  const double recorded = step_.library.passive_body(motion_.playhead.pair).body.leg_length();
  return recorded > 1e-6 ? body_.leg_length() / recorded : 1;
}

BodyShape PartnerMover::shape_in(const RecordedMoment& moment) const {
  return shape_of(moment.partner_own, leg_scale() * moment.partner.position.y());
}

RecordedMoment PartnerMover::moment_at(const SourcePlayhead& playhead) const {
  return recorded_moment(step_.library, playhead);
}

void PartnerMover::begin() {
  motion_.playhead = {step_.chosen, 0, 1};
  motion_.moved_by = moving_settings(step_.settings);
  moment_ = moment_at(motion_.playhead);
  motion_.transition.reset();
  motion_.plants.reset();
  motion_.holds.reset();
  changed_ = true;
  motion_.adaptation.reset();
  is_placed_ = step_.shown.has_value();
  if (step_.shown) begin_from(*step_.shown);
}

void PartnerMover::begin_from(const ShownPartner& shown) {
  const RootFrame at = root_frame(shown.pose), before = root_frame(shown.before);
  const auto shape = [](const Pose& pose, const RootFrame& root) {
    return shape_of(to_normalized(pose, root), root.position.y());
  };
  const auto placed = [&](const Pose& pose, RootFrame root) {
    root.position += root.rotation() * centre_of(shape(pose, root), body_);
    return root;
  };
  const RootFrame centre_at = placed(shown.pose, at), centre_before = placed(shown.before, before);
  motion_.place = PartnerPlace(centre_at);
  const RecordedMoment earlier = moment_at(moved(step_.library, motion_.playhead, -shown.before_s));
  motion_.transition.begin(shape(shown.pose, at), shape_in(moment_), shape(shown.before, before),
                           shape_in(earlier), shown.before_s, step_.settings.transition_time_s);
  if (shown.before_s <= 0) return;
  // One step before the shown pose, so that this step arrives there.
  Vec3 speed = (centre_at.position - centre_before.position) / shown.before_s;
  speed.y() = 0;
  const double turning = within_half_turn(at.heading_rad - before.heading_rad) / shown.before_s;
  const double share = step_.elapsed_s / shown.before_s;
  turn_ = share * turn_between(earlier, moment_);
  const RootFrame place{centre_at.position - step_.elapsed_s * speed,
                        centre_at.heading_rad - step_.elapsed_s * turning};
  // What it was shown with carries it on, until the new source does.
  motion_.place =
      PartnerPlace(place, speed, step_.elapsed_s > 0 ? turning - turn_ / step_.elapsed_s : turning, speed);
}

void PartnerMover::go_on() {
  const RecordedMoment before = moment_at(motion_.playhead);
  if (step_.stands) {
    motion_.playhead.rate = 1;
  } else {
    follow_clock();
    motion_.playhead = moved(step_.library, motion_.playhead, motion_.playhead.rate * step_.elapsed_s);
  }
  moment_ = moment_at(motion_.playhead);
  motion_.transition.advance(step_.elapsed_s);
  turn_ = turn_between(before, moment_);
}

void PartnerMover::follow_clock() {
  const double goal = std::clamp(1 + step_.lead_s / lead_closes_s, slowest_rate, fastest_rate);
  double& rate = motion_.playhead.rate;
  rate += (goal - rate) * (1 - std::exp(-step_.elapsed_s / rate_lag_s));
}

/// The old source continues by this step, and the new one begins where the old one would be.
void PartnerMover::change() {
  const double elapsed_s = step_.elapsed_s;
  const SourcePlayhead old = motion_.playhead;
  const double source_s = old.rate * elapsed_s;
  const RecordedMoment old_before = moment_at(old);
  const RecordedMoment old_now = moment_at(moved(step_.library, old, source_s));
  const BodyShape seen_before = motion_.transition.shown(shape_in(old_before));
  motion_.transition.advance(elapsed_s);
  const BodyShape seen = motion_.transition.shown(shape_in(old_now));
  const double old_turn = turn_between(old_before, old_now);

  motion_.playhead = {step_.chosen, 0, old.rate};
  moment_ = moment_at(motion_.playhead);
  const SourcePlayhead earlier = moved(step_.library, motion_.playhead, -source_s);
  const RecordedMoment before = moment_at(earlier);
  const bool has_before = elapsed_s > 0 && !(earlier == motion_.playhead);
  motion_.transition.begin(seen, shape_in(moment_), seen_before, shape_in(before), has_before ? elapsed_s : 0,
                           step_.settings.transition_time_s);
  turn_ = turn_between(before, moment_);
  if (has_before) motion_.place.keep_turning((old_turn - turn_) / elapsed_s);
  changed_ = true;
}

void PartnerMover::plant_feet(Pose& pose) {
  if (!step_.settings.foot_locks) return motion_.plants.reset();
  std::array<FootMoment, 2> moments;
  const double recorded_rest = step_.library.passive_body(motion_.playhead.pair).body.toe_rest_height;
  for (const bool left : {true, false}) {
    using namespace joints;
    FootMoment& foot = moments[left ? 0 : 1];
    const int toe_base = left ? left_toe_base : right_toe_base;
    foot.free = pose.row(toe_base);
    foot.ankle = pose.row(toe_base - 1);
    foot.hip = pose.row(toe_base - 3);
    foot.body_goes = goes_;
    foot.leg_length = body_.leg_length();
    foot.rest_height = body_.toe_rest_height;
    foot.recorded_height = moment_.pair(toe_base + joint_count, 1) - recorded_rest + body_.toe_rest_height;
    foot.lands = stands_in_recording(step_.library, motion_.playhead, left);
    if (!foot.lands)
      foot.lands_in_s = stands_again_in_s(step_.library, motion_.playhead, left, looks_ahead_s);
  }
  const auto shown = motion_.plants.update(moments, step_.elapsed_s);
  const Vec3 forward = motion_.place.at().rotation() * Vec3::UnitZ();
  for (const bool left : {true, false}) {
    place_foot(pose, body_, left, shown[left ? 0 : 1], forward);
    motion_.plants.settle(left ? 0 : 1, pose.row(left ? joints::left_toe_base : joints::right_toe_base));
  }
}

void PartnerMover::hold_hands(Pose& pose) {
  if (step_.settings.hold_weight <= 0) return motion_.holds.reset();
  const Pose without = pose;
  const HandHolds::Surroundings now{step_.library,   motion_.playhead, moment_, changed_, step_.user,
                                    step_.user_root, without,          body_,   root_};
  motion_.holds.update(now, step_.elapsed_s);
  motion_.holds.place_arms(pose, now, step_.elapsed_s);
}

}  // namespace abrazo
