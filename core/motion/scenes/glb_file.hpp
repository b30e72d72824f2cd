#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

/// Content of a binary glTF 2.0 file: its JSON, with a list of nodes, and the bytes of its first buffer.
struct GlbFile {
  nlohmann::json json;
  std::string binary;
};

/// @param where  the file's name, for messages
Result<GlbFile> parse_glb(std::string_view bytes, const std::string& where);

/// The bytes of the file; an Error if it is longer than the format allows.
Result<std::string> glb_text(const GlbFile& glb, const std::string& where);

}  // namespace abrazo
