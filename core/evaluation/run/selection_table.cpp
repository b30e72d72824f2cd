#include "core/evaluation/run/selection_table.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "core/base/parallel.hpp"
#include "core/base/statistics.hpp"
#include "core/evaluation/run/elapsed.hpp"
#include "core/evaluation/takes/pose_queries.hpp"

namespace abrazo {

namespace {

constexpr int smallest_k = 5, largest_k = 50, k_step = 5;  // of the paper's Table I
constexpr double paper_rate_hz = 15;

/// Queries of one take and the pairs in which they are searched.
struct TakeQueries {
  std::string take;
  std::vector<SelectionQuery> queries;
};

/// The two pairs whose active pose is nearest to the query's, by comparing with all (M_B with the pose term).
struct BestTwo {
  std::array<int, 2> pair{-1, -1};
  std::array<double, 2> cost{std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};

  void consider(int candidate, double c) {
    if (c < cost[0]) {
      pair = {candidate, pair[0]};
      cost = {c, cost[0]};
    } else if (c < cost[1]) {
      pair[1] = candidate;
      cost[1] = c;
    }
  }
};

double pose_term(const SelectionQuery& query, const MotionLibrary& library, int pair) {
  return (query.normalized - library.pose(pair).topRows<joint_count>()).squaredNorm();
}

/// What is added up over the queries for one k.
struct RecallCount {
  int best = 0, best2 = 0;
  double excess = 0;
  std::vector<double> times_us;
};

/// Frames drawn from all takes, from each in proportion to its number of frames.
Result<std::vector<TakeQueries>> draw_queries(const std::vector<const PairedTake*>& takes,
                                              const PoseQueries& queries, int count, unsigned seed) {
  std::vector<std::pair<const PairedTake*, int>> frames;
  for (const PairedTake* take : takes)
    for (int frame = 0; frame < static_cast<int>(take->a.poses.size()); ++frame)
      frames.emplace_back(take, frame);
  std::mt19937_64 random(seed);
  std::map<const PairedTake*, std::vector<int>> drawn;
  for (int i = 0; i < count; ++i) {
    const auto& [take, frame] = frames[random() % frames.size()];
    drawn[take].push_back(frame);
  }
  std::vector<TakeQueries> result;
  for (const PairedTake* take : takes) {
    if (drawn[take].empty()) continue;
    auto made = queries.of(*take, drawn[take]);
    if (!made) return made.error();
    result.push_back({take->name, std::move(*made)});
  }
  return result;
}

void count_recall(const SelectionQuery& query, const BestTwo& best, const MotionLibrary& library,
                  const std::vector<Candidate>& candidates, RecallCount& count) {
  bool has_best = false, has_second = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates) {
    // Poses may be equal to the bit (a held frame): any of them is the best.
    const double cost = pose_term(query, library, candidate.pair);
    has_best |= cost <= best.cost[0];
    has_second |= cost <= best.cost[1];
    nearest = std::min(nearest, cost);
  }
  count.best += has_best;
  count.best2 += has_best || has_second;
  count.excess += best.cost[0] > 0 ? std::sqrt(nearest / best.cost[0]) - 1 : 0;
}

/// @return false when cancelled
bool search_take(const TakeQueries& of_take, const std::shared_ptr<const MotionLibrary>& library,
                 const std::vector<int>& pairs, std::map<int, RecallCount>& counts,
                 const Progress& progress) {
  std::vector<BestTwo> best(of_take.queries.size());
  const bool finished =
      for_each_row(best.size(), 4, progress, "comparing with every pair", [&](std::size_t q) {
        for (const int pair : pairs) best[q].consider(pair, pose_term(of_take.queries[q], *library, pair));
      });
  if (!finished) return false;
  PairSelector selector(library, pairs);
  std::vector<Candidate> candidates;
  for (std::size_t q = 0; q < best.size(); ++q) {
    SelectionQuery query = of_take.queries[q];
    for (int k = smallest_k; k <= largest_k; k += k_step) {
      query.neighbours = k;
      const auto begin = std::chrono::steady_clock::now();
      selector.select(query, candidates);
      counts[k].times_us.push_back(elapsed_us(begin));
      count_recall(query, best[q], *library, candidates, counts[k]);
    }
  }
  return true;
}

SelectionTable as_table(const std::map<int, RecallCount>& counts, int queries) {
  SelectionTable table;
  table.queries = queries;
  for (const auto& [k, count] : counts)
    table.rows.push_back({.k = k,
                          .recall_best = static_cast<double>(count.best) / queries,
                          .recall_best2 = static_cast<double>(count.best2) / queries,
                          .pose_excess = count.excess / queries,
                          .query_us = percentile(count.times_us, 0.5)});
  return table;
}

}  // namespace

Result<std::vector<SelectionTable>> measure_selection(const EvaluationData& data,
                                                      const EvaluationOptions& options,
                                                      const Progress& progress) {
  const auto takes = answered_takes(data, options);
  if (!takes) return takes.error();
  const auto library = library_for(data.library, options.settings.user_role);
  const auto drawn = draw_queries(*takes, PoseQueries(*library, options.settings.user_role, data.both_roles),
                                  options.queries, options.seed);
  if (!drawn) return drawn.error();
  std::vector<SelectionTable> tables;
  double done = 0;
  for (const double rate_hz : {0.0, paper_rate_hz}) {
    std::map<int, RecallCount> counts;
    double pairs_searched = 0;
    for (const TakeQueries& of_take : *drawn) {
      const std::vector<int> pairs =
          pairs_without(*library, data.users.empty() ? of_take.take : std::string(), rate_hz);
      if (pairs.empty())
        return Error{"no other take is left to search; a manifest needs at least two",
                     "take " + of_take.take};
      const double share = 0.5 / static_cast<double>(drawn->size());
      if (!search_take(of_take, library, pairs, counts, part(progress, done, done + share)))
        return Error{"cancelled", data.name};
      done += share;
      pairs_searched += static_cast<double>(pairs.size() * of_take.queries.size());
    }
    SelectionTable& table = tables.emplace_back(as_table(counts, options.queries));
    table.rate_hz = rate_hz > 0 ? rate_hz : library->rate_hz();
    table.pairs = static_cast<int>(std::lround(pairs_searched / options.queries));
  }
  return tables;
}

}  // namespace abrazo
