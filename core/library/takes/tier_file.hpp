#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"

namespace abrazo {

/// The content of a label file.
struct TierDocument {
  std::vector<Tier> tiers;
  std::string take;                   ///< take of a label file; empty in other formats
  std::vector<std::string> warnings;  ///< omitted, interpolated or moved items, with counts
};

struct TierReading {
  /// Frame rate of the subject. Required for label files in frames; edges in whole milliseconds that match a
  /// frame are moved to it exactly. 0 = unknown
  double fps = 0;
  std::string take;  ///< take of a label file with several; empty = the only one
};

struct TierWriting {
  double fps = 0;    ///< of a label file's frames
  std::string take;  ///< its name in a label file; empty = CSV in seconds
  std::string author = "abrazo";
  std::string date = "1970-01-01T00:00:00Z";  ///< UTC, of an .eaf
};

/// Text of a file, and warnings about content that the format cannot hold.
struct TierText {
  std::string text;
  std::vector<std::string> warnings;
};

/// ".eaf", ".csv", ".json", ".TextGrid", ".txt"
const std::vector<std::string>& tier_file_extensions();
/// Whether the name ends in one of these, in any case.
bool is_tier_file(std::string_view name);

/// Tiers from a file of these formats:
///   .eaf   ELAN 2.0 to 3.0: alignable and reference annotations, vocabularies, units; see eaf_file.hpp
///   .csv   with a header tier,start,end,value[,detail,confidence] in seconds; else the label file
///          take,start_frame,end_frame,label[,detail,confidence] of one take as the tier "move"; or ELAN's
///   .txt   tables that ELAN exports, and label tracks of Audacity: see elan_text.hpp
///   .TextGrid  of Praat: see text_grid.hpp
///   .json  see tiers_json
/// Tiers without a kind in the file get that of their name: see kind_of_name. At most 64 MB and a million
/// intervals.
/// @param name  gives the format by its extension, and the place in messages
/// @return an Error with line or place, what was expected and what to change
Result<TierDocument> parse_tiers(std::string_view text, const std::string& name, const TierReading& reading);
Result<TierDocument> read_tiers(const std::filesystem::path& file, const TierReading& reading);

/// Tiers in the format of the extension; .txt is a label track of Audacity, of one tier. CSV in seconds, JSON
/// and TextGrids read back to the same doubles, .eaf to whole milliseconds, .txt to microseconds.
/// Vocabularies and kinds are kept by .eaf and .json, detail and confidence also by CSV; empty tiers by all
/// but CSV and .txt.
/// @param name  gives the format, and the place in messages
Result<TierText> write_tiers(std::span<const Tier> tiers, const std::string& name,
                             const TierWriting& writing);

}  // namespace abrazo
