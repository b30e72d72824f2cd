#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/files/motion_reading.hpp"

namespace abrazo {

/// Key of Project::view under which a project stores how its motion is read.
inline constexpr const char* view_of_reading = "import";

/// How a motion is read, without file and skeleton. Only values that are set are written.
std::string reading_json(const MotionReading& reading);
/// The text of reading_json. An Error names the entry that is not understood and what was expected.
Result<MotionReading> parse_reading(std::string_view json, std::string_view where);

/// "metres per unit 0.01, up z": the values that are set, for a list. Empty: none.
std::string reading_words(const MotionReading& reading);

/// A person's choices about how to read a file, kept for similar files: those with the same layout, in the
/// same folder or with a name of the same pattern.
struct ImportRule {
  MotionReading how;         ///< without file and skeleton
  std::string layout;        ///< layout_of
  std::string folder;        ///< absolute
  std::string name_pattern;  ///< "walk_##.bvh"
  std::string path;          ///< file in which it is stored; empty: none yet
};

/// Fingerprint of the points, stated unit and stated axis of a file. Files of one program and one set of
/// points have the same. Empty: nothing could be read.
std::string layout_of(const std::vector<NamedMotion>& motions);

/// The file's name with each run of digits as '#': "walk_#.bvh".
std::string name_pattern(const std::string& file);

/// The rule for a file that was read in this way.
ImportRule rule_of(const MotionReading& how, const std::string& layout);

struct StoredRules {
  std::vector<ImportRule> rules;  ///< by their names
  std::vector<Error> damaged;     ///< files that cannot be read as rules
};
StoredRules import_rules(const std::string& folder);

/// Of the rules with the file's layout, the one for its folder, otherwise one for the pattern of its name;
/// null if there is none.
const ImportRule* rule_for(const std::vector<ImportRule>& rules, const std::string& file,
                           const std::string& layout);

/// Stores a rule and replaces one with the same layout and folder. @return its file
Result<std::string> remember_import(const ImportRule& rule, const std::string& folder);
Status forget_import(const std::string& path);

}  // namespace abrazo
