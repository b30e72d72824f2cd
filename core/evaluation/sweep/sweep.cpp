#include "core/evaluation/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/evaluation/sweep/sweep_file.hpp"
#include "core/evaluation/sweep/sweep_report.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

std::string point_name(const Sweep& sweep, int point) {
  const auto [x, y] = grid_place(sweep, point);
  return fmt::format("{} = {}, {} = {}", sweep.x.key, sweep.x.values[static_cast<std::size_t>(x)],
                     sweep.y.key, sweep.y.values[static_cast<std::size_t>(y)]);
}

/// The same sweep in the same number of shards, each in the file of its name.
Status check_files(const Sweep& sweep, int shard_count, const fs::path& folder,
                   const std::vector<SweepShardFile>& files) {
  for (const SweepShardFile& file : files) {
    const std::string place = (folder / file.name).string();
    if (const std::string what = difference(sweep, file.sweep); !what.empty())
      return Error{"belongs to another sweep: " + what + "; choose another folder or remove the file", place};
    if (file.shard.count != shard_count)
      return Error{
          fmt::format("is one of {} shards, not of {}; use the same number of shards, or remove the file",
                      file.shard.count, shard_count),
          place};
    if (file.name != shard_file_name(file.shard))
      return Error{fmt::format("is shard {} of {} under another name; remove it or name it {}",
                               file.shard.index, file.shard.count, shard_file_name(file.shard)),
                   place};
  }
  return Done{};
}

/// The points of a shard: one that has no figures, or lacks the metric, makes the shard an Error.
Result<std::vector<Figures>> evaluate_all(const Sweep& sweep, const std::vector<int>& points,
                                          const SweepEvaluator& evaluate, const Progress& progress) {
  std::vector<Figures> all;
  std::optional<Error> failure;
  const auto listener = [&](int point, const Result<Figures>& figures) {
    if (!figures)
      failure = figures.error();
    else if (!figures->contains(sweep.metric))
      failure = Error{
          fmt::format("{} has no value here; for a success rate the takes need labelled moves", sweep.metric),
          point_name(sweep, point)};
    else
      all.push_back(*figures);
    return !failure;
  };
  const Status done = evaluate_points(sweep, points, evaluate, listener, progress);
  if (failure) return *failure;
  if (!done) return done.error();
  return all;
}

SweepOutcome gathered(const Sweep& sweep, int shard_count, const std::vector<SweepShardFile>& files) {
  SweepOutcome outcome{.sweep = sweep, .missing = {}, .shard_count = shard_count, .best = {}, .points = {}};
  std::vector<Figures> points(static_cast<std::size_t>(point_count(sweep)));
  for (int index = 1; index <= shard_count; ++index) {
    const auto file = std::find_if(files.begin(), files.end(),
                                   [index](const SweepShardFile& f) { return f.shard.index == index; });
    if (file == files.end()) {
      outcome.missing.push_back(index);
      continue;
    }
    const std::vector<int> own = points_of(sweep, file->shard);
    for (std::size_t i = 0; i < own.size(); ++i) points[static_cast<std::size_t>(own[i])] = file->points[i];
  }
  if (!outcome.missing.empty()) return outcome;
  outcome.points = std::move(points);
  outcome.best = best_point(sweep, outcome.points);
  return outcome;
}

/// Reads what is in the folder by now and draws it when it is complete.
Result<SweepOutcome> merge(const Sweep& sweep, int shard_count, const fs::path& folder) {
  const auto files = read_shard_files(folder);
  if (!files) return files.error();
  if (const Status fit = check_files(sweep, shard_count, folder, *files); !fit) return fit.error();
  SweepOutcome outcome = gathered(sweep, shard_count, *files);
  if (!outcome.missing.empty()) return outcome;
  if (!outcome.best) return Error{fmt::format("no point has a value of {}", sweep.metric), folder.string()};
  if (const Status written = write_whole_file(folder / "sweep.json", sweep_json(outcome)); !written)
    return written.error();
  if (const Status written = write_whole_file(folder / "sweep.html", sweep_html(outcome)); !written)
    return written.error();
  return outcome;
}

}  // namespace

Status check_sweep(const Sweep& sweep) {
  for (const SweepAxis* axis : {&sweep.x, &sweep.y}) {
    if (axis->values.empty()) return Error{"has no values", axis->key};
    if (find_setting(axis->key) == nullptr) return Error{"is not a setting", axis->key};
    for (const std::string& value : axis->values) {
      Settings scratch;
      if (const Status usable = set_setting(scratch, axis->key, value); !usable) return usable;
    }
  }
  if (sweep.x.key == sweep.y.key)
    return Error{fmt::format("both axes are {}; sweep two different settings", sweep.x.key), "",
                 Hint::SetSweepAxis};
  return check_metric(sweep.metric);
}

int point_count(const Sweep& sweep) {
  return static_cast<int>(sweep.x.values.size() * sweep.y.values.size());
}

std::pair<int, int> grid_place(const Sweep& sweep, int point) {
  const int columns = static_cast<int>(sweep.x.values.size());
  return {point % columns, point / columns};
}

Settings settings_at(const Sweep& sweep, int point) {
  const auto [x, y] = grid_place(sweep, point);
  Settings settings = sweep.settings;
  for (const auto& [axis, index] : {std::pair(&sweep.x, x), std::pair(&sweep.y, y)}) {
    const Status set = set_setting(settings, axis->key, axis->values[static_cast<std::size_t>(index)]);
    if (!set) throw std::invalid_argument(set.error().text());  // check_sweep was to be called
  }
  return settings;
}

Status evaluate_points(const Sweep& sweep, std::span<const int> points, const SweepEvaluator& evaluate,
                       const SweepListener& listener, const Progress& progress) {
  const double share = 1.0 / static_cast<double>(points.size());
  double done = 0;
  for (const int point : points) {
    const std::string name = point_name(sweep, point);
    if (!report(progress, done, name)) return Error{"cancelled", sweep.data};
    const auto evaluation = evaluate(settings_at(sweep, point), part(progress, done, done + share));
    if (!evaluation && evaluation.error().message == "cancelled") return evaluation.error();
    const Result<Figures> figures = evaluation ? Result<Figures>(figures_of(*evaluation))
                                               : Error{evaluation.error().message + " (at " + name + ")",
                                                       evaluation.error().where, evaluation.error().hint};
    if (!listener(point, figures)) return Error{"cancelled", sweep.data};
    done += share;
  }
  return Done{};
}

std::vector<int> coarse_first(const Sweep& sweep) {
  const int columns = static_cast<int>(sweep.x.values.size()), rows = static_cast<int>(sweep.y.values.size());
  std::vector<int> order;
  std::vector<bool> taken(static_cast<std::size_t>(point_count(sweep)), false);
  const auto is_on = [](int place, int count, int stride) {
    return place % stride == 0 || place == count - 1;
  };
  int stride = 1;
  while (stride < std::max(columns, rows)) stride *= 2;
  for (; stride >= 1; stride /= 2)
    for (int point = 0; point < point_count(sweep); ++point) {
      const auto [x, y] = grid_place(sweep, point);
      if (taken[static_cast<std::size_t>(point)] || !is_on(x, columns, stride) || !is_on(y, rows, stride))
        continue;
      taken[static_cast<std::size_t>(point)] = true;
      order.push_back(point);
    }
  return order;
}

SweepOutcome sweep_outcome(const Sweep& sweep, std::vector<Figures> points) {
  if (points.size() != static_cast<std::size_t>(point_count(sweep)))
    throw std::invalid_argument("a grid and its figures must be of one size");
  SweepOutcome outcome{.sweep = sweep, .missing = {}, .best = best_point(sweep, points), .points = {}};
  outcome.points = std::move(points);
  return outcome;
}

Result<SweepShard> parse_sweep_shard(std::string_view text) {
  const auto fields = split_fields(text, '/');
  if (fields.size() == 2) {
    const auto index = parse_integer(fields[0]), count = parse_integer(fields[1]);
    if (index && count && *count >= 1 && *count <= 1'000'000 && *index >= 1 && *index <= *count)
      return SweepShard{static_cast<int>(*index), static_cast<int>(*count)};
  }
  return Error{fmt::format("{} cannot be used: I/N is expected, I from 1 to N, as in 1/8", in_quotes(text)),
               "shard", Hint::SetShard};
}

std::vector<int> points_of(const Sweep& sweep, const SweepShard& shard) {
  std::vector<int> points;
  for (int point = shard.index - 1; point < point_count(sweep); point += shard.count) points.push_back(point);
  return points;
}

std::string shard_file_name(const SweepShard& shard) {
  return fmt::format("shard-{}-of-{}.json", shard.index, shard.count);
}

Result<SweepOutcome> run_sweep(const Sweep& sweep, const SweepShard& shard, const fs::path& folder,
                               const SweepEvaluator& evaluate, const Progress& progress) {
  if (const Status usable = check_sweep(sweep); !usable) return usable.error();
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return Error{"cannot be created: " + failure.message(), folder.string()};
  const auto files = read_shard_files(folder);
  if (!files) return files.error();
  if (const Status fit = check_files(sweep, shard.count, folder, *files); !fit) return fit.error();
  const bool was_there = std::any_of(files->begin(), files->end(), [&](const SweepShardFile& file) {
    return file.shard.index == shard.index;
  });
  if (!was_there) {
    const auto figures = evaluate_all(sweep, points_of(sweep, shard), evaluate, progress);
    if (!figures) return figures.error();
    const Status written =
        write_whole_file(folder / shard_file_name(shard), shard_json(sweep, shard, *figures));
    if (!written) return written.error();
  }
  auto outcome = merge(sweep, shard.count, folder);
  if (outcome) outcome->was_there = was_there;
  return outcome;
}

Result<SweepOutcome> merge_sweep(const fs::path& folder, std::string_view metric) {
  const auto files = read_shard_files(folder);
  if (!files) return files.error();
  if (files->empty())
    return Error{"holds no shards (shard-I-of-N.json); name the folder of a sweep's report", folder.string(),
                 Hint::NameReport};
  Sweep sweep = files->front().sweep;
  if (!metric.empty()) sweep.metric = metric;
  if (const Status usable = check_metric(sweep.metric); !usable) return usable.error();
  return merge(sweep, files->front().shard.count, folder);
}

}  // namespace abrazo
