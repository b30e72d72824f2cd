#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/library/takes/eaf_contents.hpp"
#include "core/library/takes/tier.hpp"

namespace abrazo {

/// Metadata of an annotation document.
struct EafFacts {
  std::string author;
  std::string date;  ///< xsd:dateTime, "2026-11-21T20:15:00Z"
};

/// Tiers as an ELAN annotation document (EAF 3.0, XML), with a controlled vocabulary for every tier that has
/// one. Times are whole milliseconds: adjacent intervals stay adjacent, and an interval that rounds to length
/// 0 gets the next millisecond. Detail and confidence become child tiers ("move detail", one to one with
/// theirs); kinds, colours and keys, which EAF cannot express, become a property of the document that ELAN
/// preserves.
/// @return an Error for what EAF cannot express: two tiers of one name, overlapping or reversed intervals,
/// times before 0 or beyond 2^32 ms, characters that XML does not have
Result<std::string> write_eaf(std::span<const Tier> tiers, const EafFacts& facts);

/// Parses an ELAN document (EAF 2.0 to 3.0). A DOCTYPE is refused: nothing is fetched or expanded.
Result<EafContents> parse_eaf(std::string_view text, std::string_view where);

}  // namespace abrazo
