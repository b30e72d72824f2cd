#include "core/choreography/fight.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/choreography/fight_score.hpp"

namespace abrazo {
namespace {

/// Roles and labels of the blows, with guard between them.
void describe(const FightScore& score, int frames, PairedTake& take) {
  const auto frame_of = [&](double time) {
    return std::min(frames, static_cast<int>(std::lround(time * take.fps)));
  };
  const auto guard = [&](int start, int end) {
    if (end > start)
      take.labels.push_back(
          {.start = start, .end = end, .label = "guard", .detail = "", .confidence = "high"});
  };
  int done = 0;
  for (const Blow& blow : score.blows()) {
    const int start = frame_of(blow.from), end = frame_of(blow.until);
    const ActivePerformer active = blow.by_a ? ActivePerformer::A : ActivePerformer::B;
    guard(done, start);
    take.labels.push_back({.start = start,
                           .end = end,
                           .label = std::string(label_of(blow.attack.technique, blow.attack.defence)),
                           .detail = fmt::format("{}; {}; {} attacks", name_of(blow.attack.technique),
                                                 name_of(blow.attack.defence), blow.by_a ? 'a' : 'b'),
                           .confidence = "high"});
    if (take.roles.empty() || take.roles.back().active != active) take.roles.push_back({done, end, active});
    take.roles.back().end = end;
    done = end;
  }
  guard(done, frames);
  take.roles.back().end = frames;
}

PairedTake fight_take(const std::string& name, double seconds, bool a_attacks_first,
                      const ChoreographyOptions& options, RandomSource& random) {
  const double size = (options.a.height_m + options.b.height_m) / 3.5;
  const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  const Vec3 half = 0.5 * size * random.uniform(1.22, 1.42) * forward_of(heading);
  Fighter a(leader_body(options.a), options.a.performance, {-half, heading}, seconds, random);
  Fighter b(follower_body(options.b), options.b.performance, {half, heading + std::numbers::pi}, seconds,
            random);
  const FightScore score(a, b, seconds, options.pace, a_attacks_first, random);
  PairedTake take{.name = name, .fps = options.fps, .a = {}, .b = {}, .roles = {}, .labels = {}};
  const int frames = static_cast<int>(std::lround(score.seconds() * options.fps));
  for (Clip* clip : {&take.a, &take.b}) {
    clip->name = name + (clip == &take.a ? "_a" : "_b");
    clip->fps = options.fps;
    const Fighter& fighter = clip == &take.a ? a : b;
    for (int f = 0; f < frames; ++f) clip->poses.push_back(fighter.pose(f / options.fps));
  }
  describe(score, frames, take);
  return take;
}

}  // namespace

std::vector<PairedTake> generate_fight(const ChoreographyOptions& options, const Progress& progress) {
  check_options(options);
  if (!(options.pace >= 0.5 && options.pace <= 1.5))
    throw std::invalid_argument(fmt::format(
        "choreography options: the pace of a fight must be between 0.5 and 1.5, not {}", options.pace));
  const double seconds = 60 * options.minutes;
  const int takes = std::max(1, static_cast<int>(std::lround(seconds / options.take_seconds)));
  RandomSource random(options.seed);
  std::vector<PairedTake> fights;
  fights.reserve(static_cast<std::size_t>(takes));
  for (int t = 0; t < takes; ++t) {
    if (!report(progress, static_cast<double>(t) / takes, "generating fights")) break;
    fights.push_back(
        fight_take(fmt::format("fight_{:02}", t + 1), seconds / takes, t % 2 == 0, options, random));
  }
  return fights;
}

}  // namespace abrazo
