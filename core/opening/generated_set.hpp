#pragma once

#include "app/workbench/document/material.hpp"

namespace abrazo::app {

/// A minute of generated dance, and a leader whom the library has not seen.
Result<Material> make_demo(const Progress& progress);

/// A minute of generated sparring, and a fighter whom the library has not seen.
Result<Material> make_fight(const Progress& progress);

}  // namespace abrazo::app
