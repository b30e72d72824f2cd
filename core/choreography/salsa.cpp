#include "core/choreography/salsa.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/choreography/couple_holds.hpp"
#include "core/choreography/couple_path.hpp"
#include "core/choreography/dancer_score.hpp"
#include "core/motion/joint_set.hpp"

namespace abrazo {
namespace {

constexpr double label_lead = 0.5;  ///< a phrase's motion begins with the swing before its count 1 [beats]

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

/// Never below the given values, and smooth: the largest around each frame, averaged over as many frames
/// (Hann window).
std::vector<double> smooth_cover(const std::vector<double>& values, int half_width) {
  const int count = static_cast<int>(values.size());
  const auto around = [&](const std::vector<double>& of, int i) {
    return of[static_cast<std::size_t>(std::clamp(i, 0, count - 1))];
  };
  std::vector<double> highest(values.size()), smooth(values.size());
  for (int i = 0; i < count; ++i)
    for (int k = -half_width; k <= half_width; ++k)
      highest[static_cast<std::size_t>(i)] =
          std::max(highest[static_cast<std::size_t>(i)], around(values, i + k));
  for (int i = 0; i < count; ++i) {
    double sum = 0, weights = 0;
    for (int k = -half_width; k <= half_width; ++k) {
      const double weight = 1 + std::cos(std::numbers::pi * k / (half_width + 1));
      sum += weight * around(highest, i + k);
      weights += weight;
    }
    smooth[static_cast<std::size_t>(i)] = sum / weights;
  }
  return smooth;
}

/// One dancer's frames while they are put together.
struct Dancer {
  DancerBody body;
  DancerScore score;
  std::vector<TrunkPosture> trunks;
  std::vector<FootPosture> left_feet, right_feet;
  std::vector<Pose> poses;

  void dance_legs_and_trunk(const std::vector<double>& beats, const std::vector<double>& gaze_yaws,
                            int half_width);
};

void Dancer::dance_legs_and_trunk(const std::vector<double>& beats, const std::vector<double>& gaze_yaws,
                                  int half_width) {
  std::vector<double> lower;
  for (std::size_t f = 0; f < beats.size(); ++f) {
    trunks.push_back(score.trunk(beats[f], gaze_yaws[f]));
    left_feet.push_back(score.foot(Side::Left, beats[f]));
    right_feet.push_back(score.foot(Side::Right, beats[f]));
    place_trunk(body, trunks[f], poses.emplace_back(Pose::Zero()));
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
                           .label = std::string(label_of(phrases[p + 1].move)),
                           .detail = "",
                           .confidence = "high"});
  return take;
}

PairedTake dance_take(const std::string& name, int phrase_count, const ChoreographyOptions& options,
                      RandomSource& random) {
  // A phrase before and one after are danced too and cut off, so that a take begins and ends in full motion.
  std::vector<SalsaPhrase> phrases = draw_phrases(phrase_count + 2, random);
  const double size =
      (options.leader_height_m + options.follower_height_m) / 3.46;  // drawn for 1.80 m and 1.66 m
  for (SalsaPhrase& phrase : phrases) phrase.step *= size, phrase.distance *= size;
  const CouplePath path(phrases);
  const DancerBody his = leader_body(options.leader_height_m),
                   hers = follower_body(options.follower_height_m);
  Dancer leader{his, DancerScore(DanceRole::Leader, his, phrases, path), {}, {}, {}, {}};
  Dancer follower{hers, DancerScore(DanceRole::Follower, hers, phrases, path), {}, {}, {}, {}};
  const CoupleHolds holds(phrases);

  const double beats_per_frame = options.tempo_bpm / 60 / options.fps;
  const double lag = random.uniform(0.05, 0.15);  // she answers his lead a little later [beats]
  std::vector<int> starts;
  for (int p = 0; p <= phrase_count; ++p)
    starts.push_back(static_cast<int>(std::lround(beats_per_phrase * p / beats_per_frame)));
  std::vector<double> beats, her_beats, his_gaze, her_gaze;
  for (int f = 0; f < starts.back(); ++f) {
    beats.push_back(beats_per_phrase - label_lead + f * beats_per_frame);
    her_beats.push_back(beats.back() - lag);
    his_gaze.push_back(gaze(path.leader(beats.back()), path.follower(beats.back())));
    her_gaze.push_back(gaze(path.follower(beats.back()), path.leader(beats.back())));
  }
  const int half_width = static_cast<int>(std::lround(0.2 * options.fps));
  leader.dance_legs_and_trunk(beats, his_gaze, half_width);
  follower.dance_legs_and_trunk(her_beats, her_gaze, half_width);
  for (std::size_t f = 0; f < beats.size(); ++f)
    holds.place_arms(beats[f], {leader.body, leader.trunks[f].chest, leader.poses[f]},
                     {follower.body, follower.trunks[f].chest, follower.poses[f]});

  return described(name, options.fps, std::move(leader.poses), std::move(follower.poses), phrases, starts);
}

void check(const ChoreographyOptions& options) {
  const auto require = [](bool fine, const char* what) {
    if (!fine) throw std::invalid_argument(std::string("generate_salsa: ") + what);
  };
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  require(positive(options.minutes) && positive(options.take_seconds), "durations must be positive");
  require(positive(options.fps) && positive(options.tempo_bpm), "frame rate and tempo must be positive");
  for (const double height : {options.leader_height_m, options.follower_height_m})
    require(height >= 1.4 && height <= 2.2, "heights must be between 1.4 and 2.2 m");
}

}  // namespace

std::vector<PairedTake> generate_salsa(const ChoreographyOptions& options) {
  check(options);
  const double phrase_s = beats_per_phrase * 60 / options.tempo_bpm;
  const int phrases = std::max(1, static_cast<int>(std::lround(options.minutes * 60 / phrase_s)));
  const int takes =
      std::clamp(static_cast<int>(std::lround(options.minutes * 60 / options.take_seconds)), 1, phrases);
  RandomSource random(options.seed);
  std::vector<PairedTake> dances;
  for (int t = 0; t < takes; ++t) {
    const int count = phrases * (t + 1) / takes - phrases * t / takes;
    dances.push_back(dance_take(fmt::format("salsa_{:02}", t + 1), count, options, random));
  }
  return dances;
}

}  // namespace abrazo
