#pragma once

#include "core/base/progress.hpp"
#include "core/opening/material.hpp"

namespace abrazo {

/// A minute of generated dance, and a leader whom the library has not seen. Made once in a program: later calls give the same library.
Result<Material> generated_dance(const Progress& progress);

/// A minute of generated sparring, and a fighter whom the library has not seen. Made once, too.
Result<Material> generated_fight(const Progress& progress);

using GenerateMaterial = Result<Material> (*)(const Progress&);
/// What generates the library of this name; null when it is none that can be generated.
GenerateMaterial generated_of_name(const std::string& library);

}  // namespace abrazo
