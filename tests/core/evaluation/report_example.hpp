#pragma once

#include "core/evaluation/tables/evaluation.hpp"

namespace abrazo::test {

/// An evaluation with every part, of plausible made-up figures that are all different.
Evaluation example_evaluation();

}  // namespace abrazo::test
