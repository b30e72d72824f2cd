#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/joint_map.hpp"

namespace abrazo::app {

/// "LASI", "0.5 LASI + 0.5 RASI".
QString in_words(const JointRule& rule);

/// What in_words writes, read back. Weights that are left out are equal; no words give a rule without terms.
/// @return an Error for a point the file does not have, or weights that do not add up to 1
Result<JointRule> rule_of_words(const QString& text, const std::vector<std::string>& points);

}  // namespace abrazo::app
