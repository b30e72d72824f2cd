#pragma once

#include <string>

#include "core/base/json_text.hpp"
#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo {

/// report.json as described in docs/guide/evaluation.md. Parts that were not requested are missing;
/// undefined values (a success rate of no moves) are null.
std::string report_json(const Evaluation& evaluation);

/// Ends the outermost object, with the settings as its last member.
std::string finished_with_settings(JsonText& json, const Settings& settings);

}  // namespace abrazo
