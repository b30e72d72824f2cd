#pragma once

#include <QString>

#include "core/session/run/comparison.hpp"
#include "widgets/compare/compare_panel.hpp"

namespace abrazo::app {

/// Text of the compare panel for A and B.
/// @param frozen_at_s  when A was frozen
/// @param shown comparison of the shown figures: names its settings, even while others are solved
widgets::CompareSides sides_of(const CompareSituation& now, double frozen_at_s, const Comparison* shown);

/// The frames behind the figures, and remarks.
QString note_of(const Comparison& comparison);

/// What to do if there is nothing to compare. @param tried the comparison without a result, or null
QString advice(const CompareSituation& now, const Comparison* tried);

}  // namespace abrazo::app
