#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/session/frames/decisions.hpp"

namespace abrazo {

/// {"pinned":33,"vetoes":{"pairs":[],"takes":[],"labels":[]},"meant":{"label":...,"take":...,"until_s":...},
/// "role_control":"hand"}; undecided values are null.
std::string decisions_json(const Decisions& decisions);

/// Reads decisions_json; a missing member is undecided.
Result<Decisions> parse_decisions(std::string_view json, std::string_view where);

}  // namespace abrazo
