#include "core/session/export/session_tiers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/library/takes/csv_text.hpp"

namespace abrazo {

namespace {

/// Frames further apart than this do not belong to one interval: nothing was solved in between.
constexpr double longest_pause_s = 0.3;
constexpr double marker_s = 1e-3;

/// Values of frames over their times.
struct FrameValues {
  std::vector<double> times_s;
  std::vector<std::string> values;  ///< empty = none

  /// Neighbours of the same value as one interval. A frame lasts until the next one; the last one, and one
  /// before a pause, as long as most do.
  std::vector<TierInterval> intervals() const;
  double usual_interval_s() const;
};

double FrameValues::usual_interval_s() const {
  std::vector<double> all;
  for (std::size_t i = 1; i < times_s.size(); ++i)
    if (times_s[i] > times_s[i - 1]) all.push_back(times_s[i] - times_s[i - 1]);
  return percentile(std::move(all), 0.5);
}

std::vector<TierInterval> FrameValues::intervals() const {
  const double usual_s = usual_interval_s();
  std::vector<TierInterval> found;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const bool continues = i + 1 < times_s.size() && times_s[i + 1] - times_s[i] <= longest_pause_s;
    const double end_s = continues ? std::max(times_s[i + 1], times_s[i]) : times_s[i] + usual_s;
    if (values[i].empty()) continue;
    if (!found.empty() && found.back().value == values[i] && found.back().end_s >= times_s[i])
      found.back().end_s = std::max(found.back().end_s, end_s);
    else
      found.push_back({times_s[i], end_s, values[i]});
  }
  return found;
}

/// What the frames of a range followed.
struct Followed {
  FrameValues moves, takes;
};

Result<Followed> followed_in(const SessionRecord& session, double from_s, double to_s) {
  Followed followed;
  const Status looked = session.each_source(from_s, to_s, [&](const SessionSource& source) -> Status {
    for (FrameValues* values : {&followed.moves, &followed.takes}) values->times_s.push_back(source.time_s);
    followed.moves.values.push_back(source.label);
    followed.takes.values.push_back(source.take);
    return Done{};
  });
  if (!looked) return looked.error();
  return followed;
}

/// Values that are in force from a time on, until the next or the end.
std::vector<TierInterval> in_force(std::vector<std::pair<double, std::string>> changes, double end_s) {
  std::vector<TierInterval> intervals;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const double until_s = i + 1 < changes.size() ? changes[i + 1].first : end_s;
    if (changes[i].second.empty()) continue;
    if (!intervals.empty() && intervals.back().value == changes[i].second &&
        intervals.back().end_s == changes[i].first)
      intervals.back().end_s = until_s;
    else
      intervals.push_back({changes[i].first, until_s, changes[i].second});
  }
  return intervals;
}

Tier take_tier(const SessionContents& contents) {
  Tier tier{"take", {}, {}};
  for (const SessionTake& take : contents.takes)
    tier.intervals.push_back({take.start_s, take.end_s, take.name});
  return tier;
}

Tier role_tier(const SessionContents& contents, double end_s) {
  std::vector<std::pair<double, std::string>> changes;
  for (const SessionSettings& change : contents.settings)
    changes.emplace_back(change.time_s,
                         change.settings.user_role == UserRole::Passive ? "passive" : "active");
  return {"user role", in_force(std::move(changes), end_s), {{"active"}, {"passive"}}, TierKind::Note};
}

Tier meant_tier(const SessionContents& contents, double end_s) {
  std::vector<std::pair<double, std::string>> changes;
  for (const SessionDecisions& change : contents.decisions) {
    const auto& meant = change.decisions.meant;
    changes.emplace_back(change.time_s, !meant         ? ""
                                        : meant->label ? *meant->label
                                        : meant->take  ? "take " + *meant->take
                                                       : "");
  }
  return {"meant", in_force(std::move(changes), end_s), {}};
}

Tier marker_tier(const SessionContents& contents) {
  Tier tier{"marker", {}, {}};
  for (const SessionMarker& marker : contents.markers) {
    const double free_s = tier.intervals.empty() ? 0 : tier.intervals.back().end_s;
    const double start_s = std::max(marker.time_s, free_s);
    tier.intervals.push_back(
        {start_s, start_s + marker_s, marker.name.empty() ? std::to_string(marker.id) : marker.name});
  }
  return tier;
}

/// Takes within a range; the whole range under the name of the session when it has none.
std::vector<SessionTake> takes_in(const SessionRecord& session, const SessionRange& range) {
  std::vector<SessionTake> takes;
  for (SessionTake take : session.contents().takes) {
    if (take.end_s < range.from_s || take.start_s > range.to_s) continue;
    take.start_s = std::max(take.start_s, range.from_s);
    take.end_s = std::min(take.end_s, range.to_s);
    takes.push_back(std::move(take));
  }
  if (!takes.empty()) return takes;
  SessionTake whole;
  whole.name = std::filesystem::path(session.where()).stem().string();
  whole.start_s = range.from_s;
  whole.end_s = range.to_s;
  return {whole};
}

/// The first annotated tier of moves; null if it is empty.
const Tier* annotated_moves(const SessionContents& contents) {
  for (const Tier& tier : contents.annotations)
    if (tier.kind == TierKind::Move) return tier.intervals.empty() ? nullptr : &tier;
  return nullptr;
}

/// The moves of a session, take by take, as lines of a label file.
class LabelLines {
 public:
  explicit LabelLines(const SessionContents& contents) : contents_(contents) {
    const Tier* moves = annotated_moves(contents);
    if (moves) noted_ = *moves;
    goes_in_.resize(noted_.intervals.size());
  }
  void add(const std::string& take, const FrameValues& followed, double rate_hz);
  TierText finished(const SessionRange& range) &&;

 private:
  bool add_line(const std::string& take, long long start, long long end, const TierInterval& move);

  const SessionContents& contents_;
  Tier noted_;                 ///< without intervals: those that were followed are written
  std::vector<char> goes_in_;  ///< per interval of it
  std::size_t followed_ = 0, followed_left_out_ = 0;
  TierText csv_{"take,start_frame,end_frame,label,detail,confidence\n", {}};
};

bool LabelLines::add_line(const std::string& take, long long start, long long end, const TierInterval& move) {
  if (end <= start || move.value.empty()) return false;
  csv_.text += fmt::format("{},{},{},{},{},{}\n", csv_field(take), start, end, csv_field(move.value),
                           csv_field(move.detail), csv_field(move.confidence));
  return true;
}

void LabelLines::add(const std::string& take, const FrameValues& followed, double rate_hz) {
  const double first_s = followed.times_s.front();
  const auto frames = std::floor((followed.times_s.back() - first_s) * rate_hz + 1e-6) + 1;
  // The frame at or after a time; a stamp a nanosecond late is still in time.
  const auto frame_at = [&](double time_s) {
    return static_cast<long long>(std::clamp(std::ceil((time_s - first_s) * rate_hz - 1e-3), 0.0, frames));
  };
  for (std::size_t i = 0; i < noted_.intervals.size(); ++i) {
    const TierInterval& move = noted_.intervals[i];
    if (add_line(take, frame_at(move.start_s), frame_at(move.end_s), move)) goes_in_[i] = 1;
  }
  if (!noted_.intervals.empty()) return;
  for (const TierInterval& move : followed.intervals()) {
    ++followed_;
    if (!add_line(take, frame_at(move.start_s), frame_at(move.end_s), move)) ++followed_left_out_;
  }
}

TierText LabelLines::finished(const SessionRange& range) && {
  std::size_t all = followed_, left_out = followed_left_out_, other_tiers = 0;
  for (std::size_t i = 0; i < noted_.intervals.size(); ++i) {
    const TierInterval& move = noted_.intervals[i];
    if (move.end_s <= range.from_s || move.start_s > range.to_s) continue;
    ++all;
    left_out += goes_in_[i] == 0 ? 1 : 0;
  }
  if (left_out > 0)
    csv_.warnings.push_back(fmt::format(
        "{} of {} moves were left out: shorter than a frame, outside of the takes, or without a label",
        left_out, all));
  for (const Tier& tier : contents_.annotations)
    other_tiers += !tier.intervals.empty() && tier.name != noted_.name ? 1 : 0;
  if (other_tiers > 0)
    csv_.warnings.push_back(fmt::format(
        "a label file holds one tier, here {}; {} left out",
        noted_.name.empty() ? "the moves that were followed" : in_quotes(noted_.name), other_tiers));
  return std::move(csv_);
}

}  // namespace

std::vector<TierInterval> intervals_within(std::vector<TierInterval> intervals, double from_s, double to_s) {
  std::erase_if(intervals,
                [&](const TierInterval& one) { return one.end_s <= from_s || one.start_s >= to_s; });
  for (TierInterval& one : intervals) {
    one.start_s = std::max(one.start_s, from_s);
    one.end_s = std::min(one.end_s, to_s);
  }
  return intervals;
}

Result<std::vector<Tier>> session_tiers(const SessionRecord& session, const SessionRange& range) {
  const SessionContents& contents = session.contents();
  const auto followed = followed_in(session, range.from_s, range.to_s);
  if (!followed) return followed.error();
  const double end_s = range.to_s + followed->moves.usual_interval_s();
  std::vector<Tier> tiers = {
      take_tier(contents), role_tier(contents, end_s), {"move followed", followed->moves.intervals(), {}}};
  const std::size_t always = tiers.size();
  tiers.push_back({"take followed", followed->takes.intervals(), {}});
  tiers.push_back(meant_tier(contents, end_s));
  tiers.push_back(marker_tier(contents));
  const std::size_t known = tiers.size();
  for (Tier tier : contents.annotations) {
    const auto same =
        std::find_if(tiers.begin(), tiers.end(), [&](const Tier& one) { return one.name == tier.name; });
    if (same != tiers.end()) tier.name += " (annotated)";
    tiers.push_back(std::move(tier));
  }
  std::vector<Tier> kept;
  for (std::size_t i = 0; i < tiers.size(); ++i) {
    tiers[i].intervals = intervals_within(std::move(tiers[i].intervals), range.from_s, end_s);
    if (tiers[i].vocabulary.empty() && tiers[i].name != "marker" && i < known)  // free text stays so
      tiers[i].vocabulary = vocabulary_of(tiers[i].intervals);
    if (i < always || !tiers[i].intervals.empty()) kept.push_back(std::move(tiers[i]));
  }
  return kept;
}

Result<TierText> session_labels_csv(const SessionRecord& session, const SessionRange& range, double rate_hz) {
  LabelLines lines(session.contents());
  for (const SessionTake& take : takes_in(session, range)) {
    const auto followed = followed_in(session, take.start_s, take.end_s);
    if (!followed) return followed.error();
    const FrameValues& moves = followed->moves;
    if (moves.times_s.empty()) continue;
    const double usual_s = moves.usual_interval_s();
    const double rate = rate_hz > 0 ? rate_hz : usual_s > 0 ? even_rate(1 / usual_s) : 0;
    if (rate <= 0) return Error{"a single frame has no rate; give one, or a longer part", session.where()};
    lines.add(take.name, moves, rate);
  }
  return std::move(lines).finished(range);
}

}  // namespace abrazo
