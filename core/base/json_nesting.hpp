#pragma once

#include <string_view>

namespace abrazo {

/// Whether a JSON text is nested deeper than anything this program reads. Check it before parsing: values are
/// written, copied and compared by recursion, to a depth set by the file.
bool nests_too_deep(std::string_view json);

/// Message for such a text.
inline constexpr const char* too_deep_words =
    "has brackets more than 100 deep inside each other; it is damaged";

}  // namespace abrazo
