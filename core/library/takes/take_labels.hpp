#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/library/takes/tier.hpp"

namespace abrazo {

/// The tier of that name; without a name the first of that kind, the one named like the take, or the only
/// one.
/// @return an Error that lists the existing names
Result<const Tier*> tier_for_take(std::span<const Tier> tiers, std::string_view name, TierKind kind,
                                  std::string_view take, std::string_view where);

/// A label at its times, and back over the frames [start, end): the two places that know the fields of both.
TierInterval interval_of(const LabelInterval& label, double fps);
LabelInterval label_over(const TierInterval& interval, int start, int end);

/// A tier's values as labels of frames, rounded to the nearest. Omitted intervals are counted in `warnings`:
/// those shorter than a frame or before the first one, and those without a value.
std::vector<LabelInterval> labels_of(const Tier& tier, double fps, std::string_view where,
                                     std::vector<std::string>& warnings);

/// The same for roles. @return an Error for a value that is not a, b or unknown
Result<std::vector<RoleInterval>> roles_of(const Tier& tier, double fps, std::string_view where,
                                           std::vector<std::string>& warnings);

}  // namespace abrazo
