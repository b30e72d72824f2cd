#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// What reading a scene gave, as bytes between two processes of one machine and one version: numbers as they
/// stand in memory, so that they come over to the bit.
std::string scene_answer(const Result<std::vector<NamedMotion>>& motions);

/// The same again. The bytes may be anything: no memory is taken for more than they hold, and motions are
/// whole (parents before their children, as many rows as points).
/// @param file  that an error is about
/// @return nothing of `is_whole` when the bytes are no such answer
struct SceneAnswer {
  bool is_whole = false;
  Result<std::vector<NamedMotion>> motions = std::vector<NamedMotion>{};
};
SceneAnswer parse_scene_answer(std::string_view bytes, const std::string& file);

}  // namespace abrazo
