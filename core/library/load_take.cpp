#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>

#include "core/base/atomic_file.hpp"
#include "core/library/manifest.hpp"
#include "core/motion/import_clip.hpp"

namespace abrazo {

namespace {

void add_warnings(const ImportReport& report, const std::string& file, std::vector<std::string>& warnings) {
  for (const ImportWarning& warning : report.warnings) {
    const std::string line = warning.line > 0 ? fmt::format(":{}", warning.line) : "";
    warnings.push_back(fmt::format("{}{}: {}", file, line, warning.detail));
  }
}

/// The clips of a file, with the readers' warnings appended.
Result<std::vector<ImportedClip>> load_clips(const Manifest::Take& take, const Manifest::Performer& performer,
                                             std::vector<std::string>& warnings) {
  ImportOptions options;
  options.fps = take.fps;
  options.metres_per_unit = take.metres_per_unit;
  auto clips = load_motion(performer.motion.string(), performer.skeleton.string(), options);
  if (!clips) return clips.error();
  for (const ImportedClip& clip : *clips) add_warnings(clip.report, performer.motion.string(), warnings);
  return clips;
}

Result<Clip> load_single(const Manifest::Take& take, const Manifest::Performer& performer,
                         std::vector<std::string>& warnings) {
  auto clips = load_clips(take, performer, warnings);
  if (!clips) return clips.error();
  if (clips->size() != 1)
    return Error{
        fmt::format("shows {} performers; expected one (name the same file for a and b when it shows both)",
                    clips->size()),
        performer.motion.string()};
  return std::move(clips->front().clip);
}

/// Both performers, from two files or from one that shows both.
Status load_performers(const Manifest::Take& take, PairedTake& result, std::vector<std::string>& warnings) {
  if (take.a.motion == take.b.motion) {
    auto clips = load_clips(take, take.a, warnings);
    if (!clips) return clips.error();
    if (clips->size() != 2)
      return Error{fmt::format("is named for both performers of take {} but shows {}; expected 2", take.name,
                               clips->size()),
                   take.a.motion.string()};
    result.a = std::move((*clips)[0].clip);
    result.b = std::move((*clips)[1].clip);
    return Done{};
  }
  auto a = load_single(take, take.a, warnings);
  if (!a) return a.error();
  auto b = load_single(take, take.b, warnings);
  if (!b) return b.error();
  result.a = std::move(*a);
  result.b = std::move(*b);
  return Done{};
}

Status check_lengths(const PairedTake& take) {
  const auto a = static_cast<long long>(take.a.poses.size());
  const auto b = static_cast<long long>(take.b.poses.size());
  if (a != b)
    return Error{fmt::format("performer a has {} frames and b {}, {} {}; both must have been captured "
                             "together, frame for frame",
                             a, b, std::abs(a - b), a > b ? "fewer" : "more"),
                 "take " + take.name};
  if (std::abs(take.a.fps - take.b.fps) > 1e-3 * take.a.fps)
    return Error{fmt::format("performer a has {} frames per second and b {}; give the take's own in \"fps\"",
                             take.a.fps, take.b.fps),
                 "take " + take.name};
  return Done{};
}

template <typename Interval>
void warn_of_late_end(const std::vector<Interval>& intervals, const char* what, const PairedTake& take,
                      std::vector<std::string>& warnings) {
  const auto frames = static_cast<int>(take.a.poses.size());
  if (!intervals.empty() && intervals.back().end > frames)
    warnings.push_back(fmt::format("take {}: its {} go on to frame {}, it has {}", take.name, what,
                                   intervals.back().end, frames));
}

Status load_labels(const Manifest::Take& take, PairedTake& result, std::vector<std::string>& warnings) {
  if (take.labels.empty()) return Done{};
  const auto text = read_whole_file(take.labels);
  if (!text) return text.error();
  auto labels = parse_labels(*text, take.name, take.labels.string());
  if (!labels) return labels.error();
  result.labels = std::move(*labels);
  if (result.labels.empty())
    warnings.push_back(fmt::format("{}: no labels of take {}", take.labels.string(), take.name));
  warn_of_late_end(result.labels, "labels", result, warnings);
  return Done{};
}

}  // namespace

Result<PairedTake> load_take(const Manifest::Take& take, std::vector<std::string>& warnings) {
  PairedTake result;
  result.name = take.name;
  if (const Status loaded = load_performers(take, result, warnings); !loaded) return loaded.error();
  if (const Status lengths = check_lengths(result); !lengths) return lengths.error();
  result.fps = result.a.fps;
  result.roles = take.roles;
  // One letter for the whole take comes without its length.
  for (RoleInterval& role : result.roles)
    if (role.end == INT_MAX) role.end = static_cast<int>(result.a.poses.size());
  warn_of_late_end(result.roles, "roles", result, warnings);
  if (const Status labels = load_labels(take, result, warnings); !labels) return labels.error();
  return result;
}

}  // namespace abrazo
