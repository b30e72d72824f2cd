#include "core/library/takes/tier_kind.hpp"

#include <array>

namespace abrazo {

namespace {
constexpr std::array<std::string_view, 3> texts = {"role", "move", "note"};
}

std::string_view text_of(TierKind kind) {
  return texts[static_cast<std::size_t>(kind)];
}

std::optional<TierKind> parse_tier_kind(std::string_view text) {
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (texts[i] == text) return static_cast<TierKind>(i);
  return std::nullopt;
}

}  // namespace abrazo
