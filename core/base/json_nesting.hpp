#pragma once

#include <string_view>

namespace abrazo {

/// Whether brackets of a JSON text stand deeper inside each other than in anything this program reads. To be
/// asked before it is parsed: values are written, copied and compared by recursion, and the file decides how
/// deep.
bool nests_too_deep(std::string_view json);

/// What to say of such a text.
inline constexpr const char* too_deep_words =
    "has brackets more than 100 deep inside each other; it is damaged";

}  // namespace abrazo
