#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace abrazo {

/// Offset of the first invalid UTF-8 character (RFC 3629: shortest forms, no surrogates, up to U+10FFFF);
/// none if all are valid.
std::optional<std::size_t> first_broken_byte(std::string_view text);

}  // namespace abrazo
