#pragma once

#include <string_view>

#include "core/base/result.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo {

/// Whether a table is one of ELAN's exports: it has the titles, or in all rows begin, end and duration, or
/// times of a clock. Two columns of numbers may as well be frames.
bool is_elan_table(std::string_view text);

/// Tiers from a table with a row for each annotation, separated by tabs or as CSV: what ELAN exports (File >
/// Export As > Tab-delimited Text), and label tracks of Audacity.
///
/// With titles, columns are found by them; without an "Annotation" each title that is no other is a tier.
/// Without titles, columns are found by what all their cells hold: the longest block of begin, end and
/// duration (or two of them), each in the same forms, whose values agree; before it the tier, behind it the
/// annotation. Participants, descriptions of vocabularies, names of files and lines about media are not read.
/// Times are hours:minutes:seconds, seconds, milliseconds, or SMPTE frames if the titles say that they are
/// PAL. Annotations of a tier are ordered by their begin; those without length are left out and counted.
/// @return an Error with the line, and for what the cells cannot tell: export with titles
Result<TierDocument> parse_elan_table(std::string_view text, std::string_view where);

}  // namespace abrazo
