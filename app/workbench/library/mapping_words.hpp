#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/joint_map.hpp"

namespace abrazo::app {

/// "LASI", "0.5 LASI + 0.5 RASI".
QString in_words(const JointRule& rule);

/// Parses the text of in_words. Omitted weights are equal; an empty text gives a rule without terms.
/// @return an Error for an unknown point, or weights that do not sum to 1
Result<JointRule> rule_of_words(const QString& text, const std::vector<std::string>& points);

}  // namespace abrazo::app
