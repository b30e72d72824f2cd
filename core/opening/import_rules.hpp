#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/files/motion_reading.hpp"

namespace abrazo {

/// Where a project keeps how its motion is read: a key of Project::view.
inline constexpr const char* view_of_reading = "import";

/// What was said of how a motion is read, without file and skeleton. Only what is set is written.
std::string reading_json(const MotionReading& reading);
/// The text of reading_json. An Error names the entry that is not understood and what was expected.
Result<MotionReading> parse_reading(std::string_view json, std::string_view where);

/// "metres per unit 0.01, up z": what was said, for a list. Empty: as found.
std::string reading_words(const MotionReading& reading);

/// What a person said of a file, kept for files alike: those with the same layout, in the same folder or with
/// a name of the same pattern.
struct ImportRule {
  MotionReading how;         ///< without file and skeleton
  std::string layout;        ///< layout_of
  std::string folder;        ///< absolute
  std::string name_pattern;  ///< "walk_##.bvh"
  std::string path;          ///< file that keeps it; empty: not yet
};

/// Fingerprint of the points, stated unit and stated axis of a file. Files of one program and one set of
/// points have the same. Empty: nothing could be read.
std::string layout_of(const std::vector<NamedMotion>& motions);

/// The file's name with each run of digits as '#': "walk_#.bvh".
std::string name_pattern(const std::string& file);

/// The rule of a file that was read so.
ImportRule rule_of(const MotionReading& how, const std::string& layout);

struct StoredRules {
  std::vector<ImportRule> rules;  ///< by their names
  std::vector<Error> damaged;     ///< files that cannot be read as rules
};
StoredRules import_rules(const std::string& folder);

/// Of rules with the file's layout one of its folder, else one of its name's pattern; null when there is
/// none.
const ImportRule* rule_for(const std::vector<ImportRule>& rules, const std::string& file,
                           const std::string& layout);

/// Keeps a rule. One of the same layout and folder is replaced. @return its file
Result<std::string> remember_import(const ImportRule& rule, const std::string& folder);
Status forget_import(const std::string& path);

}  // namespace abrazo
