#include "evaluation_takes.hpp"

#include "core/library/build/motion_library_builder.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::test {

EvaluationData three_takes() {
  EvaluationData data;
  data.name = "three takes";
  data.takes = {swinging_take("first", 150, 1), swinging_take("second", 120, 2),
                swinging_take("third", 90, 3)};
  auto library = build_library(data.name, data.takes, {}, {});
  data.library = std::make_shared<const MotionLibrary>(std::move(*library));
  return data;
}

SynthesisedTake answered(const PairedTake& take, const std::vector<int>& pairs, const Vec3& partner_offset) {
  SynthesisedTake answer;
  answer.take = &take;
  answer.rate_hz = take.fps;
  for (std::size_t frame = 0; frame < pairs.size(); ++frame) {
    PairPose pair;
    pair << take.a.poses[frame], take.b.poses[frame];
    answer.selected.push_back(pair);
    pair.bottomRows<joint_count>().rowwise() += partner_offset.transpose();
    answer.results.push_back(pair);
    answer.frames.push_back(static_cast<int>(frame));
    answer.pairs.push_back(pairs[frame]);
    answer.source_changed.push_back(0);
    answer.follows.push_back(frame > 0);
    answer.times_s.push_back(static_cast<double>(frame) / take.fps);
    answer.sources.push_back({.take = 0, .time_s = answer.times_s.back()});
    answer.locked_feet.push_back({});
    answer.step_us.push_back(100);
  }
  return answer;
}

std::vector<int> own_pairs(const MotionLibrary& library, const PairedTake& take) {
  std::vector<int> pairs;
  for (int frame = 0; frame < static_cast<int>(take.a.poses.size()); ++frame)
    pairs.push_back(library.find_pair(take.name, frame, false));
  return pairs;
}

}  // namespace abrazo::test
