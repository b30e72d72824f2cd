#pragma once

#include <string>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/motion/body/body.hpp"
#include "core/motion/body/body_choice.hpp"

namespace abrazo {

/// The body of a choice, with its name for messages.
struct ChosenBody {
  Body body;
  std::string name;  ///< "library", "scale:0.85", "walk.bvh"
};

/// The body of a choice for a character whose recorded body is known. Reads and measures a file. An Error if
/// the file cannot be read, has several performers or no plausible one, or if the choice is `user`: a
/// recorded pair has no user.
Result<ChosenBody> choose_body(const BodyChoice& choice, const Body& recorded, const Progress& progress = {});

/// Reads and measures the file of a choice, unless that was done; other choices stay as they are.
Status measure_file(BodyChoice& choice, const Progress& progress = {});

}  // namespace abrazo
