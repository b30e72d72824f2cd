#include "widgets/library/take_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text.hpp"

namespace abrazo::widgets {
namespace {

/// Annotated intervals, with gaps as unknown.
std::vector<TakeRow::Role> roles_of(const LibraryTake& take) {
  const double frames = std::max(1, take.frames);
  std::vector<TakeRow::Role> roles;
  int from = 0;
  const auto add = [&](int end, ActivePerformer active) {
    end = std::min(end, take.frames);
    if (end > from) roles.push_back({from / frames, end / frames, active});
    from = std::max(from, end);
  };
  for (const RoleInterval& role : take.roles) {
    add(role.start, ActivePerformer::Unknown);
    add(role.end, role.active);
  }
  add(take.frames, ActivePerformer::Unknown);
  return roles;
}

std::string leader_of(const std::vector<TakeRow::Role>& roles) {
  double share_a = 0, share_b = 0;
  for (const TakeRow::Role& role : roles) {
    if (role.active == ActivePerformer::A) share_a += role.to - role.from;
    if (role.active == ActivePerformer::B) share_b += role.to - role.from;
  }
  const auto percent = [](double share) { return std::to_string(std::lround(100 * share)) + " %"; };
  if (share_a > 0.995) return "A leads";
  if (share_b > 0.995) return "B leads";
  if (share_a + share_b < 0.005) return "either leads";
  if (share_b < 0.005) return "A leads " + percent(share_a);
  if (share_a < 0.005) return "B leads " + percent(share_b);
  return "A leads " + percent(share_a) + ", B " + percent(share_b);
}

std::string plain(std::string_view text) {
  std::string plain = lower_case(text);
  std::replace(plain.begin(), plain.end(), '_', ' ');
  return plain;
}

}  // namespace

std::vector<TakeRow> take_rows(const MotionLibrary& library) {
  std::vector<TakeRow> rows;
  for (std::size_t t = 0; t < library.takes().size(); ++t) {
    const LibraryTake& take = library.takes()[t];
    TakeRow row;
    row.take = static_cast<int>(t);
    row.name = take.name;
    row.frames = take.frames;
    row.fps = take.fps;
    row.seconds = take.fps > 0 ? take.frames / take.fps : 0;
    std::set<std::string> labels;
    const double frames = std::max(1, take.frames);
    for (const LabelInterval& label : take.labels) {
      if (label.start >= take.frames) continue;
      row.moves.push_back({label.start / frames, std::min(label.end, take.frames) / frames, label.label});
      labels.insert(label.label);
    }
    row.labels.assign(labels.begin(), labels.end());
    row.roles = roles_of(take);
    row.leader = leader_of(row.roles);
    rows.push_back(std::move(row));
  }
  return rows;
}

bool matches(const TakeRow& row, const std::string& filter) {
  std::string all = plain(row.name);
  for (const std::string& label : row.labels) all += "\n" + plain(label);
  const std::string wanted = plain(filter);
  const auto words = split_words(wanted);
  return std::all_of(words.begin(), words.end(),
                     [&](std::string_view word) { return all.find(word) != std::string::npos; });
}

PairsOfTakes::PairsOfTakes(const MotionLibrary& library) {
  for (const LibraryTake& take : library.takes()) {
    const int stride = std::max(1, take.frame_stride);
    takes_.push_back(
        {stride, std::vector<int>(static_cast<std::size_t>((take.frames + stride - 1) / stride), -1)});
  }
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    Take& take = takes_[source.take];
    const std::size_t kept = source.frame / static_cast<std::size_t>(take.stride);
    // Pairs with performer A active come first in a take and have priority.
    if (kept < take.pairs.size() && take.pairs[kept] < 0) take.pairs[kept] = pair;
  }
}

int PairsOfTakes::pair_at(int take, int frame) const {
  if (take < 0 || take >= static_cast<int>(takes_.size())) return -1;
  const Take& of = takes_[static_cast<std::size_t>(take)];
  if (of.pairs.empty()) return -1;
  const int kept = std::clamp((frame + of.stride / 2) / of.stride, 0, static_cast<int>(of.pairs.size()) - 1);
  return of.pairs[static_cast<std::size_t>(kept)];
}

}  // namespace abrazo::widgets
