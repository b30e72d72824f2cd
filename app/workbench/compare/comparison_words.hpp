#pragma once

#include <QString>

#include "core/session/run/comparison.hpp"
#include "widgets/compare/compare_panel.hpp"

namespace abrazo::app {

/// What the compare panel says about A and B.
/// @param frozen_at_s  when A was frozen
/// @param shown  whose figures stand beside the words: its settings are named, also while others are solved
widgets::CompareSides sides_of(const CompareSituation& now, double frozen_at_s, const Comparison* shown);

/// Over which frames the figures are, and what is to be known about them.
QString note_of(const Comparison& comparison);

/// What to do where there is nothing to compare. @param tried  the comparison that came to nothing, or null
QString advice(const CompareSituation& now, const Comparison* tried);

}  // namespace abrazo::app
