#include "core/evaluation/takes/pose_queries.hpp"

#include <algorithm>
#include <cmath>

#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/retarget/body_retargeter.hpp"

namespace abrazo {

Result<std::vector<SelectionQuery>> PoseQueries::of(const PairedTake& take,
                                                    const std::vector<int>& frames) const {
  const auto user = user_of(take, role_, both_roles_);
  if (!user) return user.error();
  const bool user_is_a = *user == ActivePerformer::A;
  const Clip& clip = user_is_a ? take.a : take.b;
  const Clip& partner = user_is_a ? take.b : take.a;
  const BodyRetargeter retargeter(body_of(clip.poses), library_.usual_active_body().body);
  std::vector<SelectionQuery> queries;
  for (const int frame : frames) {
    const auto f = static_cast<std::size_t>(frame);
    const Pose world = retargeter.apply(clip.poses[f]);
    SelectionQuery& query = queries.emplace_back();
    query.root = root_frame(world);
    query.normalized = to_normalized(world, query.root);
    query.features = pose_features(query.normalized);
    query.has_prediction = true;
    query.predicted << world, partner.poses[f];
  }
  return queries;
}

std::shared_ptr<const MotionLibrary> library_for(const std::shared_ptr<const MotionLibrary>& library,
                                                 UserRole role) {
  if (role == UserRole::Active) return library;
  return std::make_shared<const MotionLibrary>(with_roles_exchanged(*library));
}

std::vector<int> pairs_without(const MotionLibrary& library, const std::string& take, double rate_hz) {
  const int left_out = library.find_take(take);
  std::vector<int> every;  // n-th frame of each take
  for (const LibraryTake& known : library.takes()) {
    const double pairs_per_s = known.fps / known.frame_stride;
    const int thinning = rate_hz > 0 ? std::max(1, static_cast<int>(std::lround(pairs_per_s / rate_hz))) : 1;
    every.push_back(thinning * known.frame_stride);
  }
  std::vector<int> pairs;
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    if (static_cast<int>(source.take) != left_out && static_cast<int>(source.frame) % every[source.take] == 0)
      pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace abrazo
