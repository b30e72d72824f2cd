#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "core/base/statistics.hpp"
#include "core/choreography/salsa.hpp"
#include "core/evaluation/run/elapsed.hpp"
#include "core/evaluation/run/selection_table.hpp"
#include "core/evaluation/takes/pose_queries.hpp"

namespace abrazo {

namespace {

constexpr std::array<int, 6> usual_sizes = {7'500, 15'000, 30'000, 100'000, 300'000, 1'000'000};
constexpr int query_count = 200;
constexpr double compared_pairs = 6e6;  ///< by brute force for each size, in whole queries, at least 5

/// Pairs without meshes, as many as wanted: those of a library in random order, then generated dances. All
/// count as frames of one long take: only the poses matter here.
class GrowingLibrary {
 public:
  GrowingLibrary(const MotionLibrary& library, const std::vector<int>& pairs, std::size_t most,
                 std::uint64_t seed) {
    columns_.name = library.name();
    columns_.rate_hz = library.rate_hz();
    columns_.bodies = library.bodies();
    std::vector<int> order = pairs;
    std::mt19937_64 random(seed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    order.resize(std::min(order.size(), most));
    for (const int pair : order) add(library.root(pair), library.pose(pair), library.features(pair));
  }

  /// Generated dances of other couples, until there are `count` pairs. @return false when cancelled
  bool fill(std::size_t count, const Progress& progress) {
    for (std::uint64_t seed = 1; columns_.sources.size() < count; ++seed) {
      const double fraction = static_cast<double>(columns_.sources.size()) / static_cast<double>(count);
      if (!report(progress, fraction, "generating dances")) return false;
      ChoreographyOptions options;
      options.seed = seed;
      options.minutes = 5;
      options.a.height_m = 1.65 + 0.02 * static_cast<double>(seed % 13);
      options.b.height_m = 1.55 + 0.02 * static_cast<double>(seed % 11);
      for (const PairedTake& take : generate_salsa(options)) add(take, count);
    }
    return true;
  }

  std::shared_ptr<const MotionLibrary> finish() && {
    columns_.takes = {{.name = "searched",
                       .fps = columns_.rate_hz,
                       .frames = static_cast<int>(columns_.sources.size()),
                       .roles = {},
                       .labels = {}}};
    columns_.edge_offsets.assign(columns_.sources.size() + 1, 0);
    columns_.tetrahedron_offsets.assign(columns_.sources.size() + 1, 0);
    columns_.mesh_quality.assign(columns_.sources.size(), 0);
    return std::make_shared<const MotionLibrary>(std::move(columns_));
  }

 private:
  void add(const RootFrame& root, const PairPose& pose, const Features& features) {
    columns_.sources.push_back({.frame = static_cast<std::uint32_t>(columns_.sources.size())});
    columns_.roots.push_back(root);
    columns_.poses.push_back(pose);
    columns_.features.push_back(features);
  }

  void add(const PairedTake& take, std::size_t most) {
    for (std::size_t f = 0; f < take.a.poses.size() && columns_.sources.size() < most; ++f) {
      const RootFrame root = root_frame(take.a.poses[f]);
      PairPose pose;
      pose << to_normalized(take.a.poses[f], root), to_normalized(take.b.poses[f], root);
      add(root, pose, pose_features(pose.topRows<joint_count>()));
    }
  }

  LibraryColumns columns_;
};

std::vector<int> first_pairs(int count) {
  std::vector<int> pairs(static_cast<std::size_t>(count));
  for (int pair = 0; pair < count; ++pair) pairs[static_cast<std::size_t>(pair)] = pair;
  return pairs;
}

/// M_A: the nearest in feature space, then Eq. 7 over them.
double knn_us(const std::shared_ptr<const MotionLibrary>& library, const std::vector<int>& pairs,
              const std::vector<SelectionQuery>& queries) {
  PairSelector selector(library, pairs);
  std::vector<Candidate> candidates;
  std::vector<double> times_us;
  for (int round = 0; round < 2; ++round) {  // the first warms the caches
    times_us.clear();
    for (const SelectionQuery& query : queries) {
      const auto begin = std::chrono::steady_clock::now();
      selector.select(query, candidates);
      times_us.push_back(elapsed_us(begin));
    }
  }
  return percentile(times_us, 0.5);
}

/// M_B: Eq. 7 over every pair.
double brute_us(const MotionLibrary& library, const std::vector<int>& pairs,
                const std::vector<SelectionQuery>& queries) {
  const auto wanted = static_cast<std::size_t>(std::clamp(compared_pairs / static_cast<double>(pairs.size()),
                                                          5.0, static_cast<double>(queries.size())));
  std::vector<double> times_us;
  double cheapest = std::numeric_limits<double>::infinity();
  for (std::size_t q = 0; q < std::min(wanted, queries.size()); ++q) {
    const auto begin = std::chrono::steady_clock::now();
    for (const int pair : pairs)
      cheapest = std::min(
          cheapest,
          pair_cost(queries[q], library.pose(pair), library.pair_in_world(pair, queries[q].root)).total);
    times_us.push_back(elapsed_us(begin));
  }
  // A minimum that is used cannot be optimised away.
  return std::isfinite(cheapest) ? percentile(times_us, 0.5) : 0;
}

/// The usual sizes below the largest, and the largest.
std::vector<int> sizes_up_to(int largest) {
  std::vector<int> sizes;
  for (const int size : usual_sizes)
    if (size < largest) sizes.push_back(size);
  sizes.push_back(largest);
  return sizes;
}

std::vector<int> spread_frames(const PairedTake& take, int count) {
  const auto frames = static_cast<int>(take.a.poses.size());
  std::vector<int> spread;
  for (int i = 0; i < std::min(count, frames); ++i) spread.push_back(frames * i / std::min(count, frames));
  return spread;
}

}  // namespace

Result<std::vector<TimingRow>> measure_timing(const EvaluationData& data, const EvaluationOptions& options,
                                              const Progress& progress) {
  const auto takes = answered_takes(data, options);
  if (!takes) return takes.error();
  const PairedTake& longest = **std::max_element(
      takes->begin(), takes->end(),
      [](const PairedTake* a, const PairedTake* b) { return a->a.poses.size() < b->a.poses.size(); });
  const auto own = library_for(data.library, options.settings.user_role);
  const auto queries = PoseQueries(*own, options.settings.user_role, data.both_roles)
                           .of(longest, spread_frames(longest, query_count));
  if (!queries) return queries.error();
  const std::vector<int> pairs = pairs_without(*own, data.users.empty() ? longest.name : std::string(), 0);
  const auto most = static_cast<std::size_t>(options.largest_library);
  GrowingLibrary growing(*own, pairs, most, options.seed);
  if (!growing.fill(most, part(progress, 0, 0.6))) return Error{"cancelled", data.name};
  const auto library = std::move(growing).finish();

  std::vector<TimingRow> rows;
  const std::vector<int> sizes = sizes_up_to(options.largest_library);
  for (const int size : sizes) {
    const std::vector<int> searched = first_pairs(size);
    const double fraction = 0.6 + 0.4 * static_cast<double>(rows.size()) / static_cast<double>(sizes.size());
    if (!report(progress, fraction, fmt::format("searching {} pairs", size)))
      return Error{"cancelled", data.name};
    rows.push_back({.pairs = size,
                    .generated = std::max(0, size - static_cast<int>(pairs.size())),
                    .knn_us = knn_us(library, searched, *queries),
                    .brute_us = brute_us(*library, searched, *queries)});
  }
  return rows;
}

}  // namespace abrazo
