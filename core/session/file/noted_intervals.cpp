#include "core/session/file/noted_intervals.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

/// A tier of roles has only "a" and "b"; with other values it is a tier of notes.
TierKind kind_of(const Tier& tier, const std::string& kind) {
  if (kind == "move" || kind == "label") return TierKind::Move;
  const auto is_role = [](const TierInterval& one) { return one.value == "a" || one.value == "b"; };
  return kind == "role" && std::ranges::all_of(tier.intervals, is_role) ? TierKind::Role : TierKind::Note;
}

void add(std::vector<Tier>& tiers, const std::string& kind, TierInterval interval) {
  for (int copy = 1;; ++copy) {
    const std::string name = kind + (copy > 1 ? " " + std::to_string(copy) : "");
    auto tier = std::ranges::find(tiers, name, &Tier::name);
    if (tier == tiers.end()) tier = tiers.insert(tiers.end(), Tier{name, {}});
    if (!tier->intervals.empty() && tier->intervals.back().end_s > interval.start_s) continue;
    tier->intervals.push_back(std::move(interval));
    tier->kind = kind_of(*tier, kind);
    return;
  }
}

}  // namespace

std::vector<Tier> noted_intervals(SessionDatabase& database, std::vector<std::string>& damage) {
  std::vector<Tier> tiers;
  const auto damaged = [&](const std::string& why) {
    damage.push_back("not all of its intervals can be read: " + why);
    return tiers;
  };
  auto rows = database.prepare(
      "SELECT kind, start_s, end_s, name, coalesce(detail, ''), coalesce(confidence, '') "
      "FROM intervals ORDER BY start_s, id");
  if (!rows) return damaged(rows.error().message);
  while (true) {
    const auto row = rows->step();
    if (!row) return damaged(row.error().message);
    if (!*row) return tiers;
    TierInterval interval{rows->real(1), rows->real(2), rows->text(3), rows->text(4), rows->text(5)};
    const std::string kind = rows->text(0);
    if (kind.empty() || !std::isfinite(interval.start_s) || !std::isfinite(interval.end_s) ||
        interval.end_s <= interval.start_s)
      return damaged("'" + interval.value + "' has no kind, or does not end after it begins");
    add(tiers, kind, std::move(interval));
  }
}

}  // namespace abrazo
