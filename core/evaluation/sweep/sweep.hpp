#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/evaluation/sweep/sweep_axis.hpp"
#include "core/evaluation/sweep/sweep_metric.hpp"
#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo {

/// A grid over two settings, each point one evaluation.
struct Sweep {
  std::string data;   ///< what is evaluated: manifest, users, takes; distinguishes sweeps
  Settings settings;  ///< those that are not swept
  SweepAxis x, y;
  std::string metric;  ///< path in report.json: "moves.rate"; the drawn figure; every point has all figures
};

/// Checks that the axes differ and that the metric exists.
Status check_sweep(const Sweep& sweep);

int point_count(const Sweep& sweep);
/// Column and row of a point, from 0; points run along x first.
std::pair<int, int> grid_place(const Sweep& sweep, int point);
Settings settings_at(const Sweep& sweep, int point);

/// One of `count` independent processes, from 1. It evaluates every count-th point.
struct SweepShard {
  int index = 1, count = 1;
};
/// "2/8".
Result<SweepShard> parse_sweep_shard(std::string_view text);
std::vector<int> points_of(const Sweep& sweep, const SweepShard& shard);
/// "shard-2-of-8.json".
std::string shard_file_name(const SweepShard& shard);

/// Evaluates one point.
using SweepEvaluator = std::function<Result<Evaluation>(const Settings&, const Progress&)>;

/// Called for each finished point with its figures, or with the reason if it has none. @return false to skip
/// the rest
using SweepListener = std::function<bool(int point, const Result<Figures>& figures)>;

/// Evaluates these points in the order given and writes nothing. A failed point does not
/// affect the others.
/// @return an Error "cancelled" if `progress` or the listener cancels
Status evaluate_points(const Sweep& sweep, std::span<const int> points, const SweepEvaluator& evaluate,
                       const SweepListener& listener, const Progress& progress);

/// All points of a grid so that its corners come first and the gaps between them are filled evenly: the shape
/// of the map shows early.
std::vector<int> coarse_first(const Sweep& sweep);

/// State of a folder of shards.
struct SweepOutcome {
  Sweep sweep;
  bool was_there = false;    ///< the shard was evaluated before
  std::vector<int> missing;  ///< shards that have not been written yet
  int shard_count = 1;
  std::optional<int> best;      ///< point with the best value of the metric, if nothing is missing
  std::vector<Figures> points;  ///< figures of every point, if nothing is missing
};

/// Data for the reports, from figures that were collected without files.
/// @param points  one per point of the grid; empty where there is no figure
SweepOutcome sweep_outcome(const Sweep& sweep, std::vector<Figures> points);

/// Evaluates the shard unless its file exists, and writes it; after the last shard also
/// sweep.json and sweep.html. Files appear complete or not at all. A file in `folder` that belongs to another
/// sweep is an Error that states the difference, before anything is evaluated.
Result<SweepOutcome> run_sweep(const Sweep& sweep, const SweepShard& shard,
                               const std::filesystem::path& folder, const SweepEvaluator& evaluate,
                               const Progress& progress);

/// Reads the shards in `folder` and draws them, if none is missing.
/// @param metric  empty: that of the shards. Any other works as well: each point has all figures.
Result<SweepOutcome> merge_sweep(const std::filesystem::path& folder, std::string_view metric);

}  // namespace abrazo
