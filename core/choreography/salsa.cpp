#include "core/choreography/salsa.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/choreography/arm_swivel.hpp"
#include "core/choreography/balance.hpp"
#include "core/choreography/couple_holds.hpp"
#include "core/choreography/couple_path.hpp"
#include "core/choreography/dancer_score.hpp"
#include "core/choreography/wander.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/body/smooth_window.hpp"

namespace abrazo {
namespace {

constexpr double label_lead = 0.5;  ///< a phrase's motion begins with the swing before its count 1 [beats]

/// Captured dancers are not perfectly balanced either: with this share the zero moment point is as far from
/// the feet as theirs (some 5 cm on average).
constexpr double balanced_share = 0.8;

// Times over which corrections are averaged, to either side [s].
constexpr double leg_smoothing_s = 0.20, arm_smoothing_s = 0.26;

int frames_in(double seconds, double fps) {
  return static_cast<int>(std::lround(seconds * fps));
}

/// How far the root must come down so that no leg is stretched beyond 97.5 % [m].
double overstretch(const DancerBody& body, const Pose& pose, const FootPosture& left,
                   const FootPosture& right) {
  double most = 0;
  for (const auto& [foot, hip] : {std::pair(&left, joints::left_hip), std::pair(&right, joints::right_hip)}) {
    const Vec3 leg = pose.row(hip).transpose() - ankle_position(body, *foot);
    const double across = std::hypot(leg.x(), leg.z()), reach = 0.975 * body.leg();
    most = std::max(most, leg.y() - std::sqrt(std::max(0.0, reach * reach - across * across)));
  }
  return most;
}

/// How much further the heel must come up for the leg to reach, if that helps: the foot that is left behind
/// stays on its toes [rad].
double heel_to_reach(const DancerBody& body, const Pose& pose, FootPosture foot, int hip) {
  constexpr double most = 0.9;
  const double flat = foot.heel_pitch, reach = 0.965 * body.leg();
  const auto stretch = [&](double raised) {
    foot.heel_pitch = flat + raised;
    return (pose.row(hip).transpose() - ankle_position(body, foot)).norm();
  };
  if (stretch(0) <= reach || stretch(0.1) >= stretch(0)) return 0;
  double low = 0, high = most;
  if (stretch(high) > reach) return most;
  for (int i = 0; i < 8; ++i) (stretch(0.5 * (low + high)) > reach ? low : high) = 0.5 * (low + high);
  return high;
}

/// Never below the given values, and smooth.
std::vector<double> smooth_cover(const std::vector<double>& values, int half_width) {
  return hann_mean(moving_maximum(values, half_width), half_width);
}

/// One dancer's frames while they are put together.
struct Dancer {
  DancerBody body;
  DancerScore score;
  Wander wander;
  std::vector<double> times{}, beats{};  ///< of every frame; the beats as this dancer hears them
  std::vector<TrunkPosture> trunks{};
  std::vector<Pose> poses{};

  void dance_legs_and_trunk(const std::vector<double>& gaze_yaws, double fps);
  void smooth_arms(double fps);
  PlacedDancer placed(std::size_t f) {
    return {body, trunks[f].chest, poses[f], wander.hand(Side::Left, times[f]),
            wander.hand(Side::Right, times[f])};
  }
};

void Dancer::dance_legs_and_trunk(const std::vector<double>& gaze_yaws, double fps) {
  const int half_width = frames_in(leg_smoothing_s, fps);
  std::vector<double> lower, left_heels, right_heels;
  FeetTrack feet;
  auto& [left_feet, right_feet] = feet;
  for (std::size_t f = 0; f < beats.size(); ++f) {
    trunks.push_back(score.trunk(beats[f], gaze_yaws[f]));
    left_feet.push_back(score.foot(Side::Left, beats[f]));
    right_feet.push_back(score.foot(Side::Right, beats[f]));
  }
  balance_trunks(body, feet, fps, balanced_share, trunks);
  for (std::size_t f = 0; f < beats.size(); ++f) {
    wander.displace(times[f], trunks[f]);
    place_trunk(body, trunks[f], poses.emplace_back(Pose::Zero()));
    left_heels.push_back(heel_to_reach(body, poses[f], left_feet[f], joints::left_hip));
    right_heels.push_back(heel_to_reach(body, poses[f], right_feet[f], joints::right_hip));
  }
  left_heels = smooth_cover(left_heels, half_width);
  right_heels = smooth_cover(right_heels, half_width);
  for (std::size_t f = 0; f < beats.size(); ++f) {
    left_feet[f].heel_pitch += left_heels[f];
    right_feet[f].heel_pitch += right_heels[f];
    lower.push_back(overstretch(body, poses[f], left_feet[f], right_feet[f]));
  }
  lower = smooth_cover(lower, half_width);
  for (std::size_t f = 0; f < beats.size(); ++f) {
    trunks[f].root.y() -= lower[f];
    place_trunk(body, trunks[f], poses[f]);
    place_leg(body, Side::Left, left_feet[f], trunks[f].pelvis.yaw, poses[f]);
    place_leg(body, Side::Right, right_feet[f], trunks[f].pelvis.yaw, poses[f]);
  }
}

void Dancer::smooth_arms(double fps) {
  std::vector<Turn> chests;
  for (const TrunkPosture& trunk : trunks) chests.push_back(trunk.chest);
  for (const Side side : {Side::Left, Side::Right})
    smooth_arm(body, side, chests, frames_in(arm_smoothing_s, fps), poses);
}

/// Direction in which each spot sees the other [rad].
double gaze(const Spot& from, const Spot& to) {
  const Vec3 d = to.place - from.place;
  return std::atan2(d.x(), d.z());
}

/// Names, roles and labels for the poses danced; `phrases` has one phrase before and one after those of the
/// take.
/// @param starts  first frame of each phrase, and the frame after the last
PairedTake described(const std::string& name, double fps, std::vector<Pose> his_poses,
                     std::vector<Pose> her_poses, const std::vector<SalsaPhrase>& phrases,
                     const std::vector<int>& starts) {
  PairedTake take{.name = name, .fps = fps, .a = {}, .b = {}, .roles = {}, .labels = {}};
  take.a = {name + "_a", fps, std::move(his_poses)};
  take.b = {name + "_b", fps, std::move(her_poses)};
  take.roles = {{0, starts.back(), ActivePerformer::A}};
  for (std::size_t p = 0; p + 1 < starts.size(); ++p)
    take.labels.push_back({.start = starts[p],
                           .end = starts[p + 1],
                           .label = std::string(label_of(move_of(phrases[p + 1].figure))),
                           .detail = std::string(detail_of(phrases[p + 1].figure)),
                           .confidence = "high"});
  return take;
}

/// How far ahead his hand reaches her shoulder blade, against dancers of 1.80 m and 1.66 m.
double embrace(const DancerBody& his, const DancerBody& hers) {
  const auto ahead = [](const DancerBody& one, const DancerBody& other) {
    const double arm = one.upper_arm + one.forearm + one.hand;
    const double down = 0.80 * one.height - 0.74 * other.height;
    return std::sqrt(std::max(0.0, arm * arm - down * down));
  };
  return ahead(his, hers) / ahead(leader_body(1.80), follower_body(1.66));
}

/// Phrases for dancers of these sizes.
std::vector<SalsaPhrase> phrases_for(int count, const ChoreographyOptions& options, RandomSource& random) {
  std::vector<SalsaPhrase> phrases = draw_phrases(count, random);
  const double size = (options.a.height_m + options.b.height_m) / 3.46;  // drawn for 1.80 m and 1.66 m
  // They cannot stand much closer than usual; a hand that only just reaches does not lie flat.
  const double reach = embrace(leader_body(options.a), follower_body(options.b));
  const double closeness = std::clamp(std::pow(reach, 2.5), 0.72 * size, size);
  for (SalsaPhrase& phrase : phrases) {
    phrase.step *= size, phrase.walk *= size;
    phrase.distance *= move_of(phrase.figure) == SalsaMove::ClosedHold ? closeness : size;
  }
  return phrases;
}

PairedTake dance_take(const std::string& name, int phrase_count, double tempo_bpm,
                      const ChoreographyOptions& options, RandomSource& random) {
  // A phrase before and one after are danced too and cut off, so that a take begins and ends in full motion.
  const std::vector<SalsaPhrase> phrases = phrases_for(phrase_count + 2, options, random);
  const CouplePath path(phrases);
  const CoupleHolds holds(phrases);
  const double beats_per_second = tempo_bpm / 60, beats_per_frame = beats_per_second / options.fps;
  const double duration = beats_per_phrase * phrase_count / beats_per_second;
  const auto dancer = [&](DanceRole role, const DancerBody& body, const Performance& performance) {
    return Dancer{body, DancerScore(role, body, phrases, path, performance.amplitude),
                  Wander(performance, duration, random)};
  };
  Dancer leader = dancer(DanceRole::Leader, leader_body(options.a), options.a.performance);
  Dancer follower = dancer(DanceRole::Follower, follower_body(options.b), options.b.performance);

  const double lag = random.uniform(0.05, 0.15);  // she answers his lead a little later [beats]
  std::vector<int> starts;
  for (int p = 0; p <= phrase_count; ++p)
    starts.push_back(static_cast<int>(std::lround(beats_per_phrase * p / beats_per_frame)));
  std::vector<double> his_gaze, her_gaze;
  for (int f = 0; f < starts.back(); ++f) {
    const double beat = beats_per_phrase - label_lead + f * beats_per_frame;
    for (Dancer* one : {&leader, &follower}) {
      one->times.push_back(f / options.fps);
      one->beats.push_back(beat + beats_per_second * one->wander.ahead_s(one->times.back()));
    }
    follower.beats.back() -= lag;
    his_gaze.push_back(gaze(path.leader(beat), path.follower(beat)));
    her_gaze.push_back(his_gaze.back() + std::numbers::pi);
  }
  leader.dance_legs_and_trunk(his_gaze, options.fps);
  follower.dance_legs_and_trunk(her_gaze, options.fps);
  for (std::size_t f = 0; f < leader.beats.size(); ++f)
    holds.place_arms(leader.beats[f], leader.placed(f), follower.placed(f));
  leader.smooth_arms(options.fps);
  follower.smooth_arms(options.fps);

  return described(name, options.fps, std::move(leader.poses), std::move(follower.poses), phrases, starts);
}

}  // namespace

std::vector<PairedTake> generate_salsa(const ChoreographyOptions& options, const Progress& progress) {
  check_options(options);
  const int takes = std::max(1, static_cast<int>(std::lround(options.minutes * 60 / options.take_seconds)));
  RandomSource random(options.seed);
  std::vector<PairedTake> dances;
  double left_s = options.minutes * 60;
  for (int t = 0; t < takes; ++t) {
    if (!report(progress, static_cast<double>(t) / takes, "generating dances")) break;
    const double tempo = options.tempo_bpm > 0 ? options.tempo_bpm : random.uniform(160, 190);
    const double phrase_s = beats_per_phrase * 60 / tempo;
    const int phrases = static_cast<int>(std::lround(left_s / (takes - t) / phrase_s));
    if (phrases < 1 && !dances.empty()) continue;
    dances.push_back(
        dance_take(fmt::format("salsa_{:02}", t + 1), std::max(1, phrases), tempo, options, random));
    left_s -= dances.back().a.duration_s();
  }
  return dances;
}

}  // namespace abrazo
