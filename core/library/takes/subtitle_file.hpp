#pragma once

#include <span>
#include <string_view>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo {

enum class SubtitleForm {
  WebVtt,  ///< W3C WebVTT: "<v move>basic", cue identifier "move 3"
  SubRip   ///< .srt: "[move] basic"
};

/// Cues as intervals. Tier = voice of the cue, or the text in brackets before its value; cues without one
/// belong to the tier "subtitles". Settings, styles, notes and markup are ignored. Cues that overlap others
/// of their tier go to additional tiers, "name 2" and so on.
Result<TierDocument> parse_subtitles(std::string_view text, std::string_view where, SubtitleForm form);

/// All intervals in order of time, in whole milliseconds. Kinds, vocabularies, detail, confidence and empty
/// tiers are not written.
/// @return an Error for times before 0 and names that cannot be distinguished from the text
Result<TierText> write_subtitles(std::span<const Tier> tiers, std::string_view where, SubtitleForm form);

}  // namespace abrazo
