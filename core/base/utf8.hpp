#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace abrazo {

/// Byte of the first character that is not UTF-8 (RFC 3629: shortest forms, no surrogates, up to U+10FFFF);
/// nothing when all are.
std::optional<std::size_t> first_broken_byte(std::string_view text);

}  // namespace abrazo
