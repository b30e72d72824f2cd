#include "core/library/takes/take_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

struct Frames {
  int start = 0, end = 0;
  bool is_cut = false;  ///< at the first frame
};

Frames frames_of(const TierInterval& interval, double fps) {
  const auto frame = [&](double time_s) {
    return static_cast<int>(std::clamp(std::round(time_s * fps), 0.0, static_cast<double>(INT_MAX)));
  };
  return {frame(interval.start_s), frame(interval.end_s), std::round(interval.start_s * fps) < 0};
}

/// What the frames of a take do not hold of a tier.
struct Lost {
  int left_out = 0, cut = 0;
};

void warn_of(const Lost& lost, const Tier& tier, std::string_view where, std::vector<std::string>& warnings) {
  const int count = lost.left_out;
  if (count > 0)
    warnings.push_back(
        fmt::format("{}: {} {} of tier {} left out: shorter than a frame, before the first one, "
                    "or without a value",
                    where, count, count == 1 ? "interval" : "intervals", in_quotes(tier.name)));
  if (lost.cut > 0)
    warnings.push_back(fmt::format("{}: {} of tier {} before the first frame and {} cut there", where,
                                   lost.cut == 1 ? "1 interval" : std::to_string(lost.cut) + " intervals",
                                   in_quotes(tier.name) + (lost.cut == 1 ? " begins" : " begin"),
                                   lost.cut == 1 ? "was" : "were"));
}

}  // namespace

Result<const Tier*> tier_for_take(std::span<const Tier> tiers, std::string_view name, TierKind kind,
                                  std::string_view take, std::string_view where) {
  std::string names;
  for (const Tier& tier : tiers) names += (names.empty() ? "" : ", ") + tier.name;
  const auto named = [&](std::string_view wanted) {
    return std::find_if(tiers.begin(), tiers.end(), [&](const Tier& tier) { return tier.name == wanted; });
  };
  if (!name.empty()) {
    if (const auto found = named(name); found != tiers.end()) return &*found;
    return Error{fmt::format("has no tier {}; it has {}", in_quotes(name), names.empty() ? "none" : names),
                 std::string(where)};
  }
  for (const Tier& tier : tiers)
    if (tier.kind == kind) return &tier;
  if (const auto found = named(take); found != tiers.end()) return &*found;
  if (tiers.size() == 1) return &tiers.front();
  return Error{fmt::format("does not say which tier is meant; name one with \"tier\": it has {}",
                           names.empty() ? "none" : names),
               std::string(where)};
}

TierInterval interval_of(const LabelInterval& label, double fps) {
  return {.start_s = label.start / fps,
          .end_s = label.end / fps,
          .value = label.label,
          .detail = label.detail,
          .confidence = label.confidence};
}

LabelInterval label_over(const TierInterval& interval, int start, int end) {
  return {.start = start,
          .end = end,
          .label = interval.value,
          .detail = interval.detail,
          .confidence = interval.confidence};
}

std::vector<LabelInterval> labels_of(const Tier& tier, double fps, std::string_view where,
                                     std::vector<std::string>& warnings) {
  std::vector<LabelInterval> labels;
  Lost lost;
  for (const TierInterval& one : tier.intervals) {
    const Frames frames = frames_of(one, fps);
    if (frames.end <= frames.start || one.value.empty())
      ++lost.left_out;
    else {
      lost.cut += frames.is_cut ? 1 : 0;
      labels.push_back(label_over(one, frames.start, frames.end));
    }
  }
  warn_of(lost, tier, where, warnings);
  return labels;
}

Result<std::vector<RoleInterval>> roles_of(const Tier& tier, double fps, std::string_view where,
                                           std::vector<std::string>& warnings) {
  std::vector<RoleInterval> roles;
  Lost lost;
  for (const TierInterval& one : tier.intervals) {
    const std::string value = lower_case(trimmed(one.value));
    if (value != "a" && value != "b" && value != "unknown" && !value.empty())
      return Error{
          fmt::format("{} at {:.3f} s is not a role; say a or b, the performer who is active there, or "
                      "unknown",
                      in_quotes(one.value), one.start_s),
          fmt::format("{}: tier {}", where, in_quotes(tier.name))};
    const Frames frames = frames_of(one, fps);
    if (frames.end <= frames.start || value.empty())
      ++lost.left_out;
    else if (value != "unknown") {
      lost.cut += frames.is_cut ? 1 : 0;
      roles.push_back({frames.start, frames.end, value == "a" ? ActivePerformer::A : ActivePerformer::B});
    }
  }
  warn_of(lost, tier, where, warnings);
  return roles;
}

}  // namespace abrazo
