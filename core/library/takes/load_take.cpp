#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/library/takes/take_labels.hpp"
#include "core/library/takes/tier_csv.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/motion/files/import_clip.hpp"

namespace abrazo {

namespace {

/// Where a manifest says what a reader asks for.
std::string_view manifest_words(Hint hint) {
  switch (hint) {
    case Hint::NameSkeleton:
      return R"( ("skeleton" of the performer))";
    case Hint::NameJointMap:
      return R"( ("joint_map" of the performer))";
    case Hint::NameJointOrder:
      return R"(, or with "joints" of the performer)";
    case Hint::SetUnit:
      return R"( ("metres_per_unit" of the performer or the take))";
    case Hint::SetFrameRate:
      return R"( ("fps" of the take))";
    default:
      return "";
  }
}

void add_warnings(const ImportReport& report, const std::string& file, std::vector<std::string>& warnings) {
  for (const ImportWarning& warning : report.warnings) {
    const std::string line = warning.line > 0 ? fmt::format(":{}", warning.line) : "";
    warnings.push_back(fmt::format("{}{}: {}{}", file, line, warning.detail, manifest_words(warning.hint)));
  }
}

Result<std::vector<ImportedClip>> load_clips(const Manifest::Take& take, const Manifest::Performer& performer,
                                             const Progress& progress) {
  auto options = import_options(performer, take.fps);
  if (!options) return options.error();
  if (!options->metres_per_unit) options->metres_per_unit = take.metres_per_unit;
  auto clips = load_motion(performer.motion.string(), performer.skeleton.string(), *options, progress);
  if (!clips)
    return Error{clips.error().message + std::string(manifest_words(clips.error().hint)),
                 clips.error().where};
  return clips;
}

/// Moves one performer out of a file's clips.
Result<ImportedClip> taken_from(std::vector<ImportedClip>& clips, const Manifest::Performer& performer,
                                int index) {
  if (index >= static_cast<int>(clips.size()))
    return Error{
        fmt::format("performer {} is requested, but it shows {}; they count from 0", index, clips.size()),
        performer.motion.string()};
  return std::move(clips[static_cast<std::size_t>(index)]);
}

Result<ImportedClip> load_single(const Manifest::Take& take, const Manifest::Performer& performer,
                                 const Progress& progress) {
  auto clips = load_clips(take, performer, progress);
  if (!clips) return clips.error();
  if (clips->size() != 1 && !performer.index)
    return Error{fmt::format("shows {} performers; expected one (say which with \"performer\": 0, 1, ..., or "
                             "name the same file for a and b when it shows both)",
                             clips->size()),
                 performer.motion.string()};
  return taken_from(*clips, performer, performer.index.value_or(0));
}

/// Both performers of one file.
Status load_both(const Manifest::Take& take, ImportedClip& a, ImportedClip& b, const Progress& progress) {
  auto clips = load_clips(take, take.a, progress);
  if (!clips) return clips.error();
  const int index_a = take.a.index.value_or(0), index_b = take.b.index.value_or(1);
  if (clips->size() != 2 && !(take.a.index && take.b.index))
    return Error{fmt::format("is named for both performers of take {} but shows {}; expected 2", take.name,
                             clips->size()),
                 take.a.motion.string()};
  if (index_a == index_b)
    return Error{fmt::format("performer {} is named twice; name another for a or b", index_a),
                 "take " + take.name};
  auto first = taken_from(*clips, take.a, index_a);
  if (!first) return first.error();
  auto second = taken_from(*clips, take.b, index_b);
  if (!second) return second.error();
  a = std::move(*first), b = std::move(*second);
  return Done{};
}

/// Each performer of a file of their own. Where one leaves open its unit or axis, the other's is taken.
Status load_each(const Manifest::Take& take, ImportedClip& a, ImportedClip& b, const Progress& progress) {
  auto first = load_single(take, take.a, progress);
  if (!first) return first.error();
  auto second = load_single(take, take.b, progress);
  if (!second) return second.error();
  for (auto* const both : {&first, &second}) {
    auto& doubtful = *both;
    const ImportReport& other = (both == &first ? second : first)->report;
    const Manifest::Performer& said = both == &first ? take.a : take.b;
    const Manifest::Performer settled = with_space_of(other, doubtful->report, said);
    if (settled.up_axis == said.up_axis && settled.metres_per_unit == said.metres_per_unit) continue;
    doubtful = load_single(take, settled, progress);
    if (!doubtful) return doubtful.error();
  }
  a = std::move(*first), b = std::move(*second);
  return Done{};
}

Status load_performers(const Manifest::Take& take, PairedTake& result, std::vector<std::string>& warnings,
                       const Progress& progress) {
  ImportedClip a, b;
  const bool one_file = take.a.motion == take.b.motion;
  const Status loaded = one_file ? load_both(take, a, b, progress) : load_each(take, a, b, progress);
  if (!loaded) return loaded.error();
  const std::array<ImportedClip*, 2> both = {&a, &b};
  share_floor(both);
  for (const ImportedClip* imported : both) {
    const Manifest::Performer& performer = imported == &a ? take.a : take.b;
    const auto start = performer.start;
    add_warnings(imported->report, performer.motion.string(), warnings);
    std::vector<Pose>& poses = imported == &a ? a.clip.poses : b.clip.poses;
    if (start >= static_cast<int>(poses.size()))
      return Error{fmt::format("is to be used from frame {} on, but has {}; give a smaller \"start\"", start,
                               poses.size()),
                   performer.motion.string()};
    poses.erase(poses.begin(), poses.begin() + start);
  }
  result.a = std::move(a.clip);
  result.b = std::move(b.clip);
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

Result<std::vector<Tier>> tiers_in(const std::filesystem::path& file, const PairedTake& take,
                                   std::vector<std::string>& warnings) {
  auto document = read_tiers(file, {take.fps, take.name});
  if (!document) return document.error();
  for (const std::string& warning : document->warnings) warnings.push_back(file.string() + ": " + warning);
  return std::move(document->tiers);
}

/// Out of a label file in frames, or out of a tier of any other.
Result<std::vector<LabelInterval>> labels_in(const Manifest::Take& take, const PairedTake& result,
                                             std::vector<std::string>& warnings) {
  const std::string where = take.labels.string();
  if (lower_case(take.labels.extension().string()) == ".csv" || !is_tier_file(where)) {
    const auto text = read_whole_file(take.labels);
    if (!text) return text.error();
    if (!is_tier_csv(*text)) return parse_labels(*text, take.name, where);
  }
  const auto tiers = tiers_in(take.labels, result, warnings);
  if (!tiers) return tiers.error();
  const auto tier = tier_for_take(*tiers, take.labels_tier, TierKind::Move, take.name, where);
  if (!tier) return tier.error();
  return labels_of(**tier, result.fps, where, warnings);
}

Status load_labels(const Manifest::Take& take, PairedTake& result, std::vector<std::string>& warnings) {
  if (!take.move.empty()) result.labels = {{0, static_cast<int>(result.a.poses.size()), take.move, "", ""}};
  if (take.labels.empty()) return Done{};
  auto labels = labels_in(take, result, warnings);
  if (!labels) return labels.error();
  result.labels = std::move(*labels);
  if (result.labels.empty())
    warnings.push_back(fmt::format("{}: no labels of take {}", take.labels.string(), take.name));
  warn_of_late_end(result.labels, "labels", result, warnings);
  return Done{};
}

/// The manifest's own, or out of a tier.
Status load_roles(const Manifest::Take& take, PairedTake& result, std::vector<std::string>& warnings) {
  result.roles = take.roles;
  // One letter for the whole take comes without its length.
  for (RoleInterval& role : result.roles)
    if (role.end == INT_MAX) role.end = static_cast<int>(result.a.poses.size());
  if (!take.roles_tier.empty()) {
    const std::filesystem::path& file = take.roles_file.empty() ? take.labels : take.roles_file;
    const auto tiers = tiers_in(file, result, warnings);
    if (!tiers) return tiers.error();
    const auto tier = tier_for_take(*tiers, take.roles_tier, TierKind::Role, take.name, file.string());
    if (!tier) return tier.error();
    auto roles = roles_of(**tier, result.fps, file.string(), warnings);
    if (!roles) return roles.error();
    result.roles = std::move(*roles);
  }
  warn_of_late_end(result.roles, "roles", result, warnings);
  return Done{};
}

}  // namespace

Manifest::Performer with_space_of(const ImportReport& other, const ImportReport& own,
                                  const Manifest::Performer& performer) {
  Manifest::Performer settled = performer;
  if (!settled.up_axis && own.asks_about("up-axis") && !other.asks_about("up-axis"))
    settled.up_axis = other.up_axis;
  if (!settled.metres_per_unit && own.asks_about("units") && !other.asks_about("units"))
    settled.metres_per_unit = other.metres_per_unit;
  return settled;
}

Result<ImportOptions> import_options(const Manifest::Performer& performer, std::optional<double> fps) {
  ImportOptions options;
  options.fps = fps;
  options.metres_per_unit = performer.metres_per_unit;
  options.up_axis = performer.up_axis;
  options.animation = performer.animation;
  options.body_model = performer.body_model.string();
  if (!performer.joints.empty()) {
    auto order = find_joint_order(performer.joints);
    if (!order) return order.error();
    options.joint_order = std::move(*order);
  }
  if (!performer.joint_map.empty())
    if (const Status chosen = choose_joints(performer.joint_map, options); !chosen) return chosen.error();
  return options;
}

Result<PairedTake> load_take(const Manifest::Take& take, std::vector<std::string>& warnings,
                             const Progress& progress) {
  PairedTake result;
  result.name = take.name;
  if (const Status loaded = load_performers(take, result, warnings, progress); !loaded) return loaded.error();
  if (const Status cut = cut_to_frames(take, result); !cut) return cut.error();
  if (const Status lengths = check_lengths(result); !lengths) return lengths.error();
  result.fps = result.a.fps;
  if (const Status roles = load_roles(take, result, warnings); !roles) return roles.error();
  if (const Status labels = load_labels(take, result, warnings); !labels) return labels.error();
  return result;
}

}  // namespace abrazo
