#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace abrazo {

/// Offset of the first invalid UTF-8 character (RFC 3629: shortest forms, no surrogates, up to U+10FFFF);
/// none if all are valid.
std::optional<std::size_t> first_broken_byte(std::string_view text);

/// Text of a file in UTF-8, or in UTF-16 with a byte order mark, as UTF-8 without a mark; none if it is
/// neither.
std::optional<std::string> utf8_of(std::string_view bytes);

}  // namespace abrazo
