#pragma once

#include <array>
#include <memory>

#include "core/motion/scenes/worn_character.hpp"

namespace abrazo::widgets {

/// Characters of other programs as the skins of the pair, active then passive; null = capsules.
using WornPair = std::array<std::shared_ptr<const WornCharacter>, 2>;

}  // namespace abrazo::widgets
