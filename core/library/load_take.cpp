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

Status set_joint_map(const std::string& name, ImportOptions& options) {
  if (name.empty()) return Done{};
  for (const JointMap& map : builtin_joint_maps())
    if (map.name == name) {
      options.joint_map = map;
      return Done{};
    }
  const auto text = read_whole_file(name);
  if (!text) return text.error();
  auto map = parse_joint_map(*text, name);
  if (!map) return map.error();
  options.joint_map = std::move(*map);
  return Done{};
}

/// The clips of a file, with the readers' warnings appended.
Result<std::vector<ImportedClip>> load_clips(const Manifest::Take& take, const Manifest::Performer& performer,
                                             std::vector<std::string>& warnings) {
  auto options = import_options(performer, take.fps);
  if (!options) return options.error();
  if (!options->metres_per_unit) options->metres_per_unit = take.metres_per_unit;
  auto clips = load_motion(performer.motion.string(), performer.skeleton.string(), *options);
  if (!clips) return clips.error();
  for (const ImportedClip& clip : *clips) add_warnings(clip.report, performer.motion.string(), warnings);
  return clips;
}

/// Moves one performer out of a file's clips and cuts the frames before its start.
Result<Clip> taken_from(std::vector<ImportedClip>& clips, const Manifest::Performer& performer, int index) {
  if (index >= static_cast<int>(clips.size()))
    return Error{
        fmt::format("performer {} is asked for, but it shows {}; they count from 0", index, clips.size()),
        performer.motion.string()};
  Clip clip = std::move(clips[static_cast<std::size_t>(index)].clip);
  if (performer.start >= static_cast<int>(clip.poses.size()))
    return Error{fmt::format("is to be used from frame {} on, but has {}; give a smaller \"start\"",
                             performer.start, clip.poses.size()),
                 performer.motion.string()};
  clip.poses.erase(clip.poses.begin(), clip.poses.begin() + performer.start);
  return clip;
}

Result<Clip> load_single(const Manifest::Take& take, const Manifest::Performer& performer,
                         std::vector<std::string>& warnings) {
  auto clips = load_clips(take, performer, warnings);
  if (!clips) return clips.error();
  if (clips->size() != 1 && !performer.index)
    return Error{fmt::format("shows {} performers; expected one (say which with \"performer\": 0, 1, ..., or "
                             "name the same file for a and b when it shows both)",
                             clips->size()),
                 performer.motion.string()};
  return taken_from(*clips, performer, performer.index.value_or(0));
}

/// Both performers, from two files or from one that shows both.
Status load_performers(const Manifest::Take& take, PairedTake& result, std::vector<std::string>& warnings) {
  Result<Clip> a = Clip{}, b = Clip{};
  if (take.a.motion == take.b.motion) {
    auto clips = load_clips(take, take.a, warnings);
    if (!clips) return clips.error();
    const int index_a = take.a.index.value_or(0), index_b = take.b.index.value_or(1);
    if (clips->size() != 2 && !(take.a.index && take.b.index))
      return Error{fmt::format("is named for both performers of take {} but shows {}; expected 2", take.name,
                               clips->size()),
                   take.a.motion.string()};
    if (index_a == index_b)
      return Error{fmt::format("performer {} is named twice; name another for a or b", index_a),
                   "take " + take.name};
    a = taken_from(*clips, take.a, index_a);
    b = taken_from(*clips, take.b, index_b);
  } else {
    a = load_single(take, take.a, warnings);
    if (a) b = load_single(take, take.b, warnings);
  }
  if (!a) return a.error();
  if (!b) return b.error();
  result.a = std::move(*a);
  result.b = std::move(*b);
  return Done{};
}

/// Leaves the first `frames` of both.
Status cut_to_frames(const Manifest::Take& take, PairedTake& result) {
  if (!take.frames) return Done{};
  for (Clip* clip : {&result.a, &result.b}) {
    if (static_cast<int>(clip->poses.size()) < *take.frames)
      return Error{
          fmt::format("{} frames are to be used, but performer {} has {} from its start on; give fewer "
                      "\"frames\"",
                      *take.frames, clip == &result.a ? "a" : "b", clip->poses.size()),
          "take " + take.name};
    clip->poses.resize(static_cast<std::size_t>(*take.frames));
  }
  return Done{};
}

Status check_lengths(const PairedTake& take) {
  const auto a = static_cast<long long>(take.a.poses.size());
  const auto b = static_cast<long long>(take.b.poses.size());
  if (a != b)
    return Error{
        fmt::format("performer a has {} frames and b {}, {} {}; both must have been captured "
                    "together, frame for frame (\"start\" of a or b and \"frames\" of the take cut them)",
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

Result<ImportOptions> import_options(const Manifest::Performer& performer, std::optional<double> fps) {
  ImportOptions options;
  options.fps = fps;
  options.metres_per_unit = performer.metres_per_unit;
  options.up_axis = performer.up_axis;
  if (const Status map = set_joint_map(performer.joint_map, options); !map) return map.error();
  return options;
}

Result<PairedTake> load_take(const Manifest::Take& take, std::vector<std::string>& warnings) {
  PairedTake result;
  result.name = take.name;
  if (const Status loaded = load_performers(take, result, warnings); !loaded) return loaded.error();
  if (const Status cut = cut_to_frames(take, result); !cut) return cut.error();
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
