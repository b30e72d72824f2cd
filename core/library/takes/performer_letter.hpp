#pragma once

#include <string_view>
#include <vector>

#include "core/base/json_text.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// "a", "b" or "unknown", as in manifests and label files.
constexpr std::string_view letter_of(ActivePerformer active) {
  return active == ActivePerformer::A ? "a" : active == ActivePerformer::B ? "b" : "unknown";
}

/// [{"start": 0, "end": 120, "active": "a"}, ...], as in manifests.
inline void write_role_list(JsonText& json, const std::vector<RoleInterval>& roles) {
  json.begin_array();
  for (const RoleInterval& role : roles)
    json.begin_object()
        .key("start")
        .value(role.start)
        .key("end")
        .value(role.end)
        .key("active")
        .value(letter_of(role.active))
        .end_object();
  json.end_array();
}

}  // namespace abrazo
