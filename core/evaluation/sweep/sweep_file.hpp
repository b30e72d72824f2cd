#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/json_text.hpp"
#include "core/base/result.hpp"
#include "core/evaluation/sweep/sweep.hpp"

namespace abrazo {

/// Content of a shard's file: the sweep, the points of the shard, and their figures.
struct SweepShardFile {
  std::string name;  ///< of the file
  Sweep sweep;
  SweepShard shard;
  std::vector<Figures> points;  ///< in the order of `points_of`
};

/// Common parts of shards and the merged file: the sweep, and a point.
void write_sweep_head(JsonText& json, const Sweep& sweep);
void write_sweep_point(JsonText& json, const Sweep& sweep, int point, const Figures& figures);

std::string shard_json(const Sweep& sweep, const SweepShard& shard, const std::vector<Figures>& points);

/// An Error says what is wrong with the file.
Result<SweepShardFile> read_shard_file(const std::filesystem::path& path);

/// All shard-*.json of a folder, by name.
Result<std::vector<SweepShardFile>> read_shard_files(const std::filesystem::path& folder);

/// How `found` differs from the same sweep: "alpha has the values 0, 1 instead of 0, 0.5, 1"; empty if it
/// does not. The metric may differ.
std::string difference(const Sweep& expected, const Sweep& found);

}  // namespace abrazo
